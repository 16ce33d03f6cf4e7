#pragma once

#include "panels/name_row.hpp"
#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// Task Fibres: tendons, their guides, drive, friction, and their command in the shown trial.
///
/// Emits EditDeclaration. Item names begin with "tendon/".
class TendonPanel : public Panel {
public:
    std::string name() const override { return "tendon"; }
    std::string title() const override { return "Tendons"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Task> task() const override { return commands::Task::fibres; }
    bool offered(const commands::WorkbenchState& state) const override {
        return state.scene && state.scene->is_experiment;
    }
    void draw(PanelContext& context) override;

private:
    /// Switch of the tool that draws a new tendon.
    void draw_new(PanelContext& context);
    /// Rows of a tendon by its index in the declaration.
    void draw_tendon(PanelContext& context, std::size_t tendon);
    /// What the motor prescribes, stiffness and friction of the thread.
    void draw_drive(PanelContext& context, std::size_t tendon);
    /// Rows of the guides, and the switch that lets them be dragged.
    void draw_guides(PanelContext& context, std::size_t tendon);

    NumberEdits edits_;       // edits in progress in all number fields
    NameEdit names_;          // of the name
    std::size_t chosen_ = 0;  // tendon that is shown
    double depth_m_ = 0.0;    // of new guides below the surface [m]
};

}  // namespace myo::ui::panels
