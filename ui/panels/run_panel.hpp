#pragma once

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// Shows what the last run gave.
class RunPanel : public Panel {
public:
    std::string name() const override { return "run"; }
    std::string title() const override { return "Result"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Step> step() const override { return commands::Step::run; }
    void draw(PanelContext& context) override;

private:
    void draw_errors(PanelContext& context);
};

/// Buttons that start and stop work, with its progress; always in sight at the foot of the side.
void draw_run_controls(PanelContext& context);

}  // namespace myo::ui::panels
