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
#include "setup/chambers.hpp"
#include "setup/command_range.hpp"
#include "setup/integration_check.hpp"
#include "setup/parts.hpp"
#include "setup/sensors.hpp"
#include "setup/tendons.hpp"
#include "setup/trial_step.hpp"

namespace myo::setup {

/// How an experiment is simulated. Empty options are chosen from the data.
struct SetupSettings {
    MeshRequest mesh;
    dynamics::Integrator integrator = dynamics::Integrator::tr_bdf2;
    double spectral_radius = 0.5;  // of generalized_alpha at infinite frequency, 0 ... 1
    dynamics::Strategy strategy = dynamics::Strategy::automatic;
    std::optional<double> h_s;            // time step [s]; default: half the sampling interval, until choose_steps()
    std::optional<std::string> material;  // id; default: the declared one
    double velocity_force_1_s = 0.0;      // coefficient Lambda of the velocity force [1/s]
    model::MassModel mass_model = model::MassModel::consistent;
    /// Damping time if none is declared: 9 % of critical damping at 10 Hz, typical of silicones, and at most that ratio
    /// in the first vibration of faster bodies, which would otherwise creep instead of oscillating.
    double assumed_damping_s = 0.003, max_assumed_damping_ratio = 0.09;
    bool as_published = false;  // derived from published_settings()
    bool fine_element = false;  // fem::fine_element() even if no declared effect needs it, for trying others
    int threads = 1;            // trials that run in parallel

    dynamics::TimeScheme scheme() const { return {integrator, spectral_radius}; }
};

/// The formulation of Dubied et al. 2022 as their program had it, for comparison with the default: fully integrated
/// hexahedra of truncated counts, projective corotational energy, equal vertex masses, implicit Euler, no damping other
/// than its own.
SetupSettings published_settings();

/// A trial ready to be simulated and compared with its recording.
struct PreparedTrial {
    std::string name;
    experiment::TrialRole role = experiment::TrialRole::fit;
    bool hold = false;                               // statics: the run is the equilibrium at t = 0, for all samples
    model::Model model;                              // declared constants; free levels passive
    std::vector<fibre::Signal> recorded_activation;  // before set_step() turns switches within a step into jumps
    std::vector<fibre::Signal> recorded_commands;    // of chambers and tendons, likewise
    dynamics::SimulationOptions options;
    /// Markers on the body in the order of declaration, mesh frame [m]; t = 0 at the start [s].
    measurement::Recording measured;
    model::MountMotionPointer mount;           // as its markers were seen to move, by t of `measured`; null: at rest
    double mount_gap_s = 0.0;                  // longest time during which its markers did not show it
    Eigen::Index first_sample = 0;             // first compared sample (t >= 0)
    double start_s = 0.0;                      // file time of t = 0
    bool start_found = false;                  // start detected in the data, so that a fit may shift it
    std::string start_message;                 // how the start was determined
    std::vector<Eigen::Vector3d> reference_m;  // displacement comparison: mean before the start [m], mesh frame
    std::optional<double> registration_rms_m;  // residual of rest-pose registration [m]
    /// Derivative of the rest-pose registration by the places of the markers on the body, see d_registration_d_to();
    /// 6 x 3 markers; empty: it does not depend on them, or they are exact.
    Eigen::MatrixXd registration_by_places;
    std::vector<std::size_t> free_levels;   // actuators with an unknown step level, see actuator_signals.hpp
    std::vector<double> occluded_fraction;  // per marker, 0 ... 1
    std::vector<SensorSeries> sensors;      // readings in addition to the markers
    double rounding_m = 0.0;                // increment of the numbers in the file [m], 0 if none is detected
    /// Weights of the coordinates of `measured` where that holds goals, per marker 3 x samples; empty: a recording, 1
    /// each.
    std::vector<Eigen::Matrix3Xd> goal_weights{};
};

/// A prepared experiment: models and data of all trials. Not modified while it is used.
struct Setup {
    experiment::Experiment experiment;
    SetupSettings settings;
    mesh::SurfaceMesh surface;
    BodyMesh mesh;
    model::BodyPointer body;                   // shared by the models of all trials
    Eigen::MatrixXd part_shares;               // of the materials in the cells, see part_shares(); empty: one material
    std::vector<Chamber> chambers;             // in the order of declaration
    std::vector<Tendon> tendons;               // in the order of declaration
    std::vector<CommandRange> command_ranges;  // of chambers, then tendons; also of trials that were taken out since
    measurement::MarkerSet markers;            // interpolation from nodes to the markers on the body
    std::vector<std::string> marker_names;
    Eigen::VectorXd noise_m;  // per marker, 1 sigma per coordinate [m]
    std::vector<PreparedTrial> trials;
    double modulus_factor = 1.0;  // modulus of the cells over that of the body; corrects the stiffness of coarse meshes
    std::vector<std::string> warnings;
    std::vector<TrialStep> steps;  // per trial, from choose_steps(); empty: requested steps, or not chosen yet
    std::optional<IntegrationCheck> integration;  // result of check_integration(), if it was called
};

/// Gives the cells of a model moduli [Pa] and damping times [s]; density stays.
///
/// @param factor  on all moduli
void set_materials(const Setup& setup, const MaterialValues& values, double factor, model::Model& model);

/// Sampling interval of the recording [s], from its nominal rate; 0.01 s if that is unknown, as with a single sample.
double sampling_interval_s(const PreparedTrial& trial);

/// Sets the time step of a trial [s] and turns switches of the actuation within one step into jumps, see
/// with_switches_as_jumps().
void set_step(PreparedTrial& trial, double h_s);

/// Root mean square of the markers' noise per coordinate [m]; the assumed noise if there is no marker.
double mean_noise(const Setup& setup);

/// Checks the shortest step of the trials, which tolerates the smallest velocity force, with the declared constants.
/// Appends its warnings to the setup. Costs about as much as one time step.
void check_integration(Setup& setup);

/// Prepares an experiment: reads traces and geometry, meshes the body, binds markers, registers frames, detects starts.
///
/// @param meshed  mesh made before with the same settings; null: the body is meshed here
/// Errors: every input error that needs more than the TOML file, with key and line; cancelled.
Result<Setup> prepare_setup(const experiment::Experiment& experiment, const SetupSettings& settings,
                            const Progress& progress = {}, const BodyMesh* meshed = nullptr);

/// A setup with elements that resolve variation within cells, see fine_element(); needed to try such effects. Only the
/// element changes; models keep their constants.
Setup with_fine_element(Setup setup);

/// Replaces the signals of `leader` and its followers by a step at t = 0 from passive (1) to `level`; followers scale
/// a - 1 by their factor.
std::vector<fibre::Signal> with_level(const experiment::Experiment& experiment, std::vector<fibre::Signal> activation,
                                      std::size_t leader, double level);

/// Replaces recorded signals by the muscles' own declared ones, followers included.
void declare_activation(const experiment::Experiment& experiment, std::vector<fibre::Signal>& activation);

/// Derivative of with_level() with respect to the level: zero before the step, the factor of each muscle after it.
std::vector<fibre::Signal> level_tangent(const experiment::Experiment& experiment, std::size_t leader);

}  // namespace myo::setup
