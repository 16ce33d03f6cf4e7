#pragma once

#include <Eigen/Core>

#include <map>
#include <string>
#include <vector>

#include "inverse/least_squares.hpp"
#include "setup/setup.hpp"
#include "setup/trial_effects.hpp"

namespace myo::prediction {

/// Values of everything a fit may change, for all trials.
struct ParameterValues {
    double youngs_modulus_Pa = 0.0;            // of the body; multiplied by Setup::modulus_factor in the cells
    double damping_s = 0.0;                    // Kelvin-Voigt damping time
    std::vector<double> law = {};              // parameters of the constitutive law
    std::vector<double> part_modulus_Pa = {};  // of the parts; multiplied by Setup::modulus_factor in the cells
    std::vector<double> part_damping_s = {};   // of the parts; NaN: that of the body
    Eigen::Vector3d translation_m = Eigen::Vector3d::Zero();  // camera = rotation(rotation_rad) mesh + translation
    Eigen::Vector3d rotation_rad = Eigen::Vector3d::Zero();   // rotation vector about the mesh origin
    std::vector<double> start_shift_s;                        // per trial: t = 0 is this much later than start_s
    std::vector<std::map<std::size_t, double>> levels;        // per trial: actuator -> level of its step
    std::vector<effect::EffectDeclaration> effects;           // with their current parameters
    /// Per marker: how far it sits from its declared place, at rest, mesh frame [m], see marker_places.hpp. Empty: 0.
    std::vector<Eigen::Vector3d> places_m = {};
};
/// Initial values: what the experiment declares, shifts 0, free levels passive.
ParameterValues declared_values(const setup::Setup& setup);

/// One scalar of ParameterValues: name, initial value, bounds and scale, and where it is stored.
struct ModelParameter {
    enum class Kind {
        youngs_modulus,
        damping,
        law,
        part_modulus,
        part_damping,
        translation,
        rotation,
        start_shift,
        level,
        effect
    };
    Kind kind = Kind::youngs_modulus;
    std::size_t trial = 0;  // start_shift, level
    std::size_t index = 0;  // parameter of the law, part, axis (0 ... 2), actuator, or effect
    inverse::Parameter parameter;
    std::string unit;                                // for messages and files
    std::string of_effect{};                         // effect: key of its parameter
    int component = -1;                              // effect: component of a vector, or angle of a direction
    Eigen::Vector3d base = Eigen::Vector3d::Zero();  // effect: base of a direction, see EffectNumber

    bool is_angle() const { return !base.isZero(0.0); }
};

/// Parameters of one effect for a fit.
///
/// Places (position_m, centre_m) are bounded by the bounding box of the body, beyond which nothing changes, widened to
/// their start where that is declared outside.
/// @param index  position of the effect in ParameterValues::effects
std::vector<ModelParameter> effect_parameters(const setup::Setup& setup, const effect::EffectDeclaration& effect,
                                              std::size_t index);

/// All unknowns of the experiment: material.calibrate, limited registration, detected starts of fit trials, free levels
/// of fit trials, effects with calibrate = true.
///
/// @param names  if not empty: replaces material.calibrate for youngs_modulus, damping and the law
std::vector<ModelParameter> free_parameters(const setup::Setup& setup, const std::vector<std::string>& names = {});

/// Unknowns whose bounds in [[unknown]] leave nothing of their usual ones, which therefore hold.
std::vector<ModelParameter> unmet_bounds(const setup::Setup& setup);

/// Current value of a parameter, SI.
double value_of(const ModelParameter& parameter, const ParameterValues& values);
/// Sets a parameter, SI; bounds are not checked.
void set_value(const ModelParameter& parameter, double value, ParameterValues& values);

/// Model of a trial with these values, without effects.
model::Model trial_model(const setup::Setup& setup, std::size_t trial, const ParameterValues& values);

/// Model, simulation options and observation of a trial with these values and their effects.
effect::Affected affected_trial(const setup::Setup& setup, std::size_t trial, const ParameterValues& values);

/// Predicted marker motion of a trial in the frame and form in which it is compared. Default: not run.
struct TrialPrediction {
    dynamics::RunStatus status = dynamics::RunStatus::not_run;
    std::string message;                        // why the run is not complete
    dynamics::Trace trace;                      // all nodes, all steps
    std::vector<Eigen::Matrix3Xd> positions_m;  // per marker, 3 x samples of `measured` [m]; mesh frame
    std::vector<Eigen::Vector3d> start_m;       // per marker, at t = 0 [m]
    std::vector<Eigen::Matrix3Xd>
        residual_m;  // per marker: prediction minus measurement; NaN where occluded or not compared
    std::vector<std::vector<Eigen::Matrix3Xd>> tangents;  // [parameter][marker] derivative of the residual
    std::vector<Eigen::VectorXd> sensor_residuals{};      // per series of the trial: prediction minus reading, or NaN
    std::vector<std::vector<Eigen::VectorXd>> sensor_tangents{};  // [parameter][series]
    /// Derivative of the residual by the places of the markers, if markers.placement_m is positive: [3 marker + axis]
    /// [marker], 3 x samples; 3 x 0: zero.
    std::vector<std::vector<Eigen::Matrix3Xd>> place_tangents{};
    std::vector<Eigen::Vector3d> places_m{};  // those of the values of the prediction

    bool ok() const { return status == dynamics::RunStatus::complete; }
};
/// Simulates a trial and compares it with its recording.
///
/// @param parameters  for which `tangents` is filled: by the tangent of the run, or by residual_tangent()
/// @param warm_start        path of a run with a similar motion, as initial guess of the stages, see SimulationOptions;
/// may
///                    be null
/// Errors: none; a run that fails or is cancelled has status and message.
TrialPrediction predict_trial(const setup::Setup& setup, std::size_t trial, const ParameterValues& values,
                              const std::vector<ModelParameter>& parameters = {}, const Progress& progress = {},
                              std::shared_ptr<const dynamics::StagePath> warm_start = {});

/// Compares an existing simulation with the recording, for values that only change the observation.
///
/// @param trace  of a run with the same motion
/// @return       without a trace and without tangents
TrialPrediction observe_trial(const setup::Setup& setup, std::size_t trial, const ParameterValues& values,
                              const dynamics::Trace& trace);

/// Derivative of a trial's residual with respect to one parameter.
struct ResidualTangent {
    dynamics::RunStatus status = dynamics::RunStatus::not_run;
    std::string message;
    std::vector<Eigen::Matrix3Xd> tangent;  // per marker, 3 x samples [m per unit of the parameter]

    bool ok() const { return status == dynamics::RunStatus::complete; }
};
/// Derivative of the residual with respect to one parameter without a tangent run: closed for registration and start
/// shift, otherwise a difference to one or two further runs or observations.
///
/// @param there  prediction with `values`, trace included
/// Errors: none; a further run that fails gives its status and message.
ResidualTangent residual_tangent(const setup::Setup& setup, std::size_t trial, const ParameterValues& values,
                                 const ModelParameter& parameter, const TrialPrediction& there,
                                 const Progress& progress = {});

/// Root mean square over all finite coordinates [m]; NaN if there are none.
double rms(const std::vector<Eigen::Matrix3Xd>& residual_m);

/// Root mean square of the difference of two predictions of one trial [m].
double rms_between(const TrialPrediction& a, const TrialPrediction& b);

}  // namespace myo::prediction
