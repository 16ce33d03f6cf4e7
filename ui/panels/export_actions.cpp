#include "panels/export_actions.hpp"

#include "panels/file_dialogs.hpp"

namespace myo::ui::panels {

void add_export_actions(std::vector<Action>& all) {
    // Actions only request dialogs; the commands follow when a name is chosen.
    all.push_back({"file.save_whole",
                   "File",
                   "Save project with its files\xe2\x80\xa6",
                   {},
                   [](PanelContext& context, viewport::ViewportState&) {
                       context.window.file = self_contained_dialog(context.state);
                   },
                   [](const commands::WorkbenchState& s) { return s.scene != nullptr; }});
    all.push_back({"file.save_experiment",
                   "File",
                   "Save experiment as\xe2\x80\xa6",
                   {},
                   [](PanelContext& context, viewport::ViewportState&) {
                       context.window.file = experiment_copy_dialog(context.state.scene->path);
                   },
                   [](const commands::WorkbenchState& s) { return s.scene && s.scene->is_experiment; },
                   {},
                   true});
    all.push_back({"file.export",
                   "File",
                   "Export the body\xe2\x80\xa6",
                   {},
                   [](PanelContext& context, viewport::ViewportState&) { context.window.export_body = true; },
                   [](const commands::WorkbenchState& s) { return s.body != nullptr; }});
}

}  // namespace myo::ui::panels
