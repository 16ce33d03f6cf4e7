#pragma once

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// Draws the page that replaces the view while nothing is open: examples, recent files, and a button to open another
/// one. Fills the current window.
void draw_start_page(PanelContext& context);

/// Number of columns, at most `most`, for this number of cards, such that no row contains a single card. At least 1.
int card_columns(int cards, int most);

}  // namespace myo::ui::panels
