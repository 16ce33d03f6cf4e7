#pragma once

#include <optional>
#include <string>
#include <vector>

namespace myo::ui::commands {

/// A value that a fit of the experiment finds, and its bounds. SI units.
struct SceneUnknown {
    std::string name;                    // as in results
    std::string label;                   // as shown
    std::string unit;                    // SI
    double value = 0.0;                  // where the fit starts
    double lowest = 0.0, highest = 0.0;  // bounds that hold; may be infinite
    std::optional<double> declared_lowest, declared_highest, declared_tolerance;
    int declared = -1;  // index in the table [[unknown]]; -1: it is not there
};
using SceneUnknowns = std::vector<SceneUnknown>;

}  // namespace myo::ui::commands
