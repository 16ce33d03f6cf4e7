#pragma once

#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// Task Fit: the goals of the shown trial, places of markers at times that Optimise follows instead of a recording.
///
/// Emits EditDeclaration and ChooseMarker. GoalTool draws the goals in the view and moves them. Item names begin with
/// "goal/".
class GoalPanel : public Panel {
public:
    std::string name() const override { return "goal"; }
    std::string title() const override { return "Goals"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Task> task() const override { return commands::Task::fit; }
    bool offered(const commands::WorkbenchState& state) const override {
        return state.scene && state.scene->is_experiment && state.scene_trial() && !state.scene->markers.empty();
    }
    void draw(PanelContext& context) override;

private:
    /// Heading with *Remove*, place, times and weight of a goal.
    void draw_goal(PanelContext& context, std::size_t index);
    /// Row of a number of a goal. `key`: in the declaration.
    void draw_number(PanelContext& context, std::size_t index, const char* key, const NumberField& field, double value);
    /// Buttons that add or remove a point of its path at the shown time.
    void draw_path_buttons(PanelContext& context, std::size_t index);
    /// The marker and the button that adds a goal for it.
    void draw_add(PanelContext& context);

    NumberEdits edits_;  // edits in progress in the fields of all goals
};

}  // namespace myo::ui::panels
