#pragma once

#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// Task Run: plays the shown model live, with sliders for what drives it and the spring of the mouse.
///
/// Emits PlayLive, SteerLive and RestartLive. Item names begin with "live/".
class LivePanel : public Panel {
public:
    std::string name() const override { return "live"; }
    std::string title() const override { return "Play live"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Task> task() const override { return commands::Task::run; }
    bool offered(const commands::WorkbenchState& state) const override { return state.scene != nullptr; }
    void draw(PanelContext& context) override;

private:
    void draw_buttons(PanelContext& context);
    void draw_levels(PanelContext& context);
    void draw_spring(PanelContext& context);

    NumberEdits edits_;
    OpenEdit slide_;
};

}  // namespace myo::ui::panels
