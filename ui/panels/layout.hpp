#pragma once

#include "commands/preferences.hpp"
#include "platform/item_rectangles.hpp"

namespace myo::ui::panels {

/// Rectangles of the window's parts [pixels]:
///
///     +-----------------------------------+
///     | bar                               |
///     +-------+------+--------------------+
///     | steps | rail | view               |
///     |       |      |                    |
///     |       |      +--------------------+
///     |       |      | timeline           |
///     |       |      +--------------------+
///     |       |      | strip              |
///     +-------+------+--------------------+
///
/// The edges right of `rail` and above `strip` can be dragged. Without an open scene the view also takes the place of
/// timeline and strip; WorkbenchWindow does that.
struct Layout {
    platform::Rectangle bar;         // menu bar, at the top
    platform::Rectangle steps;       // tasks, far left
    bool narrow = false;             // the tasks show icons only
    platform::Rectangle rail;        // side panel: panels of the selected task
    platform::Rectangle view;        // 3D view
    platform::Rectangle timeline;    // below the view
    platform::Rectangle strip;       // panels below the view
    platform::Rectangle help;        // right of view, timeline and strip; empty while the help is closed
    platform::Rectangle rail_edge;   // handle between side panel and view
    platform::Rectangle strip_edge;  // handle above the strip
};

/// Divides a window of this size [pixels]. The view keeps at least a third of width and height, whatever sizes the user
/// has dragged.
///
/// @param sizes  preferred sizes [pixels at scale 1]
Layout make_layout(float width, float height, float scale, const commands::LayoutSizes& sizes);

/// Adds the help at the right edge of a layout; view, timeline and strip become narrower by its width.
Layout beside_help(Layout layout, float scale);

}  // namespace myo::ui::panels
