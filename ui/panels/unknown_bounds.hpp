#pragma once

#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// Rows of the values that a fit finds: the bounds that hold, and number fields for declared bounds or a tolerance.
///
/// Emits EditDeclaration. Item names begin with "unknown/bounds/".
void draw_bounds(PanelContext& context, NumberEdits& edits);

}  // namespace myo::ui::panels
