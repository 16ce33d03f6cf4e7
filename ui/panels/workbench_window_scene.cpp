#include <algorithm>
#include <array>
#include <utility>

#include "panels/workbench_window.hpp"
#include "platform/gl.hpp"
#include "platform/wide_fonts.hpp"

// The drawn scene and the frames of the window.

namespace myo::ui::panels {
namespace {

/// The colours of the muscles, in which alone an edit of the list can change the picture.
std::vector<int> muscle_looks(const std::vector<commands::Muscle>& muscles) {
    std::vector<int> colors;
    for (const commands::Muscle& muscle : muscles) colors.push_back(muscle.color);
    return colors;
}

/// Parts that no window covers show the background of the theme.
void clear_window(const ImVec4& color) {
    platform::gl::BindFramebuffer(GL_FRAMEBUFFER, 0);
    platform::gl::Disable(GL_SCISSOR_TEST);
    platform::gl::ClearColor(color.x, color.y, color.z, 1.0f);
    platform::gl::Clear(GL_COLOR_BUFFER_BIT);
}

}  // namespace

WorkbenchWindow::SceneKey WorkbenchWindow::scene_key() {
    const commands::WorkbenchState& state = workbench_->state();
    // In the order of the members of SceneKey.
    return {state.scene,
            state.body,
            state.shown_run(),
            state.drawn_run(),
            state.diagnosis,
            state.import,
            state.candidate,
            state.trial,
            state.time_s,
            state.view,
            fields_.update(state, workbench_->backend()),
            state.paint,
            muscle_looks(state.settings.muscles),
            state.muscle,
            paint_.revision(),
            placing_.on(),
            placing_tools_.revision(),
            interface_.theme().name,
            commands::compared_records(state)};
}

void WorkbenchWindow::follow_scene(const SceneKey& key) {
    const commands::WorkbenchState& state = workbench_->state();
    // Another body begins with its first task and the standard direction of view; edits of the declaration leave both.
    const bool opened = !key.scene || !scene_key_.scene || key.scene->path != scene_key_.scene->path;
    if (opened && key.scene && scene_key_.scene) show_task(commands::Task::body);
    if (opened && key.scene != scene_key_.scene) {
        viewport_.camera = viewport::turn_to(viewport_.camera, viewport::StandardView::oblique);
        viewport_.untouched = true;
    }
    // A model that plays live has a frame of its own every time; camera and surface stay.
    if (key.scene != scene_key_.scene || key.body != scene_key_.body || key.run != scene_key_.run ||
        key.trial != scene_key_.trial) {
        motion_ = commands::summarize_motion(state);
        // Until the user moves the camera, the whole motion stays visible. Edits that are previewed are an exception:
        // the camera must not move with every one.
        if (viewport_.untouched && !(state.previewing() && scene_key_.run)) viewport_.zoom_to_data_requested = true;
    }
}

/// Keeps scene_ up to date. The key contains everything that the scene depends on; comparing it is cheap, as large
/// parts are compared by pointer.
void WorkbenchWindow::update_scene() {
    const commands::WorkbenchState& state = workbench_->state();
    const SceneKey key = scene_key();
    // Creating the scene copies all positions, so it happens only if one of its inputs has changed.
    if (key == scene_key_) return;
    follow_scene(key);
    // A new import shows its panels.
    if (key.import && !scene_key_.import) {
        show_task(commands::Task::measure);
        show_panel("recording");
    }
    // After the summary, which contains the whole body.
    cut_.apply(state, motion_);
    const std::optional<commands::FieldKind> kind = commands::shown_field(state, workbench_->backend());
    scene_ = commands::scene_at_time(placing_.on() ? commands::at_rest(state) : state, interface_.theme(), motion_,
                                     paint_.live(), kind && !placing_.on() ? &*kind : nullptr, key.field.get());
    placing_tools_.show(placing_, interface_.theme(), scene_);
    scene_key_ = key;
    ++revision_;
}

std::vector<commands::Command> WorkbenchWindow::draw_panels() {
    std::vector<commands::Command> commands;
    WindowRequests requests;
    PanelContext context{workbench_->state(),
                         interface_.theme(),
                         interface_.items(),
                         commands,
                         workbench_->backend(),
                         requests,
                         placing_};
    if (scene_.field) context.field_range = std::array<double, 2>{scene_.field->lowest, scene_.field->highest};
    draw_parts(context);
    follow(requests);
    return commands;
}

Result<void> WorkbenchWindow::render_view(int height, bool moving) {
    const auto drawn = renderer_.update(scene_, revision_, viewport::view_colors(interface_.theme()), viewport_.camera,
                                        viewport_.size(), moving ? 0 : 4,
                                        static_cast<double>(interface_.theme().scale));
    if (!drawn) return drawn;
    begin_pictures();
    add_picture();
    renderer_.blit_to_window(static_cast<int>(viewport_.pixels.lowest.x),
                             height - static_cast<int>(viewport_.pixels.highest.y));
    if (ComparedView::record(workbench_->state())) return compared_.render(interface_.theme(), height, moving);
    return {};
}

void WorkbenchWindow::load_names() {
    const commands::WorkbenchState& state = workbench_->state();
    // Said once: what is missing does not change while the program runs.
    if (interface_.lacks_letters() && !std::exchange(told_letters_, true))
        workbench_->execute(commands::LogMessage{commands::LogLevel::warning, platform::wide_font_hint});
    // At the start, and after a change of theme, the fonts are loaded by the next frame: what they lack is known then.
    if (!interface_.theme().regular) return;
    // Muscles are renamed without a message and in the same scene; their few letters are looked up in every frame.
    for (const commands::Muscle& muscle : state.settings.muscles) interface_.need_letters(muscle.name);
    const auto key = std::pair(state.scene.get(), state.logged + state.preferences.recent.size());
    if (std::exchange(named_, key) == key) return;
    if (!state.log.empty()) interface_.need_letters(state.log.back().text);
    for (const std::filesystem::path& path : state.preferences.recent) interface_.need_letters(path.string());
    if (!state.scene) return;
    interface_.need_letters(state.scene->name + state.scene->path.string());
    for (const commands::SceneTrial& trial : state.scene->trials) interface_.need_letters(trial.name);
    for (const commands::SceneMarker& marker : state.scene->markers) interface_.need_letters(marker.name);
    for (const commands::ScenePart& part : state.scene->parts) interface_.need_letters(part.name + part.file.string());
    for (const std::string& chamber : state.scene->declared.chambers) interface_.need_letters(chamber);
    for (const commands::DeclaredTendon& tendon : state.scene->declared.tendons) interface_.need_letters(tendon.name);
}

/// The order within a frame: results of jobs, input, scene, panels, requests, rendering, and finally the commands.
Result<void> WorkbenchWindow::draw_frame(int width, int height, double seconds) {
    // After a pause without frames, playing must not jump.
    seconds = std::clamp(seconds, 0.0, 0.25);
    workbench_->advance(seconds);
    const commands::WorkbenchState& state = workbench_->state();
    interface_.set_theme(state.preferences.theme, state.scale());
    load_names();
    interface_.begin_frame(width, height, static_cast<float>(seconds));
    // Before the panels, so that they draw over the scene of this frame.
    update_scene();
    if (ComparedView::record(state))
        compared_.update(state, interface_.theme(), workbench_->backend(), scene_, revision_);
    layout_ = make_layout(static_cast<float>(width), static_cast<float>(height), interface_.theme().scale,
                          state.preferences.layout);
    help_.follow(state);
    if (help_.is_open()) layout_ = beside_help(layout_, interface_.theme().scale);
    const std::vector<commands::Command> commands = draw_panels();
    interface_.end_frame();
    clear_window(interface_.theme().background);
    // Without multisampling while something moves: at rest the next frame is rendered again with it.
    const bool moving = viewport_.moving || viewport_.tool_held || workbench_->animating();
    if (state.scene && viewport_.size().width > 1 && viewport_.size().height > 1)
        if (const auto rendered = render_view(height, moving); !rendered) return rendered;
    interface_.draw();
    if (part_ && --part_waits_ < 0) write_part(width, height);
    // Commands are executed after the frame, so that all panels have seen the same state. Their effect shows in the
    // next frame.
    for (const commands::Command& command : commands) workbench_->execute(command);
    pacer_.frame_drawn();
    // Something has changed: the next frames show it.
    if (!commands.empty() || !interface_.input().empty()) pacer_.event_arrived();
    was_moving_ = moving;
    return {};
}

}  // namespace myo::ui::panels
