#include "prediction/prediction.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "effect/catalogue.hpp"
#include "measurement/rigid_motion.hpp"
#include "mesh/surface_mesh.hpp"
#include "prediction/marker_places.hpp"
#include "prediction/moved_markers.hpp"
#include "prediction/parameter_tangent.hpp"
#include "prediction/place_registration.hpp"
#include "prediction/sensor_tangents.hpp"
#include "setup/actuator_signals.hpp"

namespace myo::prediction {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Kind = ModelParameter::Kind;

}  // namespace

// Damping comes from the prepared model, as it may be assumed instead of declared.
ParameterValues declared_values(const setup::Setup& setup) {
    ParameterValues values;
    values.youngs_modulus_Pa = setup.experiment.material.youngs_modulus_Pa;
    values.damping_s = setup.trials.front().model.damping_s;
    values.law = setup.trials.front().model.material->values();
    const setup::MaterialValues materials = setup::declared_materials(setup.experiment, values.damping_s);
    values.part_modulus_Pa = materials.part_modulus_Pa;
    values.part_damping_s = materials.part_damping_s;
    values.start_shift_s.assign(setup.trials.size(), 0.0);
    for (const setup::PreparedTrial& trial : setup.trials) {
        std::map<std::size_t, double> levels;
        for (const std::size_t actuator : trial.free_levels)
            levels[actuator] = setup::passive_level(setup.experiment, actuator);
        values.levels.push_back(std::move(levels));
    }
    values.effects = setup.experiment.effects;
    return values;
}

namespace {

/// Whether a parameter of an effect is a place on or in the body.
bool is_place(const std::string& parameter) { return parameter == "position_m" || parameter == "centre_m"; }

}  // namespace

std::vector<ModelParameter> effect_parameters(const setup::Setup& setup, const effect::EffectDeclaration& effect,
                                              std::size_t index) {
    const Box body = mesh::bounding_box(setup.surface.vertices);
    std::vector<ModelParameter> list;
    for (const setup::EffectNumber& n : setup::effect_numbers(effect, setup::signal_size(setup, effect))) {
        inverse::Parameter parameter{n.name,  setup::effect_number(effect, n.parameter, n.component, n.base),
                                     n.lower, n.upper,
                                     n.scale, n.over_decades};
        if (is_place(n.parameter)) {
            parameter.lower = std::min(body.lowest(n.component), parameter.value);
            parameter.upper = std::max(body.highest(n.component), parameter.value);
        }
        list.push_back({Kind::effect, 0, index, std::move(parameter), n.base.isZero(0.0) ? "" : "rad", n.parameter,
                        n.component, n.base});
    }
    return list;
}

model::Model trial_model(const setup::Setup& setup, std::size_t trial, const ParameterValues& values) {
    model::Model model = setup.trials[trial].model;
    setup::set_materials(setup,
                         {values.youngs_modulus_Pa, values.damping_s, values.part_modulus_Pa, values.part_damping_s},
                         setup.modulus_factor, model);
    if (!values.law.empty()) model.material = model.material->with_values(values.law);
    for (const auto& [actuator, level] : values.levels[trial])
        setup::set_level(setup.experiment, actuator, level, model);
    return model;
}

effect::Affected affected_trial(const setup::Setup& setup, std::size_t trial, const ParameterValues& values) {
    return setup::with_effects(setup, trial, trial_model(setup, trial, values), values.effects);
}

