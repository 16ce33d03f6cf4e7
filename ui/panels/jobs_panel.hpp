#pragma once

#include <imgui.h>

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// Lists the running job, waiting jobs, and ended jobs with their results, newest first.
///
/// Emits Pause, Cancel, Unqueue, CompareRecord, RestoreRecord and ForgetRecord. Item names begin with "jobs/".
class JobsPanel : public Panel {
public:
    std::string name() const override { return "jobs"; }
    std::string title() const override;
    PanelPlace place() const override { return PanelPlace::strip; }
    void draw(PanelContext& context) override;

private:
    /// @param size  of the list [pixels]; 0: the available size
    /// Table of all jobs.
    ///
    void draw_list(PanelContext& context, const ImVec2& size);
};

}  // namespace myo::ui::panels
