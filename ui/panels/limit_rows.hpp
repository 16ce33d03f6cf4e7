#pragma once

#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// Rows of the largest pressure, tension and shortening that Optimise may use, for the kinds of chambers and tendons
/// that the experiment has.
///
/// Emits EditDeclaration. Item names begin with "fit/limit/".
void draw_limit_rows(PanelContext& context, NumberEdits& edits);

}  // namespace myo::ui::panels
