#pragma once

#include "panels/widgets.hpp"

namespace myo::ui::panels {

/// Task Fit: which values of the material a calibration finds.
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
};

}  // namespace myo::ui::panels
