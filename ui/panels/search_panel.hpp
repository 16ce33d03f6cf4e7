#pragma once

#include "panels/panel.hpp"
#include "plot/plot.hpp"

namespace myo::ui::panels {

/// A search while it runs, and after: its parameters, how the loss fell and the gradient with it.
class SearchPanel : public Panel {
public:
    std::string name() const override { return "search"; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::strip; }
    std::optional<commands::Step> step() const override { return commands::Step::fit; }
    void draw(PanelContext& context) override;

private:
    void draw_values(PanelContext& context, bool starts);  // start values beside the best

    plot::LinkedAxis evaluations_;
    plot::PlotState error_, loss_, gradient_;
    plot::HiddenSeries hidden_;
};

}  // namespace myo::ui::panels
