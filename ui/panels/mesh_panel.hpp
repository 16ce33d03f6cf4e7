#pragma once

#include "panels/widgets.hpp"

namespace myo::ui::panels {

/// Sets how the body is divided into elements, and says what came out.
class MeshPanel : public Panel {
public:
    std::string name() const override { return "mesh"; }
    std::string title() const override { return "Mesh"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Step> step() const override { return commands::Step::mesh; }
    void draw(PanelContext& context) override;

private:
    void draw_mesh_settings(PanelContext& context);
    /// What a time step of a mesh of this size takes or will take.
    void draw_step_cost(PanelContext& context, double dofs);
    void draw_report(PanelContext& context);

    OpenEdit edit_;
    OpenEdit slide_;
};

}  // namespace myo::ui::panels
