#pragma once

namespace myo::ui::panels {

/// Whether Escape was pressed for what is being drawn: a dialog within its popup, a tool outside all popups. One press
/// closes one thing, the topmost: text fields, lists and popups above it have the key first.
bool escape_closes();

/// Whether keys belong to a list, menu or dialog: one is open, or this frame's key has closed it.
bool keys_belong_to_popup();

}  // namespace myo::ui::panels
