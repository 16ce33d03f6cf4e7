#pragma once

#include <string>

#include "panels/widgets.hpp"

// Lists of declared things: each has a heading that opens it, one is open at a time, and the view highlights it.

namespace myo::ui::panels {

/// Heading of one thing in a list.
struct ItemHeading {
    std::string item;        // item name for tests, and that of ViewOptions::edited while it is open
    std::string title;       // "Point mass"
    std::string tip;         // tooltip of the title
    std::string remove_tip;  // tooltip of the button that removes it
    bool muted = false;      // without effect at present
};

/// What was pressed in a heading.
enum class ItemPress { nothing, removed };

/// Draws the heading. A click on the title opens or closes the thing, as ChangeView.
///
/// @param reserved  width at the right for further controls, which the caller draws behind SameLine() [pixels]
ItemPress item_heading(PanelContext& context, const ItemHeading& heading, float reserved = 0.0f);

/// Whether the thing is open.
bool is_open(const PanelContext& context, const std::string& item);

/// Opens a thing, such as one that was just added; empty: closes all.
void open_item(PanelContext& context, const std::string& item);

}  // namespace myo::ui::panels
