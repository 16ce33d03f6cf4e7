#pragma once

#include <string>

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// Task Report: writes the results into a folder as pages, tables and an image.
///
/// Emits WriteReport and requests the image from the window. Lists beforehand what will be written. Item names begin
/// with "report/".
class ReportPanel : public Panel {
public:
    std::string name() const override { return "report"; }
    std::string title() const override { return "Report"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Task> task() const override { return commands::Task::report; }
    void draw(PanelContext& context) override;

private:
    /// Field of the folder, and the button that chooses one.
    void draw_folder(PanelContext& context);

    std::string folder_;                            // as edited; empty: nothing can be written
    std::shared_ptr<const commands::Scene> scene_;  // scene for which the folder was proposed
};

}  // namespace myo::ui::panels
