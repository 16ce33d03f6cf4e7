#pragma once

#include <string>

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// Writes the results into a folder: pages, tables and an image.
class ReportPanel : public Panel {
public:
    std::string name() const override { return "report"; }
    std::string title() const override { return "Report"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Step> step() const override { return commands::Step::report; }
    void draw(PanelContext& context) override;

private:
    std::string folder_;                            // as edited; empty: nothing can be written
    std::shared_ptr<const commands::Scene> scene_;  // scene for which the folder was proposed
};

}  // namespace myo::ui::panels
