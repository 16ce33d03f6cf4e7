#pragma once

#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// Task Fibres: edits the muscles of the body and the settings of the brush that paints them.
///
/// Emits ChangeSettings, ChooseMuscle, Paint and ChangeBrush. The brush itself is PaintTool, signals are edited in
/// SignalPanel. Item names begin with "fibres/".
class FibrePanel : public Panel {
public:
    std::string name() const override { return "fibres"; }
    std::string title() const override { return "Fibres"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Task> task() const override { return commands::Task::fibres; }
    void draw(PanelContext& context) override;

private:
    /// List of the muscles with their painted volume, and the button that adds one.
    void draw_list(PanelContext& context);
    /// Properties of the selected muscle.
    void draw_muscle(PanelContext& context);
    /// Name of the selected muscle. Applied when the field loses the keyboard, so that every letter is not an edit.
    void draw_name(PanelContext& context);
    /// The muscle that the selected one follows, and the ratio.
    void draw_link(PanelContext& context);
    /// Buttons that change the paint as a whole: grow, shrink, straighten, clear; and the one that removes the muscle.
    void draw_paint_actions(PanelContext& context);

    NumberEdits edit_;        // edits in progress in one of the number fields
    std::string typed_name_;  // text in the name field
    bool typing_ = false;     // the name field has the keyboard
};

/// Returns an unpainted muscle with a free name and colour and the body's stiffness. Its signal contracts by a fifth
/// within half a second.
commands::Muscle new_muscle(const commands::Settings& settings);

}  // namespace myo::ui::panels