namespace {

/// Predicted marker motion as the cameras report it, with the residuals against the recording.
struct ObservedMotion {
    std::vector<Matrix3Xd> positions_m;  // per marker at every sample [m]; mesh frame, observation errors included
    std::vector<Vector3d> start_m;       // per marker before the motion [m]
    std::vector<Matrix3Xd> residual_m;   // per marker, prediction minus measurement; NaN before first_sample
};

struct PredictionPolicy {
    /// A time before any event that happens to markers during a trial, for the reference of displacements.
    double long_before_s = -1e30;
    /// Difference steps relative to the scale of a parameter: for parameters that require another run (noise of the
    /// solver limits the step from below), and for parameters that only change the observation.
    double part_of_effect = 0.01;
    double part_of_constant = 0.003;
    double part_of_sight = 1e-4;
};
constexpr PredictionPolicy prediction_policy;

// Displacements are compared in the mesh frame; positions are mapped to the camera frame by the fitted registration.
ObservedMotion observed_motion(const setup::Setup& setup, std::size_t index, const ParameterValues& values,
                               const measurement::ObservationError& error, const measurement::MarkerTracks& tracks,
                               const measurement::MarkerTracks& origin) {
    const setup::PreparedTrial& trial = setup.trials[index];
    const Eigen::Matrix3d R = measurement::small_rotation(values.rotation_rad);
    const auto samples = trial.measured.sample_count();
    ObservedMotion result;
    result.positions_m = measurement::observed_tracks(
        error,
        measurement::laboratory_tracks(error, tracks.positions,
                                       motion_times(trial, error, values.start_shift_s[index])),
        trial.measured.time_s);
    for (const Matrix3Xd& start : measurement::observed_tracks(
             error, measurement::laboratory_tracks(error, origin.positions, Eigen::VectorXd::Zero(1)),
             Eigen::VectorXd::Constant(1, prediction_policy.long_before_s)))
        result.start_m.emplace_back(start.col(0));
    for (std::size_t m = 0; m < result.positions_m.size(); ++m) {
        const Matrix3Xd& x = result.positions_m[m];
        const Matrix3Xd& y = trial.measured.tracks[m];
        Matrix3Xd residual = Matrix3Xd::Constant(3, samples, std::numeric_limits<double>::quiet_NaN());
        for (Eigen::Index t = trial.first_sample; t < samples; ++t) {
            if (by_displacement(setup))
                residual.col(t) = (x.col(t) - result.start_m[m]) - (y.col(t) - trial.reference_m[m]);
            else
                residual.col(t) = R * x.col(t) + values.translation_m - y.col(t);
        }
        result.residual_m.push_back(std::move(residual));
    }
    follow_registration(setup, trial, values.places_m, result.residual_m);
    return result;
}

// Effects on the observation only: their derivative needs no further simulation.
bool acts_on_observation_only(const setup::Setup& setup, std::size_t index, const ParameterValues& values,
                              const ModelParameter& p) {
    return p.kind == Kind::effect && setup::changes_observation_only(values.effects[p.index]) &&
           effect::acts_on(setup::trial_context(setup, index), values.effects[p.index].parameters);
}

/// Tangents of the model for the parameters that move the body; they are simulated in one run.
struct ModelTangents {
    std::vector<sensitivity::ModelTangent> tangents;
    std::vector<int> row_of;  // per parameter: index of its tangent, or -1
};

ModelTangents model_tangents(const setup::Setup& setup, std::size_t index, const ParameterValues& values,
                             const std::vector<ModelParameter>& parameters) {
    ModelTangents result{{}, std::vector<int>(parameters.size(), -1)};
    for (std::size_t p = 0; p < parameters.size(); ++p)
        if (moves_the_body(setup, index, values, parameters[p]))
            if (std::optional<sensitivity::ModelTangent> tangent = parameter_tangent(setup, index, values,
                                                                                     parameters[p])) {
                result.row_of[p] = static_cast<int>(result.tangents.size());
                result.tangents.push_back(std::move(*tangent));
            }
    return result;
}

/// Zero per marker and sample.
std::vector<Matrix3Xd> no_tangent(const setup::Setup& setup, std::size_t index) {
    return std::vector<Matrix3Xd>(setup.marker_names.size(),
                                  Matrix3Xd::Zero(3, setup.trials[index].measured.sample_count()));
}

/// Differences of the residuals with respect to a parameter: central if both sides are inside the bounds, otherwise
/// one-sided towards the inside. Runs start from the path of the prediction, so both sides converge to the same branch.
///
/// @param moves  the parameter moves the body; otherwise it changes the observation only
/// @param result  gets the tangent, or the status of the run that failed
void set_difference(const setup::Setup& setup, std::size_t index, const ParameterValues& values,
                    const ModelParameter& parameter, const TrialPrediction& there, bool moves, const Progress& progress,
                    ResidualTangent& result) {
    const double value = value_of(parameter, values);
    const double part = !moves                           ? prediction_policy.part_of_sight
                        : parameter.kind == Kind::effect ? prediction_policy.part_of_effect
                                                         : prediction_policy.part_of_constant;
    double step = difference_step(parameter, value, part);
    if (value + step > parameter.parameter.upper) step = -step;  // towards the inside of the bounds
    const auto shifted = [&](double at) {
        ParameterValues changed = values;
        set_value(parameter, at, changed);
        return moves ? predict_trial(setup, index, changed, {}, progress, there.trace.path)
                     : observe_trial(setup, index, changed, there.trace);
    };
    const TrialPrediction other = shifted(value + step);
    result.status = other.status;
    result.message = other.message;
    if (!other.ok()) return;
    const bool both_sides = value - step >= parameter.parameter.lower && value - step <= parameter.parameter.upper;
    const TrialPrediction opposite = both_sides ? shifted(value - step) : TrialPrediction{};
    for (std::size_t m = 0; m < result.tangent.size(); ++m)
        result.tangent[m] = opposite.ok() ? Matrix3Xd((other.residual_m[m] - opposite.residual_m[m]) / (2.0 * step))
                                          : Matrix3Xd((other.residual_m[m] - there.residual_m[m]) / step);
}

/// Adds the tangents of the residuals: from the run where the parameter moves the body, otherwise without it. A failed
/// difference run makes the prediction unusable for a fit, but keeps its status and message.
void add_tangents(const setup::Setup& setup, std::size_t index, const ParameterValues& values,
                  const std::vector<ModelParameter>& parameters, const std::vector<int>& row_of,
                  const SensitiveMotion& motion, const Progress& progress, TrialPrediction& result) {
    for (std::size_t p = 0; p < parameters.size(); ++p) {
        if (row_of[p] >= 0) {
            const auto row = static_cast<std::size_t>(row_of[p]);
            result.tangents.push_back(moved_tangent(setup, index, values, motion, row));
            // An effect may move the mount as well, which the cameras see at once.
            if (motion.error.mount && parameters[p].kind == Kind::effect) {
                ResidualTangent seen{{}, {}, no_tangent(setup, index)};
                set_difference(setup, index, values, parameters[p], result, false, progress, seen);
                for (std::size_t m = 0; m < seen.tangent.size(); ++m) result.tangents.back()[m] += seen.tangent[m];
            }
            continue;
        }
        ResidualTangent column = residual_tangent(setup, index, values, parameters[p], result, progress);
        if (!column.ok()) {
            result.status = column.status;
            result.message = column.message;
            return;
        }
        result.tangents.push_back(std::move(column.tangent));
    }
}

/// Derivatives of the residuals with respect to the start of the motion.
std::vector<Matrix3Xd> start_tangent(const setup::Setup& setup, std::size_t index, const ParameterValues& values,
                                     const dynamics::Trace& trace) {
    const setup::PreparedTrial& trial = setup.trials[index];
    const measurement::ObservationError error = affected_trial(setup, index, values).observation_error;
    const Eigen::VectorXd times = motion_times(trial, error, values.start_shift_s[index]);
    const measurement::MarkerTracks tracks = measurement::observe(trace, markers_of(setup, error, values), times);
    const Eigen::Matrix3d R = measurement::small_rotation(values.rotation_rad);
    std::vector<Matrix3Xd> tangent = measurement::observed_tangents(
        error, measurement::laboratory_velocities(error, tracks.positions, tracks.velocities, times),
        measurement::laboratory_tracks(error, tracks.positions, times), trial.measured.time_s);
    for (Matrix3Xd& marker : tangent) marker = by_displacement(setup) ? Matrix3Xd(-marker) : Matrix3Xd(-R * marker);
    return tangent;
}

}  // namespace

