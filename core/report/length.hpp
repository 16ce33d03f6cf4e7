#pragma once

#include <Eigen/Core>

#include <string>
#include <vector>

// Lengths as pages show them: in millimetres, to three digits.

namespace myo::report {

/// "1.23", for where the unit stands beside it.
std::string in_mm(double metres);

/// "1.23 mm".
std::string length_words(double metres);

/// A curve's values [mm].
std::vector<double> curve_in_mm(const Eigen::VectorXd& metres);

}  // namespace myo::report
