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
    void draw_formats(PanelContext& context);
    /// Rows that depend on the format.
    void draw_options(PanelContext& context);
    void draw_content(PanelContext& context) const;
    void ask_for_file(PanelContext& context) const;

    bool open_ = false;
    commands::ShapeExport what_;
};

}  // namespace myo::ui::panels
