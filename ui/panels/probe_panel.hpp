#pragma once

#include "panels/name_row.hpp"
#include "panels/number_field.hpp"

namespace myo::ui::panels {

/// Task Measure: the declared markers and probes, their places and names, and the switch that lets clicks in the view
/// set them.
///
/// Emits EditDeclaration and ChooseMarker. Item names begin with "probe/".
class ProbePanel : public Panel {
public:
    std::string name() const override { return "probe"; }
    std::string title() const override { return "Markers and probes"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Task> task() const override { return commands::Task::measure; }
    bool offered(const commands::WorkbenchState& state) const override {
        return state.scene && state.scene->is_experiment && !state.import;
    }
    void draw(PanelContext& context) override;

private:
    /// Switch of the tool, and the name of what is added next.
    void draw_placing(PanelContext& context);
    /// All markers and probes; a click selects one. Scrolls beyond eight.
    void draw_list(PanelContext& context);
    /// Name, place and recording of the selected one, and the button that removes it.
    void draw_marker(PanelContext& context, const commands::SceneMarker& marker);
    /// Whether recordings hold the marker, and under which label.
    void draw_recorded(PanelContext& context, const commands::SceneMarker& marker);

    NumberEdits edits_;  // edits in progress in the places and the stand-off
    NameEdit names_;     // of name and label
};

}  // namespace myo::ui::panels
