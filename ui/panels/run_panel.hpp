#pragma once

#include "panels/panel.hpp"

namespace myo {

/// Starts and stops simulation and calibration, and shows what came out.
class RunPanel : public Panel {
public:
    std::string name() const override { return "run"; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::rail; }
    void draw(PanelContext& context) override;

private:
    void draw_buttons(PanelContext& context);
    void draw_calibration(PanelContext& context);
    void draw_errors(PanelContext& context);
};

/// "42 s", "3 min 5 s", "1 h 2 min"
std::string duration_label(double seconds);

}  // namespace myo
