#pragma once

#include "panels/widgets.hpp"

namespace myo::ui::panels {

/// Starts searches: calibration of parameters, and optimisation of muscle signals with which the markers follow a
/// trial. Shows the values found.
class FitPanel : public Panel {
public:
    std::string name() const override { return "fit"; }
    std::string title() const override { return "Fit"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Step> step() const override { return commands::Step::fit; }
    void draw(PanelContext& context) override;

private:
    void draw_calibrate(PanelContext& context);
    void draw_optimize(PanelContext& context);
    void draw_found(PanelContext& context);

    OpenEdit edit_;
};

}  // namespace myo::ui::panels
