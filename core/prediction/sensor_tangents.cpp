#include "prediction/sensor_tangents.hpp"

#include <algorithm>

#include "measurement/observation_error.hpp"
#include "prediction/parameter_tangent.hpp"

namespace myo::prediction {
namespace {

using Eigen::VectorXd;

struct SensorTangentPolicy {
    /// Step of the differences relative to the scale of the parameter: the runs end at a residual of 1e-6, the
    /// curvature adds a part in a million.
    double part_of_scale = 1e-2;
};
constexpr SensorTangentPolicy sensor_tangent_policy;

}  // namespace

std::vector<VectorXd> sensor_residuals(const setup::Setup& setup, std::size_t trial, const ParameterValues& values,
                                       const effect::Affected& affected, const dynamics::Trace& trace) {
    std::vector<VectorXd> residuals;
    for (const setup::SensorSeries& series : setup.trials[trial].sensors) {
        const VectorXd at_s = measurement::true_times(affected.observation_error, series.time_s).array() -
                              values.start_shift_s[trial];
        residuals.push_back(
            setup::sensor_readings(setup.experiment, setup.chambers, series, affected.model, trace, at_s) -
            series.values);
    }
    return residuals;
}

std::vector<VectorXd> sensor_tangents(const setup::Setup& setup, std::size_t trial, const ParameterValues& values,
                                      const ModelParameter& parameter, const Progress& progress) {
    const double value = value_of(parameter, values);
    const double step = difference_step(parameter, value, sensor_tangent_policy.part_of_scale);
    const auto side = [&](double at) {
        ParameterValues changed = values;
        set_value(parameter, std::clamp(at, parameter.parameter.lower, parameter.parameter.upper), changed);
        // The value is read back because clamping to the bounds can shorten one side.
        return std::pair{value_of(parameter, changed), predict_trial(setup, trial, changed, {}, progress)};
    };
    const auto [low, under] = side(value - step);
    const auto [high, over] = side(value + step);
    if (!under.ok() || !over.ok() || !(high > low)) return {};
    std::vector<VectorXd> tangents;
    for (std::size_t s = 0; s < under.sensor_residuals.size(); ++s)
        tangents.push_back((over.sensor_residuals[s] - under.sensor_residuals[s]) / (high - low));
    return tangents;
}

}  // namespace myo::prediction
