#pragma once

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// Task Run: shows the result of the last run with its problems, warnings, checks and errors.
///
/// Emits ChooseTrial. The buttons that start a run are in draw_run_controls(). Item names begin with "run/".
class RunPanel : public Panel {
public:
    std::string name() const override { return "run"; }
    std::string title() const override { return "Result"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Task> task() const override { return commands::Task::run; }
    void draw(PanelContext& context) override;

private:
    /// Errors of all trials, and the time that the run took.
    void draw_errors(PanelContext& context);
};

/// Draws progress and the buttons that start, pause and cancel jobs. Always visible at the foot of the side panel,
/// except while an import is edited.
void draw_run_controls(PanelContext& context);

}  // namespace myo::ui::panels
