#pragma once

#include <filesystem>

#include "panels/marker_tool.hpp"
#include "panels/placing.hpp"
#include "panels/region_tool.hpp"
#include "panels/tendon_tool.hpp"

namespace myo::ui::panels {

/// The tools of the 3D view that set places of the declaration. At most one is on, as Placing says.
class PlacingTools {
public:
    /// Whether a press at this pixel of the view (from its upper left corner) belongs to the tool that is on.
    bool takes(const PanelContext& context, const viewport::DrawnScene& scene, const viewport::ViewportState& view,
               const Eigen::Vector2d& pixel) const;
    /// Handles the mouse and the keys. Call it after draw_viewport(), within the view's window. Returns true while
    /// clicks belong to a tool.
    bool update(PanelContext& context, const viewport::DrawnScene& scene, viewport::ViewportState& view);
    /// Adds what the tool shows to the drawn scene.
    void show(const Placing& placing, const platform::Theme& theme, viewport::DrawnScene& drawn) const;
    /// Changes whenever show() does.
    int revision() const { return markers_.revision() + guides_.revision() + region_.revision(); }

private:
    /// Ends the tool if something else wants the clicks, or another body is shown.
    void follow(PanelContext& context, viewport::ViewportState& view);
    /// Drops what has been begun. Returns false if nothing has.
    bool cancel();

    MarkerTool markers_;                        // for Kind::markers
    TendonTool guides_;                         // for Kind::guides
    RegionTool region_;                         // for Kind::box and Kind::cavity
    PickedSurface surface_;                     // of the open scene
    std::filesystem::path path_;                // of the scene in the last frame
    Placing::Kind kind_ = Placing::Kind::none;  // in the last frame
};

}  // namespace myo::ui::panels
