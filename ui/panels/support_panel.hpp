#pragma once

#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// Task Body: where the body is held, and gravity. For a plain mesh: makes an experiment of it.
///
/// Emits EditDeclaration and MakeExperiment. Item names begin with "support/".
class SupportPanel : public Panel {
public:
    std::string name() const override { return "support"; }
    std::string title() const override { return "Support and gravity"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Task> task() const override { return commands::Task::body; }
    bool offered(const commands::WorkbenchState& state) const override { return state.scene != nullptr; }
    void draw(PanelContext& context) override;

private:
    /// Clamp: an end of the body, a box or none; and below it the other supports.
    void draw_support(PanelContext& context);
    /// Direction and components of gravity.
    void draw_gravity(PanelContext& context);

    NumberEdits edits_;  // drag in progress in one of the number fields
};

}  // namespace myo::ui::panels
