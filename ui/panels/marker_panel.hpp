#pragma once

#include <array>
#include <set>

#include "panels/panel.hpp"
#include "plot/plot_svg.hpp"

namespace myo::ui::panels {

/// A marker's x, y and z, simulated over measured, with the residual below; other trials over the shown one when asked
/// for.
class MarkerPanel : public Panel {
public:
    std::string name() const override { return "markers"; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::strip; }
    std::optional<commands::Step> step() const override { return commands::Step::measure; }
    void draw(PanelContext& context) override;

private:
    void draw_choice(PanelContext& context);
    void draw_trials(PanelContext& context, bool narrow);
    void draw_legend(PanelContext& context);
    void draw_error(PanelContext& context);
    void draw_export(PanelContext& context, const std::string& name);
    void see(const plot::Plot& plot, const plot::PlotResult& drawn, const plot::HiddenSeries& hidden);
    void draw_component(PanelContext& context, int axis, const ImVec2& size);

    platform::Rectangle plots_;  // of the window, where they were drawn last
    std::array<bool, 3> shown_{true, true, true};
    std::set<int> overlaid_;  // other trials of the scene that are drawn, too
    plot::LinkedAxis time_;
    std::array<plot::PlotState, 3> main_;
    std::array<plot::PlotState, 3> residual_;
    plot::HiddenSeries hidden_;
    std::vector<plot::SeenPlot> seen_;              // as last drawn, for a drawing
    std::shared_ptr<const commands::Scene> scene_;  // whose plots are zoomed
    int trial_ = -1;
    int marker_ = -1;
};

}  // namespace myo::ui::panels
