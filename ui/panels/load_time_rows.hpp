#pragma once

#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// Rows that say when a force acts: all along, within a window of time, or by a curve of its factor.
///
/// Emits EditDeclaration.
/// @param path  of the load in the declaration
/// @param item  item name of the load, to which "/when", "/from", "/until" and "/curve" are added
void load_time_rows(PanelContext& context, const commands::SceneLoad& load, const toml::TomlPath& path,
                    const std::string& item, NumberEdits& edits);

}  // namespace myo::ui::panels
