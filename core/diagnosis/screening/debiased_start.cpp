#include "diagnosis/screening/debiased_start.hpp"

#include "diagnosis/diagnosis_policy.hpp"

namespace myo::diagnosis {
namespace {}  // namespace

std::optional<prediction::ParameterValues> debiased_start(const JointFit& fit,
                                                          const prediction::ParameterValues& expected) {
    prediction::ParameterValues values = fit.values;
    bool bent = false;
    for (const prediction::ModelParameter& p : fit.parameters) {
        const double now = prediction::value_of(p, values), before = prediction::value_of(p, expected);
        const bool far = p.kind == prediction::ModelParameter::Kind::damping
                             ? now > diagnosis_policy.declared.most_damping_ratio * before
                             : p.kind == prediction::ModelParameter::Kind::start_shift &&
                                   (now <= p.parameter.lower || now >= p.parameter.upper);
        if (!far) continue;
        bent = true;
        prediction::set_value(p, before, values);
    }
    return bent ? std::optional(std::move(values)) : std::nullopt;
}

}  // namespace myo::diagnosis
