#pragma once

#include <string>

#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// Task Material: parts of the body with a material of their own.
///
/// Emits EditDeclaration, PaintPart, ChangeBrush and ChangeView. Item names begin with "part/".
class PartPanel : public Panel {
public:
    std::string name() const override { return "part"; }
    std::string title() const override { return "Parts"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Task> task() const override { return commands::Task::material; }
    bool offered(const commands::WorkbenchState& state) const override {
        return state.scene && state.scene->is_experiment;
    }
    void draw(PanelContext& context) override;

private:
    /// Heading of a part and, while it is open, its name, place and material. `index`: in Scene::parts.
    void draw_part(PanelContext& context, std::size_t index);
    /// Row of the name; emitted when the field is left.
    void draw_name(PanelContext& context, std::size_t index);
    /// Rows of modulus, Poisson's ratio, density and damping, and what a fit finds of them.
    void draw_material(PanelContext& context, std::size_t index);

    std::string typed_name_;          // of the open part, while it is typed
    std::ptrdiff_t named_part_ = -1;  // part to which the typed name belongs
    NumberEdits edits_;               // edits in progress in the fields of the open part
};

}  // namespace myo::ui::panels
