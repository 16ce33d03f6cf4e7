#pragma once

#include <array>
#include <string>

#include "panels/declared_rows.hpp"

namespace myo::ui::panels {

/// Row of ticks for x, y and z. A change sets the list of the ticked axes in the declaration, such as ["x", "z"]; all
/// three are the default, which is not written. Items: `item` with "/x", "/y" and "/z".
/// @param key  place of the list in the declaration
void axis_ticks(PanelContext& context, const char* label, const char* tip, const std::array<bool, 3>& ticked,
                const toml::TomlPath& key, const std::string& item);

}  // namespace myo::ui::panels