TrialPrediction observe_trial(const setup::Setup& setup, std::size_t index, const ParameterValues& values,
                              const dynamics::Trace& trace) {
    const measurement::ObservationError error = affected_trial(setup, index, values).observation_error;
    const measurement::MarkerSet markers = markers_of(setup, error, values);
    const Eigen::VectorXd times = motion_times(setup.trials[index], error, values.start_shift_s[index]);
    const measurement::MarkerTracks tracks = measurement::observe(trace, markers, times);
    // Observation only: the motion is taken from the trace.
    ObservedMotion observed = observed_motion(setup, index, values, error, tracks,
                                              measurement::observe(trace, markers, Eigen::VectorXd::Zero(1)));
    return {trace.status,
            trace.message,
            {},
            std::move(observed.positions_m),
            std::move(observed.start_m),
            std::move(observed.residual_m),
            {},
            {},
            {},
            place_tangents(setup, index, values, error, markers, trace, times),
            values.places_m};
}

TrialPrediction predict_trial(const setup::Setup& setup, std::size_t index, const ParameterValues& values,
                              const std::vector<ModelParameter>& parameters, const Progress& progress,
                              std::shared_ptr<const dynamics::StagePath> warm_start) {
    const setup::PreparedTrial& trial = setup.trials[index];
    // All parameters that move the body are differentiated in one tangent run; the others follow from its result.
    effect::Affected affected = affected_trial(setup, index, values);
    affected.options.warm_start = std::move(warm_start);
    const ModelTangents moving = model_tangents(setup, index, values, parameters);
    TrialPrediction result;
    const measurement::MarkerSet markers = markers_of(setup, affected.observation_error, values);
    sensitivity::SensitiveTrace run = sensitivity::simulate_with_tangents(affected.model, affected.options,
                                                                          moving.tangents, markers.nodes, progress);
    result.status = run.trace.status;
    result.message = run.trace.message;
    if (!run.trace.complete()) {
        result.trace = std::move(run.trace);
        return result;
    }
    // Sample times in the clock of the simulation, with clock errors and the fitted start shift.
    const Eigen::VectorXd times = motion_times(trial, affected.observation_error, values.start_shift_s[index]);
    const SensitiveMotion motion = sensitive_motion(affected.observation_error, run, markers, times);
    ObservedMotion observed = observed_motion(setup, index, values, motion.error, motion.tracks.tracks,
                                              motion.origin.tracks);
    result.positions_m = std::move(observed.positions_m);
    result.start_m = std::move(observed.start_m);
    result.residual_m = std::move(observed.residual_m);
    result.trace = std::move(run.trace);
    result.place_tangents = place_tangents(setup, index, values, motion.error, markers, result.trace, times);
    result.places_m = values.places_m;
    add_tangents(setup, index, values, parameters, moving.row_of, motion, progress, result);
    if (trial.sensors.empty()) return result;
    result.sensor_residuals = sensor_residuals(setup, index, values, affected, result.trace);
    for (const ModelParameter& parameter : parameters) {
        result.sensor_tangents.push_back(sensor_tangents(setup, index, values, parameter, progress));
        if (!result.sensor_tangents.back().empty()) continue;
        result.status = progress.cancelled() ? dynamics::RunStatus::cancelled : dynamics::RunStatus::failed;
        result.message = "the derivatives of the sensors by " + parameter.parameter.name + " could not be computed";
        break;
    }
    return result;
}

