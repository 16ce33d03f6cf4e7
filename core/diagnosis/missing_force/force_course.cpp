#include "diagnosis/missing_force/force_course.hpp"

#include <algorithm>

#include "experiment/actuators.hpp"
#include "model/internal_forces.hpp"
#include "setup/actuator_signals.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::VectorXd;

/// Linear interpolation of a scalar between the steps of a run.
VectorXd resampled(const std::vector<double>& times, const std::vector<double>& values, const VectorXd& at) {
    VectorXd result(at.size());
    std::size_t right = 1;
    for (Index k = 0; k < at.size(); ++k) {
        while (right + 1 < times.size() && times[right] < at(k)) ++right;
        const double span = times[right] - times[right - 1];
        const double w = span > 0.0 ? std::clamp((at(k) - times[right - 1]) / span, 0.0, 1.0) : 1.0;
        result(k) = (1.0 - w) * values[right - 1] + w * values[right];
    }
    return result;
}

/// Central differences, one-sided at the ends.
VectorXd rate(const VectorXd& values, double dt) {
    VectorXd result(values.size());
    const Index last = values.size() - 1;
    for (Index k = 0; k <= last; ++k) {
        const Index a = std::max<Index>(0, k - 1), b = std::min(last, k + 1);
        result(k) = (values(b) - values(a)) / (dt * static_cast<double>(b - a));
    }
    return result;
}

/// Elastic force along the pattern (no viscosity, no fibres), from a subset of the steps of the run.
VectorXd elastic_course(const model::Model& model, const dynamics::Trace& trace, const Matrix3Xd& pattern,
                        const VectorXd& at, const MissingForcePolicy& policy) {
    model::Stiffness elastic = model::stiffness(model);
    elastic.viscous.clear();
    elastic.fibres = false;
    model::InternalInput input;
    input.stiffness = &elastic;
    // Energies of the whole body are the costly part: no more of them than points of the curve.
    const std::size_t stride = std::max<std::size_t>(
        1, trace.times_s.size() / static_cast<std::size_t>(policy.curve_points));
    std::vector<double> times, values;
    for (std::size_t k = 0; k < trace.times_s.size(); k += stride) {
        times.push_back(trace.times_s[k]);
        values.push_back(model::internal_energy(model, trace.positions[k], input, model::HessianKind::none)
                             .gradient.cwiseProduct(pattern)
                             .sum());
    }
    return times.size() < 2 ? VectorXd(VectorXd::Zero(at.size())) : resampled(times, values, at);
}

}  // namespace

std::vector<statistics::Correlate> course_correlates(const setup::Setup& setup, const effect::Affected& trial,
                                                     const dynamics::Trace& trace, const KnotTimes& knots,
                                                     const ForceMode& mode, const MissingForcePolicy& policy) {
    if (trace.times_s.size() < 2) return {};
    // All courses at the same, evenly spaced times.
    const VectorXd at = VectorXd::LinSpaced(policy.curve_points, 0.0, knots.end_s());
    const double dt = at(1) - at(0);
    std::vector<double> position, velocity;
    // The body's motion along the mode: displacement and velocity weighted by its nodal forces.
    for (std::size_t k = 0; k < trace.times_s.size(); ++k) {
        position.push_back((trace.positions[k] - trial.model.body->mesh.nodes).cwiseProduct(mode.pattern).sum());
        velocity.push_back(trace.velocities[k].cwiseProduct(mode.pattern).sum());
    }
    const VectorXd v = resampled(trace.times_s, velocity, at);
    const VectorXd knot_times = knots.times_s();
    const VectorXd amplitude = resampled({knot_times.begin(), knot_times.end()},
                                         {mode.amplitude_N.begin(), mode.amplitude_N.end()}, at);
    std::vector<statistics::Regressor> regressors{
        {"position", resampled(trace.times_s, position, at)},
        {"velocity", v},
        {"|v| v", v.cwiseAbs().cwiseProduct(v)},
        {"acceleration", rate(v, dt)},
        {"strain rate", rate(elastic_course(trial.model, trace, mode.pattern, at, policy), dt)},
        {"time", at}};
    const experiment::Experiment& experiment = setup.experiment;
    const std::vector<experiment::Actuator> actuators = experiment::actuators(experiment);
    for (std::size_t a = 0; a < actuators.size(); ++a) {
        const fibre::Signal& signal = setup::actuator_signal(experiment, trial.model, a);
        VectorXd input(policy.curve_points);
        for (Index k = 0; k < policy.curve_points; ++k)
            input(k) = signal.value(at(k)) - setup::passive_level(experiment, a);
        // A constant signal correlates with nothing.
        if (input.maxCoeff() > input.minCoeff())
            regressors.push_back({experiment::quantity_word(actuators[a].kind) + " of " + actuators[a].name, input});
    }
    return statistics::correlates(amplitude, regressors);
}

}  // namespace myo::diagnosis
