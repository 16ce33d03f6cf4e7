#pragma once

#include <string>

#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// What a panel paints with the brush.
struct BrushUse {
    std::string name;  // beginning of the item names: "fibres"
    int part = -1;     // see BrushSettings::part; -1: the selected muscle
};

/// Tools and settings of the brush. Each tool shows only the settings that it uses: radius, depth and mirror belong to
/// strokes, soft edge, strength and direction only to muscles. Emits ChangeBrush.
void brush_rows(PanelContext& context, const BrushUse& use, NumberEdits& edit);

}  // namespace myo::ui::panels
