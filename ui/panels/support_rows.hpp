#pragma once

#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// Rows of the supports other than the clamp: box and held axes of each; adds at an end of the body or at a clicked
/// face, and removes.
///
/// Emits EditDeclaration. Item names begin with "support/more".
void draw_supports(PanelContext& context, NumberEdits& edits);

}  // namespace myo::ui::panels
