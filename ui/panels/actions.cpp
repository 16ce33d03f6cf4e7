#include "panels/actions.hpp"

#include <imgui.h>

#include <algorithm>

#include "commands/field_store.hpp"
#include "panels/file_dialogs.hpp"
#include "platform/input_queue.hpp"

namespace myo {
namespace {

using Enabled = std::function<bool(const WorkbenchState&)>;

Enabled with_scene() {
    return [](const WorkbenchState& s) { return s.scene != nullptr; };
}
Enabled working() {
    return [](const WorkbenchState& s) { return s.busy(); };
}

/// An action that is a command.
template <class Asked>
std::function<void(PanelContext&, ViewportState&)> emits(Asked asked) {
    return [asked](PanelContext& context, ViewportState&) { context.emit(asked); };
}

void rescale(PanelContext& context, float factor) { context.emit(command::SetTheme{context.state.preferences.theme, std::clamp(context.state.scale() * factor, least_scale, greatest_scale)}); }

void add_file_actions(std::vector<Action>& all) {
    all.push_back({"file.open", "File", "Open\xe2\x80\xa6", {key_o, true, false, "Ctrl+O"}, [](PanelContext& context, ViewportState&) {
                       context.window.file = open_dialog(context.state.scene ? context.state.scene->path : std::filesystem::path());
                   }});
    all.push_back({"file.save", "File", "Save project", {key_s, true, false, "Ctrl+S"}, emits(command::Save{}), with_scene()});
    all.push_back({"file.save_as", "File", "Save project as\xe2\x80\xa6", {key_s, true, true, "Ctrl+Shift+S"}, emits(command::AskWhereToSave{}), with_scene()});
    all.push_back({"file.import", "File", "Import a recording\xe2\x80\xa6", {}, [](PanelContext& context, ViewportState&) { context.window.file = recording_dialog(context.state.scene->path); }, with_scene(), {}, true});
    all.push_back({"file.picture", "File", "Save picture or film\xe2\x80\xa6", {}, [](PanelContext& context, ViewportState&) { context.window.save_view = true; }, with_scene(), {}, true});
    all.push_back({"file.quit", "File", "Quit", {key_q, true, false, "Ctrl+Q"}, emits(command::Quit{}), {}, {}, true});
}

void add_edit_actions(std::vector<Action>& all) {
    all.push_back({"edit.undo", "Edit", "Undo", {ImGuiKey_Z, true, false, "Ctrl+Z"}, emits(command::Undo{}), [](const WorkbenchState& s) { return s.can_undo; }});
    all.push_back({"edit.redo", "Edit", "Redo", {ImGuiKey_Y, true, false, "Ctrl+Y"}, emits(command::Redo{}), [](const WorkbenchState& s) { return s.can_redo; }});
    const auto toggle = [](BrushTool tool) {
        return [tool](PanelContext& context, ViewportState&) {
            BrushSettings brush = context.state.brush;
            brush.tool = brush.tool == tool ? BrushTool::none : tool;
            context.emit(command::ChangeBrush{brush});
            if (brush.tool != BrushTool::none) context.window.step = Step::fibres;
        };
    };
    const auto has_muscle = [](const WorkbenchState& s) { return s.chosen_muscle() != nullptr; };
    const auto holds = [](BrushTool tool) { return [tool](const WorkbenchState& s) { return s.brush.tool == tool; }; };
    all.push_back({"edit.paint", "Edit", "Paint the muscle", {key_b, false, false, "B"}, toggle(BrushTool::add), has_muscle, holds(BrushTool::add), true});
    all.push_back({"edit.erase", "Edit", "Erase the muscle", {key_e, false, false, "E"}, toggle(BrushTool::erase), has_muscle, holds(BrushTool::erase)});
}

void add_view_actions(std::vector<Action>& all) {
    all.push_back({"view.fit", "View", "Show the whole motion", {key_f, false, false, "F"}, [](PanelContext&, ViewportState& view) { view.fit_requested = true; }, with_scene()});
    struct Look { const char* id; const char* label; int key; const char* keys; StandardView view; };
    static constexpr Look looks[] = {{"view.oblique", "Look from the side and above", key_0, "0", StandardView::oblique},
                                     {"view.x", "Look along x", key_1, "1", StandardView::from_x},
                                     {"view.y", "Look along y", key_2, "2", StandardView::from_y},
                                     {"view.z", "Look along z", key_3, "3", StandardView::from_z}};
    for (const Look& look : looks)
        all.push_back({look.id, "View", look.label, {look.key, false, false, look.keys}, [look](PanelContext&, ViewportState& view) {
                           view.camera = turn_to_or_round(view.camera, look.view);
                           view.fit_requested = true;
                       }, with_scene(), {}, look.view == StandardView::oblique});
    all.push_back({"view.orthographic", "View", "Parallel projection", {key_4, false, false, "4"}, [](PanelContext&, ViewportState& view) {
                       view.camera.orthographic = !view.camera.orthographic;
                   }, with_scene()});
    all.push_back({"view.next_field", "View", "Colour by the next quantity", {}, [](PanelContext& context, ViewportState&) {
                       const std::vector<FieldKind> kinds = field_kinds(context.backend);
                       ViewOptions view = context.state.view;
                       const auto shown = std::find_if(kinds.begin(), kinds.end(), [&](const FieldKind& kind) { return kind.id == view.field; });
                       const auto next = shown == kinds.end() ? kinds.begin() : std::next(shown);   // after the last: none
                       view.field = next != kinds.end() ? next->id : "";
                       context.emit(command::ChangeView{view});
                   }, with_scene(), [](const WorkbenchState& s) { return !s.view.field.empty(); }});
    all.push_back({"view.distance", "View", "Measure distances", {key_d, false, false, "D"}, [](PanelContext& context, ViewportState& view) {
                       view.measuring = !view.measuring;
                       BrushSettings brush = context.state.brush;
                       brush.tool = BrushTool::none;
                       if (view.measuring) context.emit(command::ChangeBrush{brush});
                   }, with_scene(), {}, true});
    all.push_back({"view.clear_distances", "View", "Clear the distances", {}, [](PanelContext& context, ViewportState&) { context.window.clear_distances = true; }, with_scene()});
    all.push_back({"view.theme", "View", "Light colours", {}, [](PanelContext& context, ViewportState&) {
                       const bool dark = context.state.preferences.theme == ThemeName::dark;
                       context.emit(command::SetTheme{dark ? ThemeName::light : ThemeName::dark, context.state.scale()});
                   }, {}, [](const WorkbenchState& s) { return s.preferences.theme == ThemeName::light; }, true});
    all.push_back({"view.larger", "View", "Larger text", {key_plus, true, false, "Ctrl++"}, [](PanelContext& context, ViewportState&) { rescale(context, 1.25f); }});
    all.push_back({"view.smaller", "View", "Smaller text", {key_minus, true, false, "Ctrl+\xe2\x88\x92"}, [](PanelContext& context, ViewportState&) { rescale(context, 0.8f); }});
    all.push_back({"view.reset_layout", "View", "Reset the layout", {}, emits(command::SetLayout{})});
}

void add_run_actions(std::vector<Action>& all) {
    all.push_back({"run.mesh", "Run", "Build the mesh", {key_m, true, false, "Ctrl+M"}, emits(command::BuildMesh{}), with_scene()});
    all.push_back({"run.run", "Run", "Run", {key_r, true, false, "Ctrl+R"}, emits(command::Run{}), with_scene()});
    all.push_back({"run.preview", "Run", "Live preview", {key_p, true, false, "Ctrl+P"}, [](PanelContext& context, ViewportState&) {
                       const LivePreview& preview = context.state.preview;
                       context.emit(command::ChangePreview{!preview.on, preview.length_s});
                   }, with_scene(), [](const WorkbenchState& s) { return s.preview.on; }});
    all.push_back({"run.calibrate", "Run", "Calibrate", {}, emits(command::Calibrate{}), [](const WorkbenchState& s) { return s.scene && !s.scene->calibrated.empty(); }});
    all.push_back({"run.optimize", "Run", "Optimise the signals", {}, emits(command::Optimize{}), [](const WorkbenchState& s) { return s.scene && !s.settings.muscles.empty(); }});
    all.push_back({"run.diagnose", "Run", "Diagnose", {key_d, true, false, "Ctrl+D"}, emits(command::Diagnose{}), [](const WorkbenchState& s) { return s.scene && can_be_diagnosed(*s.scene); }});
    all.push_back({"run.pause", "Run", "Pause", {}, [](PanelContext& context, ViewportState&) { context.emit(command::Pause{!context.state.job->paused}); }, working(),
                   [](const WorkbenchState& s) { return s.job && s.job->paused; }, true});
    all.push_back({"run.cancel", "Run", "Cancel", {}, emits(command::Cancel{}), working()});
    all.push_back({"run.play", "Run", "Play the motion", {ImGuiKey_Space, false, false, "Space"}, [](PanelContext& context, ViewportState&) { context.emit(command::Play{!context.state.playing}); },
                   with_scene(), [](const WorkbenchState& s) { return s.playing; }, true});
}

void add_step_actions(std::vector<Action>& all) {
    for (const Step step : all_steps)
        all.push_back({std::string("step.") + step_id(step), "Steps", step_title(step), {}, [step](PanelContext& context, ViewportState&) { context.window.step = step; }});
}

void add_help_actions(std::vector<Action>& all) {
    all.push_back({"help.palette", "Help", "Find a command\xe2\x80\xa6", {key_k, true, false, "Ctrl+K"}, [](PanelContext& context, ViewportState&) { context.window.palette = true; }});
    all.push_back({"help.about", "Help", "About Myoloop", {}, [](PanelContext& context, ViewportState&) { context.window.about = true; }});
}

}  // namespace

const std::vector<Action>& all_actions() {
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

void react_to_shortcuts(PanelContext& context, ViewportState& viewport) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput || ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId)) return;
    for (const Action& action : all_actions()) {
        const Shortcut& keys = action.shortcut;
        if (keys.key < 0 || keys.ctrl != io.KeyCtrl || (keys.shift != io.KeyShift && keys.key != key_plus) || !ImGui::IsKeyPressed(keys.key, false)) continue;
        if (!action.enabled || action.enabled(context.state)) action.perform(context, viewport);
    }
    if (io.KeyCtrl && io.KeyShift && ImGui::IsKeyPressed(ImGuiKey_Z, false)) context.emit(command::Redo{});   // as many know it
}

}  // namespace myo
