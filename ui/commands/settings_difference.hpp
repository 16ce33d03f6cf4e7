#pragma once

#include <string>
#include <vector>

#include "commands/backend.hpp"

namespace myo::ui::commands {

/// A setting and its value in each of several settings objects.
struct SettingDifference {
    std::string name;                 // "Young's modulus E"
    std::vector<std::string> values;  // one per settings object: "260 kPa"
};

/// Compares settings for the table of jobs.
///
/// @param of  settings to compare, not null
/// @param materials, integrators  to replace ids by labels
/// @return  the differences in the order of the panels; empty if all are equal or there are fewer than two
std::vector<SettingDifference> settings_differences(const std::vector<const Settings*>& of,
                                                    const std::vector<Choice>& materials,
                                                    const std::vector<Choice>& integrators);

/// All settings with their values, in the order of the panels. A setting that does not apply, such as the number of
/// another law, has no row.
std::vector<SettingDifference> settings_rows(const Settings& settings, const std::vector<Choice>& materials,
                                             const std::vector<Choice>& integrators);

}  // namespace myo::ui::commands
