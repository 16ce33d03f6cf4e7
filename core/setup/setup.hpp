#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "dynamics/simulate.hpp"
#include "experiment/experiment.hpp"
#include "measurement/observe.hpp"
#include "measurement/recording.hpp"
#include "measurement/rigid_motion.hpp"
#include "model/model.hpp"
#include "setup/body_mesh.hpp"
#include "setup/integration_check.hpp"
#include "setup/trial_step.hpp"

namespace myo::setup {

/// How the experiment is to be simulated; what is left open is chosen for the data.
struct SetupSettings {
    MeshRequest mesh;
    dynamics::Integrator integrator = dynamics::Integrator::tr_bdf2;
    double spectral_radius = 0.5;  // of generalized_alpha at infinite frequency, 0 ... 1
    dynamics::Strategy strategy = dynamics::Strategy::automatic;
    std::optional<double> h_s;            // default: half the sampling interval, until choose_steps()
    std::optional<std::string> material;  // id; default: the declared one
    double velocity_force_1_s = 0.0;      // Lambda
    model::MassModel mass_model = model::MassModel::consistent;
    /// Where none is declared: 9 % of critical damping at 10 Hz, as silicones have, and at most that part of it in the
    /// first vibration of faster bodies, which would creep instead of swinging.
    double assumed_damping_s = 0.003, most_assumed_damping_ratio = 0.09;
    bool as_published = false;  // it started from published_settings()
    bool fine_element = false;  // also where no declared effect needs it: to try others
    int threads = 1;

    dynamics::TimeScheme scheme() const { return {integrator, spectral_radius}; }
};

/// The formulation of Dubied et al. 2022 as their program had it, to be set beside the default one: fully integrated
/// hexahedra of truncated counts, projective corotational energy, equal vertex masses, implicit Euler, no damping but
/// its own.
SetupSettings published_settings();

/// A trial, ready to run and to be compared.
struct PreparedTrial {
    std::string name;
    experiment::TrialRole role = experiment::TrialRole::fit;
    model::Model model;                              // with the declared constants; free levels at 1
    std::vector<fibre::Signal> recorded_activation;  // before set_step() made jumps of what rises within a step
    dynamics::SimulationOptions options;
    measurement::Recording measured;  // markers on the body, declaration order; mesh frame; t = 0 at the start [s]
    Eigen::Index first_sample = 0;    // the first one compared (t >= 0)
    double start_s = 0.0;             // file time of t = 0
    bool start_found = false;         // found in the data, so its exact time may be calibrated
    std::string start_message;
    std::vector<Eigen::Vector3d> reference_m;  // displacement comparison: mean before the start, mesh frame
    std::optional<double> registration_rms_m;  // rest-pose registration
    std::vector<std::size_t> free_levels;      // muscles whose step level is unknown
    std::vector<double> occluded_fraction;     // per marker
    double rounding_m = 0.0;                   // step of the file's numbers, 0 where none is seen
};

/// An experiment folder turned into models and data. Constant while it is used.
struct Setup {
    experiment::Experiment experiment;
    SetupSettings settings;
    mesh::SurfaceMesh surface;
    BodyMesh mesh;
    model::BodyPointer body;
    measurement::MarkerSet markers;
    std::vector<std::string> marker_names;
    Eigen::VectorXd noise_m;  // per marker, 1 sigma per coordinate
    std::vector<PreparedTrial> trials;
    double modulus_factor = 1.0;  // the cells' modulus over the body's: coarse ones bend as if of another one
    std::vector<std::string> warnings;
    std::vector<TrialStep> steps;  // per trial, of choose_steps(); empty: as asked for, or not chosen yet
    std::optional<IntegrationCheck> integration;  // of check_integration(), when asked for
};

/// Of a trial's recording; a hundredth of a second where it has a single sample.
double sampling_interval_s(const PreparedTrial& trial);

/// Lets a trial run with steps of h_s; see with_switches_as_jumps().
void set_step(PreparedTrial& trial, double h_s);

/// Root mean square of the markers' noise [m].
double mean_noise(const Setup& setup);

/// Checks the shortest step of the trials, where a velocity force is least bearable, on the declared constants; its
/// warnings become the setup's. Takes about as long as a step.
void check_integration(Setup& setup);

/// Reads traces and geometry, meshes the body, binds markers, registers frames, finds starts.
/// Errors: every input error of the schema that needs more than the TOML, with key and line; cancelled.
/// @param meshed  the body as these settings mesh it, made before; null: it is meshed now
Result<Setup> prepare_setup(const experiment::Experiment& experiment, const SetupSettings& settings,
                            const Progress& progress = {}, const BodyMesh* meshed = nullptr);

/// The same setup on a body that shows what varies within cells, see fine_element(): to try effects that do.
Setup with_fine_element(Setup setup);

/// a - 1 of every muscle when `leader` steps to `level`: followers take their share.
std::vector<fibre::Signal> with_level(const experiment::Experiment& experiment, std::vector<fibre::Signal> activation,
                                      std::size_t leader, double level);

/// Puts the muscles' own signals in the place of recorded ones, and those of their followers.
void declare_activation(const experiment::Experiment& experiment, std::vector<fibre::Signal>& activation);

/// Derivative of with_level() with respect to the level: zero before the step.
std::vector<fibre::Signal> level_tangent(const experiment::Experiment& experiment, std::size_t leader);

}  // namespace myo::setup
