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
    /// Buttons that start, stop and restart the play.
    void draw_buttons(PanelContext& context);
    /// Number and slider of the level of each actuator.
    void draw_levels(PanelContext& context);
    /// Stiffness of the spring by which the mouse pulls the body.
    void draw_spring(PanelContext& context);

    NumberEdits edits_;  // edits in progress in the number fields
    OpenEdit slide_;     // drag in progress in one of the sliders
};

}  // namespace myo::ui::panels
