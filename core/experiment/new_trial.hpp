#pragma once

#include <filesystem>
#include <string>

#include "base/result.hpp"
#include "experiment/experiment.hpp"
#include "measurement/recording.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::experiment {

/// A recording that is to become a trial of an experiment.
struct NewTrial {
    std::string name;
    TrialRole role = TrialRole::fit;
    StartState start = StartState::straight;
    measurement::Recording
        recording;       // mesh frame, t = 0 at the start, under the declared names; samples before the start are kept
    std::string origin;  // where it comes from, one line; becomes a comment
};

/// Adds a trial to an experiment folder: its samples as `<name>.csv`, its declaration at the end of experiment.toml.
/// What it says must read as an experiment, or nothing is changed.
///
/// Errors: the name is taken or no file name; the folder cannot be written; those of read_experiment.
Result<void> add_trial(const std::filesystem::path& folder, const NewTrial& trial);

/// A new folder with body, clamp, material, gravity and markers of an experiment without muscles, effects and trials of
/// its own, and one trial. The body is written as body.stl [m]. Displacements are compared, as recordings of motion
/// capture call for.
///
/// Errors: the folder holds something already; those of add_trial.
Result<void> write_experiment(const std::filesystem::path& folder, const Experiment& declared,
                              const mesh::SurfaceMesh& surface, const NewTrial& trial);

/// Copies an experiment folder with everything in it to where nothing is yet.
Result<void> copy_experiment(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace myo::experiment
