#pragma once

#include <string>

#include "project/prediction.hpp"

namespace myo {

/// A parameter as a person reads it, in the report and in the window.
struct ReadableParameter {
    std::string name;     // "Young’s modulus E"
    std::string unit;     // "kPa"; empty for a plain number
    double factor = 1.0;  // shown = factor * SI value
};
ReadableParameter readable_parameter(const StudyParameter& parameter, const Study& study);

}  // namespace myo
