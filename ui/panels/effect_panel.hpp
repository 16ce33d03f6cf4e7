#pragma once

#include <string>

#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// Task Fit: effects of the model, those that the experiment declares and those that were added to it: their values,
/// whether a run has them, and the catalogue to add others.
///
/// Emits EditDeclaration, ChangeSettings and ChangeView. Item names begin with "effect/".
class EffectPanel : public Panel {
public:
    std::string name() const override { return "effect"; }
    std::string title() const override { return "Effects"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Task> task() const override { return commands::Task::fit; }
    bool offered(const commands::WorkbenchState& state) const override { return state.scene != nullptr; }
    void draw(PanelContext& context) override;

private:
    /// An effect of the experiment's declaration by its index. Switched off, it stays declared: the settings leave it
    /// out.
    void draw_declared(PanelContext& context, std::size_t index);
    /// An effect that the settings add to the experiment or to a plain mesh, by its index in Settings::effects.
    void draw_added(PanelContext& context, std::size_t index);
    /// Button that opens the catalogue, and the catalogue.
    void draw_catalogue(PanelContext& context);

    bool adding_ = false;  // the catalogue is open
    std::string wanted_;   // text that entries of the catalogue must contain
    NumberEdits edits_;    // edits in progress in the fields of the open effect
};

}  // namespace myo::ui::panels
