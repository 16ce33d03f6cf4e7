#pragma once

#include <filesystem>
#include <string>

#include "base/result.hpp"
#include "experiment/experiment.hpp"
#include "measurement/recording.hpp"
#include "mesh/surface_mesh.hpp"

namespace myo::experiment {

/// A recording to be added to an experiment as a trial.
struct NewTrial {
    std::string name;  // unique in the experiment, valid as a file name
    TrialRole role = TrialRole::fit;
    StartState start = StartState::straight;
    measurement::Recording
        recording;       // mesh frame, t = 0 at the start, under the declared names; samples before the start are kept
    std::string origin;  // source of the recording in one line; written as a comment
};

/// Adds a trial to an experiment folder: samples to `<name>.csv`, declaration appended to experiment.toml.
///
/// @param folder  directory of an existing experiment
/// @param declaration  text to which the trial is added, in place of that of experiment.toml; null: the file's
/// Errors: the name is taken or is no file name; the folder cannot be written; those of read_experiment. After an error
/// the folder is unchanged.
Result<void> add_trial(const std::filesystem::path& folder, const NewTrial& trial,
                       const std::string* declaration = nullptr);

/// Creates an experiment folder with one trial. Body, clamp, supports, material, gravity and markers are taken from
/// `declared`; its muscles, effects and trials are not written, nor are chambers, tendons, parts, obstacles, sensors
/// and limits: it serves bodies of a mesh alone. An experiment folder keeps all its tables in copy_experiment() and
/// add_trial(). The markers are compared by displacement.
///
/// @param folder   new or empty directory
/// @param surface  closed surface [m], mesh frame; written as body.stl
/// Errors: the folder is not empty; those of add_trial.
Result<void> write_experiment(const std::filesystem::path& folder, const Experiment& declared,
                              const mesh::SurfaceMesh& surface, const NewTrial& trial);

/// Creates an experiment folder with one trial that is only simulated: "release", one second, from the rest shape.
/// Body, clamp, supports, material and gravity are taken from `declared`, as in write_experiment().
///
/// Errors: the folder is not empty, or cannot be written; nothing holds the body, or what is declared cannot be read
/// for another reason. After an error the folder is unchanged.
Result<void> write_planned_experiment(const std::filesystem::path& folder, const Experiment& declared,
                                      const mesh::SurfaceMesh& surface);

/// Copies an experiment folder with all its files.
///
/// @param to  new or empty directory outside `from`
/// Errors: `to` is not empty or lies inside `from`; the copy fails (what was copied is removed).
Result<void> copy_experiment(const std::filesystem::path& from, const std::filesystem::path& to);

}  // namespace myo::experiment
