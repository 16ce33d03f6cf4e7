#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "commands/picked_place.hpp"
#include "panels/panel.hpp"
#include "viewport/viewport.hpp"

namespace myo::ui::panels {

/// Shows the properties of the place that the user clicks in the view, on the body or a marker. A click elsewhere or
/// Escape closes the card. Clicking a marker also selects it for the plots.
///
/// The picked place moves with the body, so the card follows the motion. It is dropped when another body is shown.
class InspectTool {
public:
    /// Handles clicks and draws card and highlight. Call it after the view and after the other tools, which take clicks
    /// first.
    void update(PanelContext& context, const viewport::DrawnScene& scene, const viewport::ViewportState& view);

    /// The picked place; empty: none.
    const std::optional<commands::PickedPlace>& picked() const { return picked_; }

private:
    /// Picks the place under the mouse and selects its marker.
    void click(PanelContext& context, const viewport::DrawnScene& scene, const viewport::ViewportState& view);
    /// Marks the picked marker, or the picked cell and its nearest node.
    void draw_highlight(const PanelContext& context, const viewport::DrawnScene& scene,
                        const viewport::ViewportState& view) const;
    /// Draws the card with the properties of the picked place.
    void draw_card(PanelContext& context, const viewport::DrawnScene& scene, const viewport::ViewportState& view);
    /// Error of the picked marker in the shown run; null if there is none.
    const commands::MarkerError* error_of(const commands::WorkbenchState& state);

    std::optional<commands::PickedPlace> picked_;       // empty: nothing is picked
    std::shared_ptr<const commands::Scene> scene_;      // of picked_
    std::shared_ptr<const commands::MeshedBody> body_;  // of picked_
    std::shared_ptr<const commands::RunResult> run_;    // run of errors_
    int trial_ = -1;                                    // trial of errors_
    std::vector<commands::MarkerError> errors_;         // of all markers in the shown trial
    platform::Rectangle card_;                          // rectangle of the card in the last frame
};

}  // namespace myo::ui::panels
