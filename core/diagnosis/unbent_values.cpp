#include "diagnosis/unbent_values.hpp"

namespace myo::diagnosis {
namespace {

/// Damping that many times the expected one stands in for something else.
constexpr double far_damping = 3.0;

}  // namespace

std::optional<prediction::ParameterValues> unbent_values(const JointFit& fit,
                                                         const prediction::ParameterValues& expected) {
    prediction::ParameterValues values = fit.values;
    bool bent = false;
    for (const prediction::ModelParameter& p : fit.parameters) {
        const double now = prediction::value_of(p, values), before = prediction::value_of(p, expected);
        const bool far = p.kind == prediction::ModelParameter::Kind::damping
                             ? now > far_damping * before
                             : p.kind == prediction::ModelParameter::Kind::start_shift &&
                                   (now <= p.parameter.lower || now >= p.parameter.upper);
        if (!far) continue;
        bent = true;
        prediction::set_value(p, before, values);
    }
    return bent ? std::optional(std::move(values)) : std::nullopt;
}

}  // namespace myo::diagnosis
