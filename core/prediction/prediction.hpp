#pragma once

#include <Eigen/Core>

#include <map>
#include <string>
#include <vector>

#include "inverse/least_squares.hpp"
#include "setup/setup.hpp"
#include "setup/trial_effects.hpp"

namespace myo::prediction {

/// The numbers a fit may move, for all trials. Defaults: what the experiment declares.
struct ParameterValues {
    double youngs_modulus_Pa = 0.0;
    double damping_s = 0.0;
    Eigen::Vector3d translation_m = Eigen::Vector3d::Zero();  // camera = rotation(rotation_rad) mesh + translation
    Eigen::Vector3d rotation_rad = Eigen::Vector3d::Zero();
    std::vector<double> start_shift_s;                  // per trial: t = 0 is that much later than `start_s`
    std::vector<std::map<std::size_t, double>> levels;  // per trial: muscle -> level of its step
    std::vector<effect::EffectDeclaration> effects;
};
ParameterValues declared_values(const setup::Setup& setup);

/// One number of ParameterValues, with its name, start, bounds and scale, and how to reach it.
struct ModelParameter {
    enum class Kind { youngs_modulus, damping, translation, rotation, start_shift, level, effect };
    Kind kind = Kind::youngs_modulus;
    std::size_t trial = 0;  // start_shift, level
    std::size_t index = 0;  // axis, muscle, or effect
    inverse::Parameter parameter;
    std::string unit;
    std::string of_effect{};                         // effect: name of its parameter
    int component = -1;                              // effect: of a vector, or angle of a direction
    Eigen::Vector3d base = Eigen::Vector3d::Zero();  // effect: of a direction, see EffectNumber

    bool is_angle() const { return !base.isZero(0.0); }
};

/// The numbers of an effect, number `index` of the values', for a fit.
std::vector<ModelParameter> effect_parameters(const effect::EffectDeclaration& effect, std::size_t index);

/// What the experiment leaves unknown: material.calibrate, a limited registration, starts found in fit trials, free
/// levels. names: restricts youngs_modulus and damping when not empty.
std::vector<ModelParameter> free_parameters(const setup::Setup& setup, const std::vector<std::string>& names = {});

double value_of(const ModelParameter& parameter, const ParameterValues& values);
void set_value(const ModelParameter& parameter, double value, ParameterValues& values);

/// The trial's model with the values put in, without the effects.
model::Model trial_model(const setup::Setup& setup, std::size_t trial, const ParameterValues& values);

/// The same with the effects, and how the trial runs and is seen with them.
effect::Affected affected_trial(const setup::Setup& setup, std::size_t trial, const ParameterValues& values);

/// Prediction of a trial's samples, in the frame and form in which they are compared.
struct TrialPrediction {
    dynamics::RunStatus status = dynamics::RunStatus::not_run;
    std::string message;
    dynamics::Trace trace;                      // all nodes, all steps
    std::vector<Eigen::Matrix3Xd> positions_m;  // per marker, at every sample of `measured`; mesh frame
    std::vector<Eigen::Vector3d> start_m;       // per marker, at t = 0
    std::vector<Eigen::Matrix3Xd>
        residual_m;  // per marker: prediction minus measurement; NaN where occluded or not compared
    std::vector<std::vector<Eigen::Matrix3Xd>> tangents;  // [parameter][marker] derivative of the residual

    bool ok() const { return status == dynamics::RunStatus::complete; }
};
/// near: a run that moves nearly alike, see SimulationOptions; may be null.
TrialPrediction predict_trial(const setup::Setup& setup, std::size_t trial, const ParameterValues& values,
                              const std::vector<ModelParameter>& parameters = {}, const Progress& progress = {},
                              std::shared_ptr<const dynamics::StagePath> near = {});

/// The same of a motion that was run before with values that move the body alike: how it is seen, no trace kept.
TrialPrediction observe_trial(const setup::Setup& setup, std::size_t trial, const ParameterValues& values,
                              const dynamics::Trace& trace);

/// Derivative of a trial's residual by one number, per marker, beside a prediction with the same values and its trace:
/// exact for numbers that only move what is seen, otherwise from the difference to one more run.
struct ResidualTangent {
    dynamics::RunStatus status = dynamics::RunStatus::not_run;
    std::string message;
    std::vector<Eigen::Matrix3Xd> tangent;

    bool ok() const { return status == dynamics::RunStatus::complete; }
};
ResidualTangent residual_tangent(const setup::Setup& setup, std::size_t trial, const ParameterValues& values,
                                 const ModelParameter& parameter, const TrialPrediction& there,
                                 const Progress& progress = {});

/// Root mean square over all compared coordinates [m]; NaN when there are none.
double rms(const std::vector<Eigen::Matrix3Xd>& residual_m);

/// rms of the difference of two predictions of one trial [m].
double rms_between(const TrialPrediction& a, const TrialPrediction& b);

}  // namespace myo::prediction
