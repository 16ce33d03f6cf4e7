#pragma once

#include <optional>

#include "chart/chart.hpp"
#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// Popup of the marker plots that repairs the recording of the shown marker over a span of time: cut, fill, swap with
/// another marker, smooth. What was repaired is listed and can be removed.
///
/// Emits EditDeclaration. Item names begin with "repair/".
class RepairPopup {
public:
    /// Draws the button that opens the popup, and the popup.
    ///
    /// @param label  of the button
    /// @param span   selected times of the trial [s]; changed by the fields of the popup
    void draw(PanelContext& context, const char* label, std::optional<chart::Range>& span);

private:
    /// Rows of the first and last time, and a button for the whole trial.
    void draw_span(PanelContext& context, const commands::SceneTrial& trial, std::optional<chart::Range>& span);
    /// Buttons of the repairs. `span`: times of the trial [s].
    void draw_repairs(PanelContext& context, const commands::SceneTrial& trial, const chart::Range& span);
    /// List of the other markers, and the button that exchanges the samples.
    void draw_swap(PanelContext& context, const commands::SceneTrial& trial, const chart::Range& span);
    /// List of the repairs of the trial, each with a button that removes it.
    void draw_made(PanelContext& context, const commands::SceneTrial& trial);

    int with_ = 0;            // index of the marker to swap with
    double window_s_ = 0.05;  // width of the window of smoothing [s]
    NumberEdits edits_;       // edits in progress in the times
};

}  // namespace myo::ui::panels
