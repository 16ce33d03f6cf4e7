#pragma once

#include "panels/panel.hpp"
#include "plot/plot.hpp"

namespace myo::ui::panels {

/// Shows a search while it runs and afterwards: its parameters, and error, loss and gradient over the evaluations.
///
/// Emits nothing. Comes to the front with the task Fit. Item names begin with "search/".
class SearchPanel : public Panel {
public:
    std::string name() const override { return "search"; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::strip; }
    std::optional<commands::Task> task() const override { return commands::Task::fit; }
    void draw(PanelContext& context) override;

private:
    /// Number of evaluations, target, and table of the searched values. `starts`: with a column of start values.
    void draw_values(PanelContext& context, bool starts);
    /// Error, loss and gradient over the evaluations: the first `curves` of them, side by side.
    void draw_curves(PanelContext& context, int curves);
    /// @param what  words for the loss, with its formula
    /// Length of the gradient over the evaluations.
    ///
    void draw_gradient(PanelContext& context, const std::string& what, const ImVec2& size);
    /// @param tip  tooltip of the title
    /// @param size  [pixels]
    /// One of the plots over the evaluations.
    ///
    void draw_curve(PanelContext& context, const plot::Plot& plot, const std::string& tip, const ImVec2& size,
                    plot::PlotState& plot_state);

    plot::LinkedAxis evaluations_;             // x axis of the three plots
    plot::PlotState error_, loss_, gradient_;  // one per plot
    plot::HiddenSeries hidden_;                // none can be hidden: the plots have no legend
};

}  // namespace myo::ui::panels
