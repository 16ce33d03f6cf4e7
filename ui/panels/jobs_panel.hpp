#pragma once

#include <imgui.h>

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// The running job, those that wait, and those that have ended, with what they brought.
class JobsPanel : public Panel {
public:
    std::string name() const override { return "jobs"; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::strip; }
    void draw(PanelContext& context) override;

private:
    /// @param size  0: as much as there is
    void draw_list(PanelContext& context, const ImVec2& size);
};

}  // namespace myo::ui::panels
