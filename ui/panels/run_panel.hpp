#pragma once

#include "panels/panel.hpp"

namespace myo {

/// Shows what a simulation or calibration gave.
class RunPanel : public Panel {
public:
    std::string name() const override { return "run"; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::rail; }
    void draw(PanelContext& context) override;

private:
    void draw_calibration(PanelContext& context);
    void draw_errors(PanelContext& context);
};

/// Buttons that start and stop work, with its progress; always in sight at the foot of the rail.
void draw_run_controls(PanelContext& context);

/// "42 s", "3 min 5 s", "1 h 2 min"
std::string duration_label(double seconds);

}  // namespace myo