ResidualTangent residual_tangent(const setup::Setup& setup, std::size_t index, const ParameterValues& values,
                                 const ModelParameter& parameter, const TrialPrediction& there,
                                 const Progress& progress) {
    const setup::PreparedTrial& trial = setup.trials[index];
    const auto samples = trial.measured.sample_count();
    ResidualTangent result{dynamics::RunStatus::complete, {}, no_tangent(setup, index)};
    // Residual = R x + translation - y, so the derivatives with respect to the registration are closed.
    if (parameter.kind == Kind::translation) {
        for (Matrix3Xd& marker : result.tangent) marker.row(static_cast<Eigen::Index>(parameter.index)).setOnes();
    } else if (parameter.kind == Kind::rotation) {
        for (std::size_t m = 0; m < result.tangent.size(); ++m)
            for (Eigen::Index t = 0; t < samples; ++t)
                result.tangent[m].col(t) = measurement::d_rotated_d_omega(values.rotation_rad,
                                                                          there.positions_m[m].col(t))
                                               .col(static_cast<Eigen::Index>(parameter.index));
    } else if (parameter.kind == Kind::start_shift && parameter.trial == index) {
        result.tangent = start_tangent(setup, index, values, there.trace);
    } else if (const bool seen = acts_on_observation_only(setup, index, values, parameter),
               moves = moves_the_body(setup, index, values, parameter) ||
                       // A recorded mount moves by the clock of the recording: an error of that moves the body.
                       (seen && trial.mount);
               moves || seen) {
        set_difference(setup, index, values, parameter, there, moves, progress, result);
    }
    return result;
}

}  // namespace myo::prediction
