#include "panels/workbench_window.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "panels/run_panel.hpp"
#include "panels/timeline.hpp"
#include "panels/view_options.hpp"
#include "panels/widgets.hpp"
#include "platform/fonts.hpp"

namespace myo {
namespace {

constexpr ImGuiWindowFlags fixed_window = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                                          ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                          ImGuiWindowFlags_NoBringToFrontOnFocus;

void begin_part(const char* name, const Rectangle& place, ImGuiWindowFlags flags = 0) {
    ImGui::SetNextWindowPos(place.lowest);
    ImGui::SetNextWindowSize({std::max(1.0f, place.width()), std::max(1.0f, place.height())});
    ImGui::Begin(name, nullptr, fixed_window | flags);
}

std::vector<int> muscle_looks(const std::vector<Muscle>& muscles) {
    std::vector<int> colors;
    for (const Muscle& muscle : muscles) colors.push_back(muscle.color);
    return colors;
}

ViewColors view_colors(const Theme& theme) {
    const auto color = [](const ImVec4& c, float alpha = 1.0f) { return Color(c.x, c.y, c.z, alpha); };
    ViewColors colors;
    colors.top = color(theme.view_top);
    colors.bottom = color(theme.view_bottom);
    colors.grid = color(theme.grid, 0.8f);
    colors.body = color(theme.body);
    colors.edge = Color(0.05f, 0.07f, 0.10f, theme.edge_strength);
    return colors;
}

}  // namespace

Result<WorkbenchWindow> WorkbenchWindow::make(Workbench& workbench) {
    auto interface = Interface::make(workbench.state().theme, workbench.state().scale);
    if (!interface) return interface.error();
    auto renderer = SceneRenderer::make();
    if (!renderer) return renderer.error();
    WorkbenchWindow window;
    window.workbench_ = &workbench;
    window.interface_ = std::move(*interface);
    window.renderer_ = std::move(*renderer);
    window.panels_ = all_panels();
    for (const auto& panel : window.panels_) {
        if (panel->place() == PanelPlace::strip && window.strip_panel_.empty()) window.strip_panel_ = panel->name();
    }
    return window;
}

bool WorkbenchWindow::show_panel(const std::string& name) {
    for (const auto& panel : panels_) {
        if (panel->name() != name) continue;
        wanted_panel_ = name;
        if (panel->place() == PanelPlace::strip) strip_panel_ = name;
        wake();
        return true;
    }
    return false;
}

std::vector<std::string> WorkbenchWindow::panel_names() const {
    std::vector<std::string> names;
    for (const auto& panel : panels_) names.push_back(panel->name());
    return names;
}

bool WorkbenchWindow::must_draw() const {
    // After a movement one more frame draws the scene with smooth edges.
    return pacer_.must_draw(workbench_->animating() || was_moving_);
}

void WorkbenchWindow::draw_bar(PanelContext& context) {
    const WorkbenchState& state = context.state;
    const Theme& theme = context.theme;
    begin_part("##bar", layout_.bar, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::SetCursorPosY(0.5f * (layout_.bar.height() - ImGui::GetFrameHeight()));
    ImGui::AlignTextToFramePadding();
    ImGui::PushFont(theme.strong);
    ImGui::TextColored(theme.accent, "Myoloop");
    ImGui::PopFont();
    ImGui::SameLine(0.0f, 16.0f * theme.scale);
    const auto tip = [](const char* text) {
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", text);
    };
    ImGui::BeginDisabled(!state.can_undo);
    if (ImGui::Button(icon::undo)) context.emit(command::Undo{});
    context.items.mark("bar/undo");
    tip("Undo the last change of a setting (Ctrl+Z)");
    ImGui::EndDisabled();
    ImGui::SameLine();
    ImGui::BeginDisabled(!state.can_redo);
    if (ImGui::Button(icon::redo)) context.emit(command::Redo{});
    context.items.mark("bar/redo");
    tip("Redo (Ctrl+Y)");
    ImGui::EndDisabled();

    const bool dark = state.theme == ThemeName::dark;
    const float theme_width = 72.0f * theme.scale;
    const float scale_width = 84.0f * theme.scale;
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    const float right = layout_.bar.width() - ImGui::GetStyle().WindowPadding.x - theme_width - scale_width - spacing;
    ImGui::SameLine(0.0f, 24.0f * theme.scale);
    // The last message, in what room there is.
    if (!state.log.empty()) {
        const LogLine& line = state.log.back();
        const ImVec4 colors[] = {theme.muted, theme.success, theme.warning, theme.failure};
        const ImVec2 at = ImGui::GetCursorScreenPos();
        ImGui::PushClipRect(at, {right - 16.0f * theme.scale, layout_.bar.highest.y}, true);
        ImGui::PushStyleColor(ImGuiCol_Text, colors[static_cast<int>(line.level)]);
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(line.text.c_str());
        ImGui::PopStyleColor();
        ImGui::PopClipRect();
        ImGui::SameLine();
    }
    ImGui::SetCursorPosX(right);
    ImGui::SetNextItemWidth(scale_width);
    if (ImGui::BeginCombo("##scale", (std::to_string(std::lround(100.0f * state.scale)) + " %").c_str())) {
        for (const int percent : {75, 100, 125, 150, 200}) {
            const bool chosen = std::lround(100.0f * state.scale) == percent;
            if (ImGui::Selectable((std::to_string(percent) + " %").c_str(), chosen)) {
                context.emit(command::SetTheme{state.theme, 0.01f * static_cast<float>(percent)});
            }
            context.items.mark("bar/scale/" + std::to_string(percent));
        }
        ImGui::EndCombo();
    }
    context.items.mark("bar/scale");
    tip("Size of text and controls");
    ImGui::SameLine();
    if (ImGui::Button(dark ? "Light" : "Dark", {theme_width, 0.0f})) {
        context.emit(command::SetTheme{dark ? ThemeName::light : ThemeName::dark, state.scale});
    }
    context.items.mark("bar/theme");
    tip("Light or dark colours");
    ImGui::End();
}

void WorkbenchWindow::draw_rail(PanelContext& context) {
    begin_part("##rail", layout_.rail, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    const ImVec2 padding = ImGui::GetStyle().WindowPadding;
    // The buttons that start and stop work stay in sight at the foot; the rest scrolls above them.
    ImGui::BeginChild("##scrolling", {0.0f, -(foot_height_ + padding.y)});
    for (const auto& panel : panels_) {
        if (panel->place() != PanelPlace::rail) continue;
        const bool wanted = panel->name() == wanted_panel_;
        if (wanted) ImGui::SetNextItemOpen(true);
        ImGui::PushFont(context.theme.strong);
        ImGui::PushStyleColor(ImGuiCol_Header, context.theme.panel);
        ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 0.0f);
        const bool open = ImGui::CollapsingHeader((panel->title() + "##" + panel->name()).c_str(), ImGuiTreeNodeFlags_DefaultOpen);
        ImGui::PopStyleVar();
        ImGui::PopStyleColor();
        ImGui::PopFont();
        context.items.mark("panel/" + panel->name());
        if (wanted) ImGui::SetScrollHereY(0.0f);
        if (open) {
            ImGui::PushID(panel->name().c_str());
            panel->draw(context);
            ImGui::PopID();
            ImGui::Dummy({0.0f, 4.0f * context.theme.scale});
        }
        ImGui::Separator();
    }
    ImGui::EndChild();
    const float foot_top = ImGui::GetCursorPosY();
    draw_run_controls(context);
    foot_height_ = ImGui::GetCursorPosY() - foot_top;
    ImGui::End();
}

void WorkbenchWindow::draw_strip(PanelContext& context) {
    begin_part("##strip", layout_.strip, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    bool first = true;
    Panel* front = nullptr;
    for (const auto& panel : panels_) {
        if (panel->place() != PanelPlace::strip) continue;
        if (!first) ImGui::SameLine();
        first = false;
        const bool chosen = panel->name() == strip_panel_;
        if (chosen) front = panel.get();
        ImGui::PushStyleColor(ImGuiCol_Button, chosen ? context.theme.raised : context.theme.panel);
        ImGui::PushStyleColor(ImGuiCol_Text, chosen ? context.theme.text : context.theme.muted);
        if (ImGui::Button(panel->title().c_str())) strip_panel_ = panel->name();
        ImGui::PopStyleColor(2);
        context.items.mark("panel/" + panel->name());
    }
    if (front != nullptr) {
        ImGui::BeginChild(front->name().c_str());
        front->draw(context);
        ImGui::EndChild();
    }
    ImGui::End();
}

void WorkbenchWindow::draw_view(PanelContext& context) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
    begin_part("##view", layout_.view, ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    const EmptyView empty{"Open an experiment folder or drop a mesh",
                          "Type a path on the left, choose from a list with Ctrl+O, or drop a folder or file on this window."};
    const ToolTakes takes = [&](const Eigen::Vector2d& pixel) { return paint_.takes(context.state, scene_, viewport_, pixel); };
    draw_viewport(scene_, empty, context.theme, context.items, viewport_, context.state.view.labels, takes);
    paint_.update(context, scene_, viewport_);
    context.live_paint = paint_.live();
    if (context.state.scene) {
        ImGui::SameLine();
        draw_view_options(context);
    }
    ImGui::End();
}

void WorkbenchWindow::draw_edges() {
    const auto edge = [&](const char* name, const Rectangle& place, bool vertical, float& size, float direction) {
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
        ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0f, 1.0f));
        begin_part(name, place, ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar);
        ImGui::PopStyleVar(2);
        ImGui::InvisibleButton(name, {std::max(1.0f, place.width()), std::max(1.0f, place.height())});
        interface_.items().mark(std::string("edge/") + (name + 2));
        if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
            ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
            ImGui::GetWindowDrawList()->AddRectFilled(place.lowest, place.highest, packed(interface_.theme().accent));
        }
        if (ImGui::IsItemActive()) {
            const ImVec2 moved = ImGui::GetIO().MouseDelta;
            size += direction * (vertical ? moved.x : moved.y) / interface_.theme().scale;
        }
        ImGui::End();
    };
    edge("##rail_edge", layout_.rail_edge, true, sizes_.rail, 1.0f);
    edge("##strip_edge", layout_.strip_edge, false, sizes_.strip, -1.0f);
    sizes_.rail = std::clamp(sizes_.rail, 240.0f, 1200.0f);
    sizes_.strip = std::clamp(sizes_.strip, 80.0f, 1200.0f);
}

