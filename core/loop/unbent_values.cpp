#include "loop/unbent_values.hpp"

namespace myo {
namespace {

/// Damping that many times the expected one stands in for something else.
constexpr double far_damping = 3.0;

}  // namespace

std::optional<StudyValues> unbent_values(const JointFit& fit, const StudyValues& expected) {
    StudyValues values = fit.values;
    bool bent = false;
    for (const StudyParameter& p : fit.parameters) {
        const double now = value_of(p, values), before = value_of(p, expected);
        const bool far = p.kind == StudyParameter::Kind::damping ? now > far_damping * before
                                                                  : p.kind == StudyParameter::Kind::start_shift && (now <= p.parameter.lower || now >= p.parameter.upper);
        if (!far) continue;
        bent = true;
        set_value(p, before, values);
    }
    return bent ? std::optional(std::move(values)) : std::nullopt;
}

}  // namespace myo
