#pragma once

#include "commands/muscle_signal.hpp"
#include "commands/signal_shapes.hpp"
#include "panels/widgets.hpp"
#include "plot/plot.hpp"

namespace myo::ui::panels {

/// The signal a(t) of the chosen muscle, as a curve whose knots are dragged: a double click adds one, a right click
/// takes one away.
class SignalPanel : public Panel {
public:
    std::string name() const override { return "signals"; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::strip; }
    std::optional<commands::Step> step() const override { return commands::Step::fibres; }
    void draw(PanelContext& context) override;

private:
    void draw_head(PanelContext& context);
    void draw_generator(PanelContext& context);
    void draw_file(PanelContext& context);
    void draw_curve(PanelContext& context);
    void edit_knots(PanelContext& context, const fibre::Signal& signal, const plot::PlotResult& plot);

    commands::SignalRecipe recipe_;
    std::string recipe_muscle_;  // whose sense the recipe's level has
    OpenEdit edit_;
    plot::LinkedAxis time_;
    plot::PlotState plot_;
    plot::HiddenSeries hidden_;
    std::optional<std::size_t> grabbed_;  // knot that is dragged
    bool moved_ = false;                  // it was moved since it was grabbed
    std::string followed_;                // muscle that the zoom belongs to
};

}  // namespace myo::ui::panels
