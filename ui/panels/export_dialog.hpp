#pragma once

#include "panels/panel.hpp"

namespace myo::ui::panels {

/// Dialog that writes the shown body for other programs: ParaView (VTU), printing and CAD (STL), viewers (glTF). The
/// file browser then asks for the name.
///
/// Requests a file dialog that emits ExportBody. Item names begin with "export/".
class ExportDialog {
public:
    /// Opens the dialog.
    void open() { open_ = true; }
    /// Draws the dialog while it is open.
    void draw(PanelContext& context);

private:
    /// Tabs of the file formats.
    void draw_formats(PanelContext& context);
    /// Rows that depend on the format.
    void draw_options(PanelContext& context);
    /// Row that says what the file will contain: which frames, with which field.
    void draw_content(PanelContext& context) const;
    /// Requests the dialog for the file. The name of the trial, or else of the scene, is proposed.
    void ask_for_file(PanelContext& context) const;

    bool open_ = false;
    commands::ShapeExport what_;  // as chosen; the path is set by the file dialog
};

}  // namespace myo::ui::panels
