#pragma once

#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// Task Mesh: edits element type and edge length, shows the expected size and cost, builds the mesh and reports its
/// quality.
///
/// Emits ChangeSettings and BuildMesh. The mesh is not built automatically after an edit, as it may take long. Item
/// names begin with "body/".
class MeshPanel : public Panel {
public:
    std::string name() const override { return "mesh"; }
    std::string title() const override { return "Mesh"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Task> task() const override { return commands::Task::mesh; }
    void draw(PanelContext& context) override;

private:
    /// Controls for element type and edge length, and the button that builds the mesh.
    void draw_mesh_settings(PanelContext& context);
    /// Elements and degrees of freedom, counted or predicted, and the time per step that follows.
    void draw_mesh_size(PanelContext& context);
    /// Edge length of the elements: 3 to 120 elements along the longest side of the body.
    void draw_resolution(PanelContext& context);
    /// Measured or predicted time per step of a mesh with `dofs` degrees of freedom. Draws nothing if the size is
    /// unknown.
    void draw_step_cost(PanelContext& context, double dofs);
    /// Size and quality of the mesh that is shown.
    void draw_report(PanelContext& context);

    NumberEdits edit_;  // edit in progress in the number field
    OpenEdit slide_;    // drag in progress in the slider
};

}  // namespace myo::ui::panels
