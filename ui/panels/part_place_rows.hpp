#pragma once

#include <optional>
#include <string>

#include "base/box.hpp"
#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// Rows that say where a part is: a box, a closed surface, the number of cells of a volume mesh, or paint. Another
/// choice is one edit; paint begins with what the part holds. Emits EditDeclaration and PaintPart.
///
/// @param index  in Scene::parts
void part_place_rows(PanelContext& context, std::size_t index, NumberEdits& edits);

/// Buttons that add a part: a box, a closed surface from a file, or by a stroke of the brush.
void part_buttons(PanelContext& context, NumberEdits& edits);

}  // namespace myo::ui::panels
