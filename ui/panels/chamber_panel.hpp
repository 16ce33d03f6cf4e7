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
    void draw_pick(PanelContext& context);
    /// Closes the body again once picking has ended.
    void uncut(PanelContext& context);
    void draw_cavity(PanelContext& context, std::size_t cavity);

    NumberEdits edits_;
    NameEdit names_;
    bool cut_ = false;  // picking cut the body open
};

}  // namespace myo::ui::panels
