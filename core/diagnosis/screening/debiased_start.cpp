#include "diagnosis/screening/debiased_start.hpp"

namespace myo::diagnosis {

std::optional<prediction::ParameterValues> debiased_start(const JointFit& fit,
                                                          const prediction::ParameterValues& expected,
                                                          const DeclaredFitPolicy& policy) {
    prediction::ParameterValues values = fit.values;
    bool distorted = false;
    for (const prediction::ModelParameter& p : fit.parameters) {
        const double now = prediction::value_of(p, values), before = prediction::value_of(p, expected);
        // Damping far above the expected one, or a start shift at a bound; other parameters are left as fitted.
        const bool far = p.kind == prediction::ModelParameter::Kind::damping
                             ? now > policy.max_damping_ratio * before
                             : p.kind == prediction::ModelParameter::Kind::start_shift &&
                                   (now <= p.parameter.lower || now >= p.parameter.upper);
        if (!far) continue;
        distorted = true;
        prediction::set_value(p, before, values);
    }
    return distorted ? std::optional(std::move(values)) : std::nullopt;
}

}  // namespace myo::diagnosis
