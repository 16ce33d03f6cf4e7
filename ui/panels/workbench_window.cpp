#include "panels/workbench_window.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "panels/about_dialog.hpp"
#include "panels/escape.hpp"
#include "panels/file_dialogs.hpp"
#include "panels/import_panel.hpp"
#include "panels/menu_bar.hpp"
#include "panels/place_tool.hpp"
#include "panels/questions.hpp"
#include "panels/run_panel.hpp"
#include "panels/start_page.hpp"
#include "panels/task_rail.hpp"
#include "panels/timeline.hpp"
#include "panels/view_options.hpp"
#include "panels/widgets.hpp"
#include "platform/image.hpp"

namespace myo::ui::panels {
namespace {

// The parts of the window are ImGui windows at fixed places.
constexpr ImGuiWindowFlags fixed_window = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                          ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;

/// Begins the ImGui window of a part. The caller ends it.
void begin_part(const char* name, const platform::Rectangle& place, ImGuiWindowFlags flags = 0) {
    ImGui::SetNextWindowPos(place.lowest);
    ImGui::SetNextWindowSize({std::max(1.0f, place.width()), std::max(1.0f, place.height())});
    ImGui::Begin(name, nullptr, fixed_window | flags);
}

/// Width of the tabs below the view with all their titles [pixels].
float strip_width(const std::vector<std::unique_ptr<Panel>>& panels, const commands::WorkbenchState& state) {
    float all = 0.0f;
    for (const auto& panel : panels)
        if (panel->place() == PanelPlace::strip && panel->offered(state))
            all += ImGui::CalcTextSize(panel->title().c_str()).x + 2.0f * ImGui::GetStyle().FramePadding.x +
                   ImGui::GetStyle().ItemSpacing.x;
    return all;
}

// Parts of the help can be shown by name, as panels can.
constexpr std::pair<HelpRequest::Part, const char*> help_parts[] = {{HelpRequest::Part::tutorial, "tutorial"},
                                                                    {HelpRequest::Part::manual, "manual"},
                                                                    {HelpRequest::Part::shortcuts, "keys"}};

/// The panel in front of the strip, in a child window that scrolls.
void draw_front(PanelContext& context, Panel& panel) {
    ImGui::BeginChild(panel.name().c_str());
    panel.draw(context);
    ImGui::EndChild();
}

}  // namespace

// The first panel of the strip in all_panels() is the one in front at the start.
Result<WorkbenchWindow> WorkbenchWindow::make(commands::Workbench& workbench) {
    auto interface = platform::Interface::make(workbench.state().preferences.theme, workbench.state().scale());
    if (!interface) return interface.error();
    auto renderer = viewport::SceneRenderer::make();
    if (!renderer) return renderer.error();
    WorkbenchWindow window;
    window.workbench_ = &workbench;
    window.interface_ = std::move(*interface);
    window.renderer_ = std::move(*renderer);
    auto compared = ComparedView::make();
    if (!compared) return compared.error();
    window.compared_ = std::move(*compared);
    window.panels_ = all_panels();
    for (const auto& panel : window.panels_) {
        // The first panel of the strip is shown at the start.
        if (panel->place() == PanelPlace::strip && window.strip_panel_.empty()) window.strip_panel_ = panel->name();
    }
    return window;
}

void WorkbenchWindow::show_task(commands::Task task) {
    task_ = task;
    for (const auto& panel : panels_)
        if (panel->place() == PanelPlace::strip && panel->task() == task) strip_panel_ = panel->name();
    wake();
}

// A side panel is shown by showing its task.
bool WorkbenchWindow::show_panel(const std::string& name) {
    // Parts of the help first, as their names are no names of panels.
    for (const auto& [part, word] : help_parts)
        if (name == word) {
            help_.open({part});
            wake();
            return true;
        }
    for (const auto& panel : panels_) {
        if (panel->name() != name) continue;
        if (panel->place() == PanelPlace::strip)
            strip_panel_ = name;
        else
            task_ = *panel->task();
        wake();
        return true;
    }
    return false;
}

std::vector<std::string> WorkbenchWindow::panel_names() const {
    std::vector<std::string> names;
    for (const auto& panel : panels_) names.push_back(panel->name());
    for (const auto& [part, word] : help_parts) names.emplace_back(word);
    return names;
}

bool WorkbenchWindow::must_draw() const {
    // After a movement one more frame renders the scene with multisampling.
    return pacer_.must_draw(workbench_->animating() || was_moving_ || fields_.waits() || film_.runs() || picture_ ||
                            (ComparedView::record(workbench_->state()) && compared_.waits()) || part_);
}

void WorkbenchWindow::draw_task_panels(PanelContext& context) {
    const ImVec2 padding = ImGui::GetStyle().WindowPadding;
    // Messages have their place at the head, the buttons that start and stop jobs at the foot; all else scrolls
    // between.
    draw_task_head(context, task_);
    // Highlights of lists and tables reach this far beyond their texts.
    const float margin = ImGui::GetStyle().CellPadding.x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() - margin);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(margin, 0.0f));
    ImGui::BeginChild((std::string("##scrolling ") + commands::task_id(task_)).c_str(),
                      {ImGui::GetContentRegionAvail().x + 2.0f * margin, -(foot_height_ + padding.y)}, false,
                      ImGuiWindowFlags_AlwaysUseWindowPadding);
    ImGui::PopStyleVar();
    bool first = true;
    for (const auto& panel : panels_) {
        if (panel->place() != PanelPlace::side || panel->task() != task_ || !panel->offered(context.state)) continue;
        if (!first) ImGui::Dummy({0.0f, 6.0f * context.theme.scale});
        first = false;
        heading(context.theme, panel->title());
        context.items.mark("panel/" + panel->name());
        ImGui::PushID(panel->name().c_str());
        panel->draw(context);
        ImGui::PopID();
    }
    ImGui::EndChild();
}

