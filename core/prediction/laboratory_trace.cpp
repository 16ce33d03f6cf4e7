#include "prediction/laboratory_trace.hpp"

namespace myo::prediction {

std::optional<dynamics::Trace> laboratory_trace(const setup::Setup& setup, std::size_t trial,
                                                const ParameterValues& values, const dynamics::Trace& trace) {
    if (!setup.trials[trial].mount && values.effects.empty()) return std::nullopt;
    const model::MountMotionPointer mount = affected_trial(setup, trial, values).observation_error.mount;
    if (!mount) return std::nullopt;
    dynamics::Trace result = trace;
    for (std::size_t k = 0; k < trace.times_s.size(); ++k) {
        const model::MountPose pose = mount->at(trace.times_s[k]);
        result.velocities[k] = pose.velocities_in_laboratory(trace.positions[k], trace.velocities[k]);
        result.positions[k] = pose.in_laboratory(trace.positions[k]);
    }
    return result;
}

}  // namespace myo::prediction
