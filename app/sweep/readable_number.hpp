#pragma once

#include <string>

#include "sweep/case_numbers.hpp"
#include "sweep/sweep_file.hpp"

namespace myo::sweep {

/// A quantity as it is shown: name, unit and factor from SI.
struct ShownQuantity {
    std::string name;  // "youngs modulus"
    std::string unit;  // "kPa"; empty: a plain number
    // Shown number = factor times the number in SI.
    double factor = 1.0;
};

/// How a number of a report is shown. The unit is that of the number, or else the one in which its name ends.
ShownQuantity shown_quantity(const std::string& name, const std::string& unit);

/// How a varied quantity is shown: "material.youngs modulus" in kPa.
ShownQuantity shown_quantity(const Varied& varied);

/// Number with deviation and unit, as shown: "267 ± 4 kPa".
std::string words_of(const CaseNumber& number);

}  // namespace myo::sweep
