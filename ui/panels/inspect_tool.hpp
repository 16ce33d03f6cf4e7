#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "commands/picked_place.hpp"
#include "panels/panel.hpp"
#include "viewport/viewport.hpp"

namespace myo::ui::panels {

/// A click on the body or a marker tells about it in a corner of the view; a click beside them or Esc ends it. A marker
/// that is clicked is chosen for the plots, too.
class InspectTool {
public:
    /// After the view and the other tools, which take clicks before this one.
    void update(PanelContext& context, const viewport::DrawnScene& scene, const viewport::ViewportState& view);

    const std::optional<commands::PickedPlace>& picked() const { return picked_; }

private:
    void click(PanelContext& context, const viewport::DrawnScene& scene, const viewport::ViewportState& view);
    void draw_highlight(const PanelContext& context, const viewport::DrawnScene& scene,
                        const viewport::ViewportState& view) const;
    void draw_card(PanelContext& context, const viewport::DrawnScene& scene, const viewport::ViewportState& view);
    const commands::MarkerError* error_of(const commands::WorkbenchState& state);

    std::optional<commands::PickedPlace> picked_;
    std::shared_ptr<const commands::Scene> scene_;      // of the picked place
    std::shared_ptr<const commands::MeshedBody> body_;  // of it
    std::shared_ptr<const commands::RunResult> run_;    // of the errors
    int trial_ = -1;
    std::vector<commands::MarkerError> errors_;
    platform::Rectangle card_;  // in the last frame
};

}  // namespace myo::ui::panels