/// The column of tasks, and next to it the panels of the selected task.
void WorkbenchWindow::draw_side(PanelContext& context) {
    // The tasks fill their column without padding at the sides.
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 8.0f * context.theme.scale));
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0f, 2.0f * context.theme.scale));
    begin_part("##steps", layout_.steps, ImGuiWindowFlags_NoScrollbar);
    draw_task_rail(context, task_, layout_.narrow);
    ImGui::End();
    ImGui::PopStyleVar(2);
    begin_part("##side", layout_.rail, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    // The foot's height is known from the last frame only.
    draw_task_panels(context);
    const float foot_top = ImGui::GetCursorPosY();
    if (context.state.import && task_ == commands::Task::measure && !context.state.busy())
        draw_import_controls(context);
    else
        draw_run_controls(context);
    // Known only after drawing; the next frame uses it. A change of height is corrected one frame later.
    foot_height_ = ImGui::GetCursorPosY() - foot_top;
    ImGui::End();
}

/// One tab per panel; a panel that is not offered has none.
void WorkbenchWindow::draw_strip(PanelContext& context) {
    begin_part("##strip", layout_.strip, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    // Without room for all titles, only the tab in front shows its title.
    const bool icons = strip_width(panels_, context.state) >
                       ImGui::GetContentRegionAvail().x;  // all tabs but the one in front show icons only
    bool first = true;
    // Drawn after the tabs; null if its panel has just disappeared.
    Panel* front = nullptr;
    // The panel in front may disappear, for example when an import ends.
    const auto gone = [&](const auto& panel) {
        return panel->name() == strip_panel_ && !panel->offered(context.state);
    };
    if (std::any_of(panels_.begin(), panels_.end(), gone)) strip_panel_ = "markers";
    for (const auto& panel : panels_) {
        if (panel->place() != PanelPlace::strip || !panel->offered(context.state)) continue;
        if (!first) ImGui::SameLine();
        first = false;
        const bool chosen = panel->name() == strip_panel_;
        if (chosen) front = panel.get();
        const std::string title = panel->title(), label = icons && !chosen ? title.substr(0, title.find(' ')) : title;
        if (tab(context.theme, (label + "##" + panel->name()).c_str(), chosen)) strip_panel_ = panel->name();
        context.items.mark("panel/" + panel->name());
        if (label != title) tooltip(context.theme, title);
    }
    if (front != nullptr) draw_front(context, *front);
    ImGui::End();
}

/// The view fills its part of the window; the rendered scene is copied there before ImGui's lists are drawn over it.
void WorkbenchWindow::draw_view(PanelContext& context) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
    // Without a scene there is nothing to play or plot, so the start page gets the whole room.
    if (!context.state.scene) layout_.view.highest = {layout_.view.highest.x, layout_.strip.highest.y};
    // The compared run takes the right half.
    const bool two = ComparedView::record(context.state) != nullptr;
    platform::Rectangle left = layout_.view, right = layout_.view;
    if (two) left.highest.x = right.lowest.x = std::floor(0.5f * (left.lowest.x + left.highest.x));
    begin_part("##view", left,
               ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    if (!context.state.scene) {
        draw_start_page(context);
        ImGui::End();
        return;
    }
    // Order matters: the view receives the mouse first, then the tools, and the card of a picked place last.
    const viewport::ToolTakes takes = [&](const Eigen::Vector2d& pixel) {
        if (placing_.on()) return placing_tools_.takes(context, scene_, viewport_, pixel);
        return live_.takes(context.state, scene_, viewport_, pixel) ||
               paint_.takes(context.state, scene_, viewport_, pixel) ||
               goals_.takes(context.state, context.theme, viewport_, pixel) ||
               box_tool_.takes(context.state, context.theme, viewport_, pixel);
    };
    const int width_before = viewport_.size().width;
    viewport::draw_viewport(scene_, context.theme, context.items, viewport_, context.state.view.labels, takes);
    // Until the user moves the camera, the whole motion stays visible, also in half the width.
    if (viewport_.untouched && viewport_.size().width != width_before) viewport_.zoom_to_data_requested = true;
    const bool placing = placing_tools_.update(context, scene_, viewport_);
    if (!placing) paint_.update(context, scene_, viewport_);
    live_.update(context, scene_, viewport_, placing);
    context.live_paint = context.state.brush.part < 0 ? paint_.live() : nullptr;
    goals_.update(context, viewport_);
    if (!placing) box_tool_.update(context, viewport_);
    distances_.update(context, scene_, viewport_);
    if (!placing && !update_placing(context, scene_, viewport_)) inspect_.update(context, scene_, viewport_);
    // In a narrow view the options stand below the buttons.
    const float options = ImGui::CalcTextSize("Show").x + 4.0f * ImGui::GetFrameHeight(),
                row_end = ImGui::GetItemRectMax().x;
    if (row_end + options < viewport_.pixels.highest.x)
        ImGui::SameLine();
    else
        ImGui::SetCursorScreenPos({viewport_.pixels.lowest.x + 12.0f * context.theme.scale,
                                   ImGui::GetItemRectMax().y + 4.0f * context.theme.scale});
    draw_view_options(context, viewport_.camera, view_edits_);
    if (two) draw_run_name(context.theme, viewport_.pixels, "shown run");
    ImGui::End();
    if (!two) return;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
    begin_part("##compared", right,
               ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
    ImGui::PopStyleVar();
    compared_.draw(context, viewport_);
    ImGui::End();
}

/// Dragging an edge changes the preferences, so that the sizes are kept for the next session.
void WorkbenchWindow::draw_edges(PanelContext& context) {
    commands::LayoutSizes sizes = context.state.preferences.layout;
    // An invisible window over each edge receives the drag.
    const auto edge = [&](const char* name, const platform::Rectangle& place, bool vertical, float& size,
                          float direction) {
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
        ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0f, 1.0f));
        begin_part(name, place, ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar);
        ImGui::PopStyleVar(2);
        ImGui::InvisibleButton(name, {std::max(1.0f, place.width()), std::max(1.0f, place.height())});
        // Without the "##" that hides the name.
        interface_.items().mark(std::string("edge/") + (name + 2));
        if (ImGui::IsItemHovered() || ImGui::IsItemActive()) {
            ImGui::SetMouseCursor(vertical ? ImGuiMouseCursor_ResizeEW : ImGuiMouseCursor_ResizeNS);
            ImGui::GetWindowDrawList()->AddRectFilled(place.lowest, place.highest,
                                                      platform::packed(interface_.theme().accent));
        }
        if (ImGui::IsItemActive()) {
            const ImVec2 moved = ImGui::GetIO().MouseDelta;
            size += direction * (vertical ? moved.x : moved.y) / interface_.theme().scale;
        }
        ImGui::End();
    };
    edge("##rail_edge", layout_.rail_edge, true, sizes.rail, 1.0f);
    if (context.state.scene) edge("##strip_edge", layout_.strip_edge, false, sizes.strip, -1.0f);
    // Limits of the preferences; make_layout() limits them further where the window is small.
    sizes.rail = std::clamp(sizes.rail, 240.0f, 1200.0f);
    sizes.strip = std::clamp(sizes.strip, 80.0f, 1200.0f);
    if (!(sizes == context.state.preferences.layout)) context.emit(commands::SetLayout{sizes});
}