void WorkbenchWindow::react_to_keys(PanelContext& context) {
    const ImGuiIO& io = ImGui::GetIO();
    if (io.WantTextInput || ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId)) return;
    const auto pressed = [](int key) { return ImGui::IsKeyPressed(key, false); };
    if (io.KeyCtrl) {
        if (pressed(ImGuiKey_Z)) context.emit(io.KeyShift ? Command(command::Redo{}) : Command(command::Undo{}));
        if (pressed(ImGuiKey_Y)) context.emit(command::Redo{});
        if (pressed(key_r)) context.emit(command::Run{});
        return;
    }
    if (pressed(ImGuiKey_Space)) context.emit(command::Play{!context.state.playing});
    if (pressed(key_f)) viewport_.fit_requested = true;
    const auto toggle = [&](BrushTool tool) {
        BrushSettings brush = context.state.brush;
        brush.tool = brush.tool == tool ? BrushTool::none : tool;
        if (context.state.chosen_muscle()) context.emit(command::ChangeBrush{brush});
    };
    if (pressed(key_b)) toggle(BrushTool::add);
    if (pressed(key_e)) toggle(BrushTool::erase);
    const auto step = [&](double frames) {
        const SceneTrial* trial = context.state.scene_trial();
        if (!trial || trial->time_s.size() < 2) return;
        const double interval = (trial->time_s[trial->time_s.size() - 1] - trial->time_s[0]) / static_cast<double>(trial->time_s.size() - 1);
        context.emit(command::SetTime{context.state.time_s + frames * interval});
    };
    if (ImGui::IsKeyPressed(ImGuiKey_LeftArrow)) step(-1.0);
    if (ImGui::IsKeyPressed(ImGuiKey_RightArrow)) step(1.0);
}

