#pragma once

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// Ticks of the muscles, chambers and tendons whose signals Optimise seeks, in a list that is open. Emits
/// EditDeclaration, or ChangeSettings for a muscle that was made in the window. Item names begin with
/// "fit/seek/signal/".
void draw_signal_ticks(PanelContext& context);

}  // namespace myo::ui::panels
