#pragma once

#include <array>
#include <set>

#include "panels/panel.hpp"
#include "panels/repair_popup.hpp"
#include "plot/plot_svg.hpp"

namespace myo::ui::panels {

/// Plots the selected marker in x, y and z: measured and simulated, with the residual below. Other trials can be drawn
/// over the shown one, and ended jobs that are compared are included. A popup repairs the recording.
///
/// Emits ChooseMarker, SetTime and EditDeclaration; requests dialogs for the export. Comes to the front with the task
/// Measure. Item names begin with "markers/", "plot/" and "residual/".
class MarkerPanel : public Panel {
public:
    std::string name() const override { return "markers"; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::strip; }
    std::optional<commands::Task> task() const override { return commands::Task::measure; }
    void draw(PanelContext& context) override;

private:
    // Parts of the panel: controls first, then one plot per coordinate.
    /// Line of controls: marker, coordinates, trials, zoom, export and repair.
    void draw_choice(PanelContext& context);
    /// A trial in the popup of draw_trials(), with the box that draws it.
    void draw_trial_row(PanelContext& context, std::size_t t);
    /// Popup that selects the other trials. `narrow`: buttons show icons.
    void draw_trials(PanelContext& context, bool narrow);
    /// One legend for all plots, used while other trials are drawn.
    void draw_legend(PanelContext& context);
    /// Error of the marker, or its error in the selected time range.
    void draw_error(PanelContext& context);
    /// Popup with the ways to save what is seen. `name` is the proposed file name.
    void draw_export(PanelContext& context, const std::string& name);
    /// Colour of another trial, chosen far in hue from measured, simulated and residual in both themes.
    static const ImVec4& overlay_color(const platform::Theme& theme, std::size_t trial);
    /// Shows all data again in all plots.
    void show_all();
    /// Resets zoom and selection where another curve is shown. Those of an edited scene with the same trial stay.
    void follow(const commands::WorkbenchState& state);
    /// Plot of the residual below that of the motion. `strip` has the curves; `size` in pixels.
    void draw_residual(PanelContext& context, int axis, plot::Plot strip, const ImVec2& size);
    /// Plot of one coordinate with its residual below. `size` in pixels.
    void draw_component(PanelContext& context, int axis, const ImVec2& size);

    platform::Rectangle plots_;                     // area of the plots in the last frame, for export as PNG
    std::array<bool, 3> shown_{true, true, true};   // x, y, z
    std::set<int> overlaid_;                        // indices of other trials that are drawn, too
    RepairPopup repair_;                            // of the shown marker's recording
    plot::LinkedAxis time_;                         // time axis of all plots
    std::array<plot::PlotState, 3> main_;           // per coordinate
    std::array<plot::PlotState, 3> residual_;       // per coordinate
    plot::HiddenSeries hidden_;                     // curves switched off in the legend
    std::vector<chart::Chart> seen_;                // plots of the last frame, for export as SVG
    std::shared_ptr<const commands::Scene> scene_;  // scene of the zoom
    int trial_ = -1;                                // trial of the zoom
    int marker_ = -1;                               // marker of the zoom
};

}  // namespace myo::ui::panels