void WorkbenchWindow::update_scene() {
    const WorkbenchState& state = workbench_->state();
    const SceneKey key{state.scene, state.body, state.run, state.diagnosis, state.candidate, state.trial, state.time_s, state.view, state.paint, muscle_looks(state.settings.muscles),
                       state.muscle, paint_.revision(), interface_.theme().name};
    if (key == scene_key_) return;
    if (key.scene != scene_key_.scene) {
        viewport_.camera = turn_to(viewport_.camera, StandardView::oblique);
        viewport_.untouched = true;
    }
    if (key.scene != scene_key_.scene || key.body != scene_key_.body || key.run != scene_key_.run || key.trial != scene_key_.trial) {
        motion_ = summarize_motion(state);
        // Until a person chooses another view, all of the motion stays in sight.
        if (viewport_.untouched) viewport_.fit_requested = true;
    }
    if (key.run != scene_key_.run && key.run) wanted_panel_ = "run";
    scene_ = scene_at_time(state, interface_.theme(), motion_, paint_.live());
    scene_key_ = key;
    ++revision_;
}

Result<void> WorkbenchWindow::draw_frame(int width, int height, double seconds) {
    // After a pause without frames, playing must not jump.
    seconds = std::clamp(seconds, 0.0, 0.25);
    workbench_->advance(seconds);
    const WorkbenchState& state = workbench_->state();
    interface_.set_theme(state.theme, state.scale);
    interface_.begin_frame(width, height, static_cast<float>(seconds));
    update_scene();
    layout_ = make_layout(static_cast<float>(width), static_cast<float>(height), interface_.theme().scale, sizes_);

    std::vector<Command> commands;
    PanelContext context{state, interface_.theme(), interface_.items(), commands};
    draw_view(context);
    draw_bar(context);
    draw_rail(context);
    begin_part("##timeline", layout_.timeline, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::SetCursorPosY(0.5f * (layout_.timeline.height() - ImGui::GetFrameHeight()));
    draw_timeline(context);
    ImGui::End();
    draw_strip(context);
    draw_edges();
    react_to_keys(context);
    wanted_panel_.clear();
    interface_.end_frame();

    const ImVec4 clear = interface_.theme().background;
    gl::BindFramebuffer(GL_FRAMEBUFFER, 0);
    gl::Disable(GL_SCISSOR_TEST);
    gl::ClearColor(clear.x, clear.y, clear.z, 1.0f);
    gl::Clear(GL_COLOR_BUFFER_BIT);
    const bool moving = viewport_.moving || viewport_.tool_held || state.playing;
    if (viewport_.size().width > 1 && viewport_.size().height > 1) {
        const auto drawn = renderer_.update(scene_, revision_, view_colors(interface_.theme()), viewport_.camera, viewport_.size(),
                                            moving ? 0 : 4);
        if (!drawn) return drawn;
        renderer_.blit_to_window(static_cast<int>(viewport_.pixels.lowest.x), height - static_cast<int>(viewport_.pixels.highest.y));
    }
    interface_.draw();

    // Commands are carried out after the frame, so that all panels saw one state; their effect shows in the next.
    for (const Command& command : commands) workbench_->execute(command);
    pacer_.frame_drawn();
    if (!commands.empty() || !interface_.input().empty()) pacer_.event_arrived();
    was_moving_ = moving;
    return {};
}

}  // namespace myo
