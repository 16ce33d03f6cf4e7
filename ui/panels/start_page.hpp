#pragma once

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// What stands in the view's place while nothing is open: examples, what was open lately, and how to open something
/// else. Fills the current window.
void draw_start_page(PanelContext& context);

/// Columns, at most so many, in which no row of cards has one alone.
int card_columns(int cards, int most);

}  // namespace myo::ui::panels
