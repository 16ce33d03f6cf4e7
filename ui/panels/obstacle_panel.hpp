#pragma once

#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// Task Body: rigid obstacles that the body may touch.
///
/// Emits EditDeclaration and ChangeView. Item names begin with "obstacle/".
class ObstaclePanel : public Panel {
public:
    std::string name() const override { return "obstacle"; }
    std::string title() const override { return "Obstacles"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Task> task() const override { return commands::Task::body; }
    bool offered(const commands::WorkbenchState& state) const override {
        return state.scene && state.scene->is_experiment;
    }
    void draw(PanelContext& context) override;

private:
    /// Heading of an obstacle and, while it is open, its shape and friction. `index`: in Scene::obstacles.
    void draw_obstacle(PanelContext& context, std::size_t index);

    NumberEdits edits_;  // edits in progress in the fields of the open obstacle
};

}  // namespace myo::ui::panels
