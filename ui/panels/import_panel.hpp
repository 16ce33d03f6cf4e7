#pragma once

#include "panels/number_field.hpp"
#include "panels/panel.hpp"

namespace myo::ui::panels {

/// Task Measure: edits the import of a recording, that is how the file is read, its placement on the body, which label
/// is which marker, and the start of the trial. Shown only during an import.
///
/// Emits ChangeImport, ChooseLabel, ReadRecording, ProposeMarkers and AlignImport. The trial is added by
/// draw_import_controls(). Item names begin with "import/".
class ImportPanel : public Panel {
public:
    std::string name() const override { return "import"; }
    std::string title() const override { return "Import a recording"; }
    PanelPlace place() const override { return PanelPlace::side; }
    std::optional<commands::Task> task() const override { return commands::Task::measure; }
    bool offered(const commands::WorkbenchState& state) const override { return state.import != nullptr; }
    void draw(PanelContext& context) override;

private:
    // Parts of the panel in the order of the work. They change a copy of the choices; draw() emits it once.
    /// File, content, and what the file does not state: unit, rate, meaning of zeros. A change reads the file again.
    void draw_file(PanelContext& context);
    /// Rotation of the cameras' frame to the body.
    void draw_placing(PanelContext& context, commands::ImportChoices& choices);
    /// Table that assigns labels to markers.
    void draw_markers(PanelContext& context, commands::ImportChoices& choices);
    /// Row of one label in that table.
    void draw_label_row(PanelContext& context, std::size_t i, commands::ImportChoices& choices);
    /// Marker of one label, in its cell of the table: a list, or a free name on a plain mesh.
    void draw_name(PanelContext& context, std::size_t label, commands::ImportChoices& choices);
    /// Time in the file that becomes t = 0.
    void draw_start(PanelContext& context, commands::ImportChoices& choices);
    /// Name, role, start and folder of the new trial.
    void draw_trial(PanelContext& context, commands::ImportChoices& choices);

    NumberEdits edit_;  // edit in progress in one of the number fields
};

/// Draws what is missing, and the buttons that finish or cancel the import. Shown at the foot of the side panel.
void draw_import_controls(PanelContext& context);

}  // namespace myo::ui::panels
