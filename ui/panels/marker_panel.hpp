#pragma once

#include <array>
#include <set>

#include "panels/panel.hpp"
#include "plot/plot.hpp"

namespace myo {

/// A marker's x, y and z, simulated over measured, with the residual below; other trials over the shown one when asked for.
class MarkerPanel : public Panel {
public:
    std::string name() const override { return "markers"; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::strip; }
    std::optional<Step> step() const override { return Step::measure; }
    void draw(PanelContext& context) override;

private:
    void draw_choice(PanelContext& context);
    void draw_trials(PanelContext& context, bool narrow);
    void draw_legend(PanelContext& context);
    void draw_error(PanelContext& context);
    void draw_component(PanelContext& context, int axis, const ImVec2& size);

    std::array<bool, 3> shown_{true, true, true};
    std::set<int> overlaid_;       // other trials of the scene that are drawn, too
    LinkedAxis time_;
    std::array<PlotState, 3> main_;
    std::array<PlotState, 3> residual_;
    HiddenSeries hidden_;
    std::shared_ptr<const Scene> scene_;   // whose plots are zoomed
    int trial_ = -1;
    int marker_ = -1;
};

}  // namespace myo
