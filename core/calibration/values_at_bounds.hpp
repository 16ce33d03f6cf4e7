#pragma once

#include <string>
#include <vector>

#include "calibration/calibrate.hpp"

namespace myo::calibration {

/// A parameter that a fit left at one of its bounds.
struct ValueAtBound {
    std::size_t parameter = 0;  // index into Calibration::parameters
    double value = 0.0;
    double bound = 0.0;
    bool upper = false;  // upper or lower bound
};

/// Parameters of a calibration that ended at a bound, in their order. Parameters without influence on the data are
/// skipped: they kept their initial value.
std::vector<ValueAtBound> values_at_bounds(const Calibration& calibration);

/// Readable warning "damping_s: the fit ended at its upper bound, 1 s"; for the modulus with the declared tolerance
/// that sets the bound, for a parameter of [[unknown]] with that table.
std::string bound_sentence(const setup::Setup& setup, const Calibration& calibration, const ValueAtBound& at);

}  // namespace myo::calibration
