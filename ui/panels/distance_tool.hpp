#pragma once

#include <imgui.h>

#include <memory>
#include <optional>
#include <vector>

#include "commands/picked_place.hpp"
#include "panels/panel.hpp"
#include "viewport/viewport.hpp"

namespace myo::ui::panels {

/// A distance between two places on the body or markers, which move with them.
struct MeasuredDistance {
    commands::PickedPlace from, to;  // ends of the distance
    double now_m = 0.0;              // in the drawn scene [m]; NaN while an end is not drawn
    double at_rest_m = 0.0;          // [m]
};

/// Updates the present lengths from the drawn scene.
void measure(std::vector<MeasuredDistance>& distances, const viewport::DrawnScene& scene);
/// Draws the distances with their labels over the view.
void draw_distances(ImDrawList& list, const platform::Theme& theme, const std::vector<MeasuredDistance>& distances,
                    const viewport::DrawnScene& scene, const viewport::ViewportState& view);

/// Measures distances in the view. While ViewportState::measuring is set, every two clicks create a distance. Distances
/// are kept and follow the motion until they are cleared or another body is shown.
///
/// Distances belong to the window: they are neither saved with the project nor part of undo.
class DistanceTool {
public:
    /// Handles clicks and draws. Call it after draw_viewport(), within the view's window.
    void update(PanelContext& context, const viewport::DrawnScene& scene, viewport::ViewportState& view);
    /// Removes all distances.
    void clear();

    /// Finished distances, in the order in which they were measured.
    const std::vector<MeasuredDistance>& distances() const { return distances_; }

private:
    /// Starts or completes a distance at the place under the mouse.
    void take_click(const PanelContext& context, const viewport::DrawnScene& scene,
                    const viewport::ViewportState& view);

    std::vector<MeasuredDistance> distances_;           // the finished ones
    std::optional<commands::PickedPlace> begun_;        // first end of a distance whose second end is not set
    std::shared_ptr<const commands::Scene> scene_;      // scene of the distances
    std::shared_ptr<const commands::MeshedBody> body_;  // body of the distances
};

}  // namespace myo::ui::panels
