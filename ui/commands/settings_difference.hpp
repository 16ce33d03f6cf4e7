#pragma once

#include <string>
#include <vector>

#include "commands/backend.hpp"

namespace myo::ui::commands {

/// A setting in which some settings differ from others, and how each of them has it.
struct SettingDifference {
    std::string name;                 // "Young's modulus E"
    std::vector<std::string> values;  // of each, "260 kPa"
};

/// What differs, in the order of the panels; empty where all are alike.
/// @param of  not null
std::vector<SettingDifference> settings_differences(const std::vector<const Settings*>& of,
                                                    const std::vector<Choice>& materials,
                                                    const std::vector<Choice>& integrators);

}  // namespace myo::ui::commands
