#pragma once

#include <imgui.h>

#include <memory>
#include <optional>
#include <vector>

#include "commands/picked_place.hpp"
#include "panels/panel.hpp"
#include "viewport/viewport.hpp"

namespace myo::ui::panels {

/// A length between two places that move.
struct MeasuredDistance {
    commands::PickedPlace from, to;
    double now_m = 0.0;  // NaN while an end is not drawn
    double at_rest_m = 0.0;
};

/// Finds how long they are now.
void measure(std::vector<MeasuredDistance>& distances, const viewport::DrawnScene& scene);
void draw_distances(ImDrawList& list, const platform::Theme& theme, const std::vector<MeasuredDistance>& distances,
                    const viewport::DrawnScene& scene, const viewport::ViewportState& view);

/// While the view measures, each two clicks make a distance. They stay, and follow the motion, until they are cleared
/// or the body is another.
class DistanceTool {
public:
    /// After the view.
    void update(PanelContext& context, const viewport::DrawnScene& scene, viewport::ViewportState& view);
    void clear();

    const std::vector<MeasuredDistance>& distances() const { return distances_; }

private:
    std::vector<MeasuredDistance> distances_;
    std::optional<commands::PickedPlace> begun_;
    std::shared_ptr<const commands::Scene> scene_;
    std::shared_ptr<const commands::MeshedBody> body_;
};

}  // namespace myo::ui::panels
