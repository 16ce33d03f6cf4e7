#pragma once

#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// Task Run: trials of the experiment, and the loads of the shown one.
///
/// Emits EditDeclaration and ChooseTrial. Item names begin with "trial/".
class TrialPanel : public Panel {
public:
    std::string name() const override { return "trial"; }
    std::string title() const override { return "Trials and loads"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Task> task() const override { return commands::Task::run; }
    bool offered(const commands::WorkbenchState& state) const override {
        return state.scene && state.scene->is_experiment && !state.scene->trials.empty();
    }
    void draw(PanelContext& context) override;

private:
    /// Buttons that add, copy and remove trials.
    void draw_list(PanelContext& context);
    /// Name and duration of the shown trial.
    void draw_trial(PanelContext& context);
    /// Whether the recording is fitted or predicted.
    void draw_role(PanelContext& context);
    /// Time after which the recording is not used.
    void draw_recording_end(PanelContext& context);
    /// Loads of the shown trial, and buttons that add one.
    void draw_loads(PanelContext& context);

    std::string typed_name_;  // of the shown trial, while it is typed
    int named_trial_ = -1;    // trial to which the typed name belongs
    NumberEdits edits_;       // drag in progress in one of the number fields
};

}  // namespace myo::ui::panels