void WorkbenchWindow::react_to_keys(PanelContext& context) {
    react_to_shortcuts(context, viewport_);
    if (ImGui::GetIO().WantTextInput || keys_belong_to_popup()) return;
    // One sample interval per key press.
    const auto step = [&](double frames) {
        const commands::SceneTrial* trial = context.state.scene_trial();
        if (!trial || trial->time_s.size() < 2) return;
        context.emit(commands::SetTime{context.state.time_s + frames * commands::sample_interval_s(*trial)});
    };
    if (ImGui::IsKeyPressed(ImGuiKey_LeftArrow)) step(-1.0);
    if (ImGui::IsKeyPressed(ImGuiKey_RightArrow)) step(1.0);
}

/// Draws all parts in a fixed order; dialogs last, as they lie in front.
void WorkbenchWindow::draw_parts(PanelContext& context) {
    constexpr ImGuiWindowFlags still = ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;
    draw_view(context);
    begin_part("##bar", layout_.bar, still);
    draw_menu_bar(context, viewport_);
    ImGui::End();
    draw_side(context);
    if (context.state.scene) {
        begin_part("##timeline", layout_.timeline, still);
        ImGui::SetCursorPosY(0.5f * (layout_.timeline.height() - ImGui::GetFrameHeight()));
        draw_timeline(context);
        ImGui::End();
        draw_strip(context);
    }
    if (help_.is_open()) {
        begin_part("##help", layout_.help, still);
        help_.draw(context);
        ImGui::End();
    }
    draw_edges(context);
    // Dialogs belong to no part. Their window is one pixel large and takes no input.
    begin_part("##dialogs", {{0.0f, 0.0f}, {1.0f, 1.0f}},
               still | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoInputs);
    // One dialog at a time: a question waits while a file is chosen.
    if (!browser_.is_open()) draw_questions(context);
    browser_.draw(context);
    palette_.draw(context, viewport_, panels_);
    draw_about(context, about_);
    picture_dialog_.draw(context);
    export_dialog_.draw(context);
    if (film_.runs() && film_.draw(context)) {
        film_.cancel();
        context.emit(commands::LogMessage{commands::LogLevel::information, "No pictures were written."});
    }
    ImGui::End();
    react_to_keys(context);
}

void WorkbenchWindow::follow(WindowRequests& requests) {
    const commands::WorkbenchState& state = workbench_->state();
    // Once per request: the dialog must not open again after the user has closed it.
    if (!requests.file && state.asks_where_to_save && !asked_where_) requests.file = save_dialog(state);
    asked_where_ = state.asks_where_to_save;
    if (requests.file) browser_.open(std::move(*requests.file));
    // In every frame, also without boxes: those of a panel that is no longer drawn must disappear.
    box_tool_.offer(std::move(requests.boxes));
    if (!requests.letters.empty()) interface_.need_letters(requests.letters);
    if (requests.task) show_task(*requests.task);
    if (!requests.panel.empty()) show_panel(requests.panel);
    if (requests.help) help_.open(*requests.help);
    if (requests.palette) palette_.open();
    if (requests.about) about_ = true;
    if (requests.clear_distances) distances_.clear();
    if (requests.picture) picture_ = requests.picture;
    // The dialog that requested the image must have disappeared from the window; that takes two frames.
    if (requests.part) part_ = requests.part, part_waits_ = 2;
    if (requests.export_body) export_dialog_.open();
    if (requests.save_view) picture_dialog_.open(state, viewport_.size());
}

}  // namespace myo::ui::panels
