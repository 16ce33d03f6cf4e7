#include "panels/actions.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "commands/field_store.hpp"
#include "panels/escape.hpp"
#include "panels/export_actions.hpp"
#include "panels/file_dialogs.hpp"
#include "panels/help_actions.hpp"
#include "platform/input_queue.hpp"

namespace myo::ui::panels {
namespace {

/// Members of each Action below, in order: id, menu, label, shortcut {key, ctrl, shift, label}, perform, enabled,
/// checked, separated. Members at the end that have their default value are left out.
using Enabled = std::function<bool(const commands::WorkbenchState&)>;

/// Conditions that several actions share.
Enabled with_scene() {
    return [](const commands::WorkbenchState& s) { return s.scene != nullptr; };
}
Enabled working() {
    return [](const commands::WorkbenchState& s) { return s.busy(); };
}

/// Action that only emits a command.
template <class Asked>
std::function<void(PanelContext&, viewport::ViewportState&)> emits(Asked asked) {
    return [asked](PanelContext& context, viewport::ViewportState&) { context.emit(asked); };
}

/// Sets the scale of text and controls to the next larger or smaller of round ones.
void rescale(PanelContext& context, bool larger) {
    static constexpr std::array<float, 9> scales{commands::min_scale,     0.9f, 1.0f, 1.1f, 1.25f, 1.5f, 1.75f, 2.0f,
                                                 commands::greatest_scale};
    // A scale between two of them, as the screen suggests, goes to its neighbours.
    constexpr float near = 0.01f;
    const float now = context.state.scale();
    float next = larger ? scales.back() : scales.front();
    for (const float scale : scales) {
        if (larger && scale > now + near) next = std::min(next, scale);
        if (!larger && scale < now - near) next = std::max(next, scale);
    }
    context.emit(commands::SetTheme{context.state.preferences.theme, next});
}

/// Opening and saving of the project.
void add_project_actions(std::vector<Action>& all) {
    all.push_back({"file.open",
                   "File",
                   "Open\xe2\x80\xa6",
                   {platform::key_o, true, false, "Ctrl+O"},
                   [](PanelContext& context, viewport::ViewportState&) {
                       // Starts where the open file is, as related files are often next to it.
                       context.window.file = open_dialog(context.state.scene ? context.state.scene->path
                                                                             : std::filesystem::path());
                   }});
    all.push_back({"file.save",
                   "File",
                   "Save project",
                   {platform::key_s, true, false, "Ctrl+S"},
                   emits(commands::Save{}),
                   with_scene()});
    all.push_back({"file.save_as",
                   "File",
                   "Save project as\xe2\x80\xa6",
                   {platform::key_s, true, true, "Ctrl+Shift+S"},
                   emits(commands::AskWhereToSave{}),
                   with_scene()});
}

/// Menu File. Dialogs are requested from the window; saving is a command, as the workbench decides whether to ask for a
/// name.
void add_file_actions(std::vector<Action>& all) {
    add_project_actions(all);
    all.push_back({"file.import",
                   "File",
                   "Import a recording\xe2\x80\xa6",
                   {},
                   [](PanelContext& context, viewport::ViewportState&) {
                       context.window.file = recording_dialog(context.state.scene->path);
                   },
                   with_scene(),
                   {},
                   true});
    add_export_actions(all);
    all.push_back({"file.picture",
                   "File",
                   "Save picture or film\xe2\x80\xa6",
                   {},
                   [](PanelContext& context, viewport::ViewportState&) { context.window.save_view = true; },
                   with_scene()});
    all.push_back(
        {"file.quit", "File", "Quit", {platform::key_q, true, false, "Ctrl+Q"}, emits(commands::Quit{}), {}, {}, true});
}

void add_undo_actions(std::vector<Action>& all) {
    // Undo and redo are available only if there is an entry; the workbench keeps that in its state.
    all.push_back({"edit.undo",
                   "Edit",
                   "Undo",
                   {ImGuiKey_Z, true, false, "Ctrl+Z"},
                   emits(commands::Undo{}),
                   [](const commands::WorkbenchState& s) { return s.can_undo; }});
    all.push_back({"edit.redo",
                   "Edit",
                   "Redo",
                   {ImGuiKey_Y, true, false, "Ctrl+Y"},
                   emits(commands::Redo{}),
                   [](const commands::WorkbenchState& s) { return s.can_redo; }});
}

/// Switches a tool of the brush on; pressing the shortcut of the active tool again returns to the camera.
std::function<void(PanelContext&, viewport::ViewportState&)> toggles(commands::BrushTool tool) {
    return [tool](PanelContext& context, viewport::ViewportState&) {
        commands::BrushSettings brush = context.state.brush;
        // A brush that is put away begins again with the muscle; parts are chosen in their panel.
        if (brush.tool == commands::BrushTool::none) brush.part = -1;
        brush.tool = brush.tool == tool ? commands::BrushTool::none : tool;
        context.emit(commands::ChangeBrush{brush});
        // The settings of the brush are in the task of what it paints, so that task is shown.
        if (brush.tool != commands::BrushTool::none)
            context.window.task = brush.part < 0 ? commands::Task::fibres : commands::Task::material;
    };
}

/// Menu Edit. Painting and erasing need a selected muscle.
void add_edit_actions(std::vector<Action>& all) {
    add_undo_actions(all);
    const auto has_muscle = [](const commands::WorkbenchState& s) { return s.chosen_muscle() || s.brush.part >= 0; };
    // State of the menu entry: the tick shows the tool that is active.
    const auto holds = [](commands::BrushTool tool) {
        return [tool](const commands::WorkbenchState& s) { return s.brush.tool == tool; };
    };
    all.push_back({"edit.paint",
                   "Edit",
                   "Paint the muscle",
                   {platform::key_b, false, false, "B"},
                   toggles(commands::BrushTool::add),
                   has_muscle,
                   holds(commands::BrushTool::add),
                   true});
    all.push_back({"edit.erase",
                   "Edit",
                   "Erase the muscle",
                   {platform::key_e, false, false, "E"},
                   toggles(commands::BrushTool::erase),
                   has_muscle,
                   holds(commands::BrushTool::erase)});
}

/// Directions and shortcuts are those of the buttons in the view.
void add_direction_actions(std::vector<Action>& all) {
    struct Look {
        const char* id;
        const char* label;
        int key;
        const char* keys;
        viewport::StandardView view;
    };
    static constexpr Look looks[] = {
        {"view.oblique", "Oblique view", platform::key_0, "0", viewport::StandardView::oblique},
        {"view.x", "View along x", platform::key_1, "1", viewport::StandardView::from_x},
        {"view.y", "View along y", platform::key_2, "2", viewport::StandardView::from_y},
        {"view.z", "View along z", platform::key_3, "3", viewport::StandardView::from_z}};
    for (const Look& look : looks)
        all.push_back({look.id,
                       "View",
                       look.label,
                       {look.key, false, false, look.keys},
                       [look](PanelContext&, viewport::ViewportState& view) {
                           view.camera = viewport::turn_to_or_round(view.camera, look.view);
                           view.zoom_to_data_requested = true;
                       },
                       with_scene(),
                       {},
                       look.view == viewport::StandardView::oblique});
}

/// Colours the body by the quantity after the shown one; after the last one: by none.
void show_next_field(PanelContext& context, viewport::ViewportState&) {
    const std::vector<commands::FieldKind> kinds = commands::field_kinds(context.backend);
    commands::ViewOptions view = context.state.view;
    const auto shown = std::find_if(kinds.begin(), kinds.end(),
                                    [&](const commands::FieldKind& kind) { return kind.id == view.field; });
    const auto next = shown == kinds.end() ? kinds.begin() : std::next(shown);
    view.field = next != kinds.end() ? next->id : "";
    context.emit(commands::ChangeView{view});
}

void add_distance_actions(std::vector<Action>& all) {
    all.push_back({"view.distance",
                   "View",
                   "Measure distances",
                   {platform::key_d, false, false, "D"},
                   [](PanelContext& context, viewport::ViewportState& view) {
                       view.measuring = !view.measuring;
                       commands::BrushSettings brush = context.state.brush;
                       // A click can either measure or paint.
                       brush.tool = commands::BrushTool::none;
                       // Switching measuring off leaves the tool as it is.
                       if (view.measuring) context.emit(commands::ChangeBrush{brush});
                   },
                   with_scene(),
                   {},
                   true});
    all.push_back({"view.clear_distances",
                   "View",
                   "Clear the distances",
                   {},
                   [](PanelContext& context, viewport::ViewportState&) { context.window.clear_distances = true; },
                   with_scene()});
}

/// Theme, size of text and layout of the window.
void add_appearance_actions(std::vector<Action>& all) {
    // The theme has two values, so the action is a toggle with a tick for the light one.
    all.push_back({"view.theme",
                   "View",
                   "Light colours",
                   {},
                   [](PanelContext& context, viewport::ViewportState&) {
                       const bool dark = context.state.preferences.theme == platform::ThemeName::dark;
                       // The scale is part of the same command and must be kept.
                       context.emit(commands::SetTheme{dark ? platform::ThemeName::light : platform::ThemeName::dark,
                                                       context.state.scale()});
                   },
                   {},
                   [](const commands::WorkbenchState& s) { return s.preferences.theme == platform::ThemeName::light; },
                   true});
    all.push_back({"view.larger",
                   "View",
                   "Larger text",
                   {platform::key_plus, true, false, "Ctrl++"},
                   [](PanelContext& context, viewport::ViewportState&) { rescale(context, true); }});
    all.push_back({"view.smaller",
                   "View",
                   "Smaller text",
                   {platform::key_minus, true, false, "Ctrl+\xe2\x88\x92"},
                   [](PanelContext& context, viewport::ViewportState&) { rescale(context, false); }});
    all.push_back({"view.reset_layout", "View", "Reset the layout", {}, emits(commands::SetLayout{})});
}

/// Menu View. These actions change the camera or the view options; both leave the model as it is.
void add_view_actions(std::vector<Action>& all) {
    all.push_back({"view.fit",
                   "View",
                   "Show the whole motion",
                   {platform::key_f, false, false, "F"},
                   [](PanelContext&, viewport::ViewportState& view) { view.zoom_to_data_requested = true; },
                   with_scene()});
    add_direction_actions(all);
    all.push_back(
        {"view.orthographic",
         "View",
         "Parallel projection",
         {platform::key_4, false, false, "4"},
         [](PanelContext&, viewport::ViewportState& view) { view.camera.orthographic = !view.camera.orthographic; },
         with_scene()});
    all.push_back({"view.next_field",
                   "View",
                   "Colour by the next quantity",
                   {},
                   show_next_field,
                   with_scene(),
                   [](const commands::WorkbenchState& s) { return !s.view.field.empty(); }});
    add_distance_actions(all);
    add_appearance_actions(all);
}

/// Calibration, optimisation and diagnosis.
void add_search_actions(std::vector<Action>& all) {
    all.push_back(
        {"run.calibrate", "Run", "Calibrate", {}, emits(commands::Calibrate{}), [](const commands::WorkbenchState& s) {
             return s.scene && !s.scene->calibrated.empty();
         }});
    all.push_back({"run.optimize",
                   "Run",
                   "Optimise the signals",
                   {},
                   emits(commands::Optimize{}),
                   [](const commands::WorkbenchState& s) { return s.scene && !s.settings.muscles.empty(); }});
    all.push_back({"run.diagnose",
                   "Run",
                   "Diagnose",
                   {platform::key_d, true, false, "Ctrl+D"},
                   emits(commands::Diagnose{}),
                   [](const commands::WorkbenchState& s) { return s.scene && commands::can_be_diagnosed(*s.scene); }});
}

/// Control of the running job and of the playback.
void add_control_actions(std::vector<Action>& all) {
    all.push_back({"run.pause",
                   "Run",
                   "Pause",
                   {},
                   [](PanelContext& context, viewport::ViewportState&) {
                       context.emit(commands::Pause{!context.state.job->paused});
                   },
                   working(),
                   [](const commands::WorkbenchState& s) { return s.job && s.job->paused; },
                   true});
    // A search that is cancelled keeps its best values, so no question is asked.
    all.push_back({"run.cancel", "Run", "Cancel", {}, emits(commands::Cancel{}), working()});
    all.push_back(
        {"run.play",
         "Run",
         "Play the motion",
         {ImGuiKey_Space, false, false, "Space"},
         [](PanelContext& context, viewport::ViewportState&) { context.emit(commands::Play{!context.state.playing}); },
         with_scene(),
         [](const commands::WorkbenchState& s) { return s.playing; },
         true});
}

/// Menu Run. Each job has one action here; the buttons in the panels emit the same commands.
void add_run_actions(std::vector<Action>& all) {
    // The order of the menu is that of the work: mesh, run, preview, searches, diagnosis, and control of the running
    // job.
    all.push_back({"run.mesh",
                   "Run",
                   "Build the mesh",
                   {platform::key_m, true, false, "Ctrl+M"},
                   emits(commands::BuildMesh{}),
                   with_scene()});
    all.push_back(
        {"run.run", "Run", "Run", {platform::key_r, true, false, "Ctrl+R"}, emits(commands::Run{}), with_scene()});
    all.push_back({"run.preview",
                   "Run",
                   "Live preview",
                   {platform::key_p, true, false, "Ctrl+P"},
                   [](PanelContext& context, viewport::ViewportState&) {
                       const commands::LivePreview& preview = context.state.preview;
                       context.emit(commands::ChangePreview{!preview.on, preview.length_s});
                   },
                   with_scene(),
                   [](const commands::WorkbenchState& s) { return s.preview.on; }});
    add_search_actions(all);
    add_control_actions(all);
}

/// The tasks of the left column. They have no menu and are found through the palette.
void add_step_actions(std::vector<Action>& all) {
    for (const commands::Task task : commands::all_tasks)
        all.push_back({std::string("task.") + commands::task_id(task),
                       "Tasks",
                       commands::task_title(task),
                       {},
                       [task](PanelContext& context, viewport::ViewportState&) { context.window.task = task; }});
}

}  // namespace

const std::vector<Action>& all_actions() {
    // Built once: actions hold no state, only functions of the context.
    static const std::vector<Action> actions = [] {
        std::vector<Action> all;
        add_file_actions(all);
        add_edit_actions(all);
        add_view_actions(all);
        add_run_actions(all);
        add_step_actions(all);
        add_help_actions(all);
        return all;
    }();
    return actions;
}

void react_to_shortcuts(PanelContext& context, viewport::ViewportState& viewport) {
    const ImGuiIO& io = ImGui::GetIO();
    // Keys belong to a text field or an open dialog first.
    if (io.WantTextInput || keys_belong_to_popup()) return;
    for (const Action& action : all_actions()) {
        const Shortcut& keys = action.shortcut;
        // On many keyboards + requires Shift, so Shift is ignored for this key.
        if (keys.key < 0 || keys.ctrl != io.KeyCtrl || (keys.shift != io.KeyShift && keys.key != platform::key_plus) ||
            !ImGui::IsKeyPressed(keys.key, false))
            continue;
        // A disabled action ignores its shortcut, as its menu entry ignores clicks.
        if (!action.enabled || action.enabled(context.state)) action.perform(context, viewport);
    }
    if (io.KeyCtrl && io.KeyShift && ImGui::IsKeyPressed(ImGuiKey_Z, false))
        context.emit(commands::Redo{});  // the second common shortcut for redo
}

}  // namespace myo::ui::panels
