#include "panels/compared_view.hpp"

#include <imgui.h>

#include <utility>

namespace myo::ui::panels {
namespace {

/// The state as if the run of the record were shown.
commands::WorkbenchState with_record(const commands::WorkbenchState& state, const commands::JobRecord& record) {
    commands::WorkbenchState other = state;
    // Neither is drawn, and both may be long.
    other.log.clear();
    other.history.clear();
    other.job.reset();  // the best iterate of a running search would be shown instead
    other.preview.run.reset();
    other.live.reset();
    other.diagnosis.reset();
    other.run = record.run;
    if (other.body != record.on.body) {
        other.body = record.on.body;
        other.actuators = record.on.body->actuators;
        other.ground = record.on.ground;
        other.paint.clear();  // paint of another mesh
    }
    return other;
}

}  // namespace

Result<ComparedView> ComparedView::make() {
    auto renderer = viewport::SceneRenderer::make();
    if (!renderer) return renderer.error();
    ComparedView view;
    view.renderer_ = std::move(*renderer);
    return view;
}

const commands::JobRecord* ComparedView::record(const commands::WorkbenchState& state) {
    if (!state.view.side_by_side || state.import) return nullptr;
    const std::vector<std::size_t> compared = commands::compared_records(state);
    if (compared.empty() || !state.history[compared.back()].on.body) return nullptr;
    return &state.history[compared.back()];
}

void ComparedView::update(const commands::WorkbenchState& state, const platform::Theme& theme,
                          const commands::Backend& backend, const viewport::DrawnScene& shown, std::uint64_t revision) {
    if (drawn_ == revision && !fields_.waits()) return;
    // The scene is also made again while values of the field are awaited, to take them as soon as they are there.
    drawn_ = revision;
    const commands::WorkbenchState other = with_record(state, *record(state));
    const std::shared_ptr<const commands::FieldFrame> field = fields_.update(other, backend);
    const std::optional<commands::FieldKind> kind = commands::shown_field(other, backend);
    commands::MotionSummary motion = commands::summarize_motion(other);
    cut_.apply(other, motion);
    scene_ = commands::scene_at_time(other, theme, motion, nullptr, kind ? &*kind : nullptr, field.get());
    // Colours have one meaning on both sides.
    if (scene_.field && shown.field) {
        scene_.field->lowest = shown.field->lowest;
        scene_.field->highest = shown.field->highest;
    }
    ++revision_;
}

void ComparedView::draw(PanelContext& context, viewport::ViewportState& shown) {
    // Both views have one camera: that of the shown view is taken before, and a turn by the mouse is given back after.
    viewport_.camera = shown.camera;
    viewport_.zoom_to_data_requested = false;
    platform::ItemRectangles own;  // the names of the items are those of the shown view
    viewport::draw_viewport(scene_, context.theme, own, viewport_, context.state.view.labels, {});
    context.items.add("view/compared", viewport_.pixels);
    if (viewport_.zoom_to_data_requested) shown.zoom_to_data_requested = true;
    if (viewport_.moving) shown.moving = true, shown.untouched = false;
    shown.camera = viewport_.camera;
    const commands::JobRecord& drawn = *record(context.state);
    draw_run_name(context.theme, viewport_.pixels, drawn.name + " of " + drawn.clock);
}

Result<void> ComparedView::render(const platform::Theme& theme, int height, bool moving) {
    // A view that has no place in the window yet has no size to render.
    if (viewport_.size().width < 2 || viewport_.size().height < 2) return {};
    const auto drawn = renderer_.update(scene_, revision_, viewport::view_colors(theme), viewport_.camera,
                                        viewport_.size(), moving ? 0 : 4, static_cast<double>(theme.scale));
    if (!drawn) return drawn;
    // OpenGL counts rows from the bottom of the window, ImGui from its top.
    renderer_.blit_to_window(static_cast<int>(viewport_.pixels.lowest.x),
                             height - static_cast<int>(viewport_.pixels.highest.y));
    return {};
}

void draw_run_name(const platform::Theme& theme, const platform::Rectangle& view, const std::string& name) {
    // Below the buttons of the view.
    const ImVec2 at{view.lowest.x + 12.0f * theme.scale, view.lowest.y + 48.0f * theme.scale};
    ImGui::PushFont(theme.small);
    ImGui::GetWindowDrawList()->AddText(at, platform::packed(theme.text), name.c_str());
    ImGui::PopFont();
}

}  // namespace myo::ui::panels
