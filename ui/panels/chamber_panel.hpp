#pragma once

#include "panels/name_row.hpp"
#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// Task Fibres: closed cavities of the body, which become chambers, and their pressure in the shown trial.
///
/// Emits EditDeclaration and ChangeView. Item names begin with "chamber/".
class ChamberPanel : public Panel {
public:
    std::string name() const override { return "chamber"; }
    std::string title() const override { return "Chambers"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Task> task() const override { return commands::Task::fibres; }
    bool offered(const commands::WorkbenchState& state) const override {
        return state.scene && state.scene->is_experiment;
    }
    void draw(PanelContext& context) override;

private:
    /// Switch of the tool that picks a cavity in the view, with the body cut open. Draws nothing if all cavities are
    /// chambers.
    void draw_pick(PanelContext& context);
    /// Closes the body again once picking has ended.
    void uncut(PanelContext& context);
    /// A cavity by its index in DeclaredParts::cavities: rows of its chamber, or the button that makes it one.
    void draw_cavity(PanelContext& context, std::size_t cavity);

    NumberEdits edits_;  // of the pressures
    NameEdit names_;     // of the chambers
    bool cut_ = false;   // picking cut the body open
};

}  // namespace myo::ui::panels
