#pragma once

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// Task Diagnose: shows the verdict of the diagnosis in words, with confidence, reasons and errors.
///
/// Emits nothing: the diagnosis is started and its rows are selected in DiagnosePanel, below the view. Item names begin
/// with "verdict/".
class VerdictPanel : public Panel {
public:
    std::string name() const override { return "verdict"; }
    std::string title() const override { return "Verdict"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Task> task() const override { return commands::Task::diagnose; }
    void draw(PanelContext& context) override;
};

}  // namespace myo::ui::panels
