#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "base/box.hpp"
#include "panels/panel.hpp"
#include "viewport/viewport.hpp"

namespace myo::ui::panels {

/// Boxes of the declaration in the view, those whose numbers the side panel shows: their edges, and a handle on each
/// side. A drag of a handle moves that side along its axis; the box is emitted when the button is released, as one
/// edit.
class BoxTool {
public:
    /// The boxes that the panels showed in the last frame.
    void offer(std::vector<HandledBox> boxes) { boxes_ = std::move(boxes); }

    /// Whether a press at this pixel of the view (from its upper left corner) takes a handle.
    bool takes(const commands::WorkbenchState& state, const platform::Theme& theme, const viewport::ViewportState& view,
               const Eigen::Vector2d& pixel) const;

    /// Continues a drag and draws. Call it after draw_viewport(), within the view's window.
    void update(PanelContext& context, const viewport::ViewportState& view);

private:
    /// A side of a box.
    struct Handle {
        std::size_t box = 0;  // index in boxes_
        int axis = 0;         // 0 to 2
        bool upper = false;   // the side with the larger coordinate
    };
    /// A drag in progress, from the press on a handle to the release.
    struct Drag {
        Handle handle;
        HandledBox at_start;    // box at the press
        double offset_m = 0.0;  // from the mouse to the side, along the axis
        double side_m = 0.0;    // coordinate of the side now
        bool moved = false;     // the side has left its place; otherwise nothing is emitted
    };
    /// Middle of a side of a box [m], where its handle is drawn.
    static Eigen::Vector3d place_of(const Box& box, int axis, bool upper);
    /// The nearest handle within reach of a pixel; empty: none.
    std::optional<Handle> handle_at(const platform::Theme& theme, const viewport::ViewportState& view,
                                    const Eigen::Vector2d& pixel) const;
    /// The box of a drag with its side where the mouse is.
    Box dragged() const;
    /// Draws edges and handles of all boxes, the dragged one with its side where the mouse is.
    void draw(PanelContext& context, const viewport::ViewportState& view) const;

    std::vector<HandledBox> boxes_;  // see offer()
    std::optional<Drag> drag_;       // empty: nothing is dragged
    bool was_held_ = false;          // the button was held by a tool in the last frame
};

}  // namespace myo::ui::panels
