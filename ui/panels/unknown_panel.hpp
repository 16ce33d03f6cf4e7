#pragma once

#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// Task Fit: which values a calibration finds, and within which bounds.
///
/// Emits EditDeclaration. Item names begin with "unknown/".
class UnknownPanel : public Panel {
public:
    std::string name() const override { return "unknown"; }
    std::string title() const override { return "Unknown values"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Task> task() const override { return commands::Task::fit; }
    bool offered(const commands::WorkbenchState& state) const override {
        return state.scene && state.scene->is_experiment;
    }
    void draw(PanelContext& context) override;

private:
    NumberEdits edits_;  // of bounds and tolerances
};

}  // namespace myo::ui::panels
