#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

// Lengths for reports: in millimetres with three significant digits.

namespace myo::report {

/// Number only, e.g. "1.23", for places where the unit is shown separately.
std::string in_mm(double metres);

/// Number with unit, e.g. "1.23 mm".
std::string length_words(double metres);

/// Values converted from m to mm, as a series of a chart; NaN stays NaN.
std::vector<double> curve_in_mm(const Eigen::VectorXd& metres);

}  // namespace myo::report
