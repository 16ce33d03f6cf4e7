#pragma once

#include <string>
#include <vector>

#include "calibration/calibrate.hpp"

namespace myo::calibration {

/// A parameter that a fit left at a bound of its range.
struct ValueAtBound {
    std::size_t parameter = 0;  // of the calibration's
    double value = 0.0;
    double bound = 0.0;
    bool upper = false;  // the upper bound, or the lower one
};

/// The parameters of a calibration that ended at a bound, in their order. One without influence on the data is left
/// out: it is where it was declared.
std::vector<ValueAtBound> values_at_bounds(const Calibration& calibration);

/// "damping_s: the fit ended at its upper bound, 1 s"; of the modulus with the declared tolerance that makes the bound.
std::string bound_sentence(const setup::Setup& setup, const Calibration& calibration, const ValueAtBound& at);

}  // namespace myo::calibration
