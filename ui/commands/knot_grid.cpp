#include "commands/knot_grid.hpp"

#include <cmath>

namespace myo::ui::commands {

double on_grid(double value, double step) {
    const double exponent = std::floor(std::log10(step) + 1e-9);
    // A whole number of the step's last decimal: dividing it by a power of ten gives the nearest number to the decimal
    // text, which a product with 0.1 would miss. Adding zero turns a negative zero.
    const double digit = std::round(step / std::pow(10.0, exponent)), count = std::round(value / step) * digit + 0.0;
    return exponent < 0.0 ? count / std::pow(10.0, -exponent) : count * std::pow(10.0, exponent);
}

}  // namespace myo::ui::commands
