#pragma once

#include <string>

namespace myo::ui::plot {

/// Formats a value with the given number of significant digits. Returns an en dash if the value is not finite.
std::string value_label(double value, int significant_digits);

/// Formats a length given in metres as millimetres with three significant digits: "1.23 mm".
std::string millimetres(double metres);

/// As value_label(), but without trailing zeros: "30", "0.25".
std::string plain_label(double value, int significant_digits);

/// Formats a value and its standard deviation with the decimals that the deviation justifies: "12.3 ± 0.4". Without a
/// known, positive deviation returns the value alone.
std::string label_with_deviation(double value, double deviation);

}  // namespace myo::ui::plot
