#include "panels/tendon_tool.hpp"

#include <imgui.h>

#include "commands/picked_place.hpp"
#include "panels/actuator_edits.hpp"
#include "panels/view_points.hpp"
#include "viewport/picking.hpp"

namespace myo::ui::panels {
namespace {

constexpr double thread_width = 2.5;  // [pixels]
constexpr float guide_radius = 5.0f;  // of the dot of a guide [pixels at scale 1]
/// A tendon has at least two guides.
constexpr std::size_t least_guides = 2;

/// Places as columns, 3 x n.
Eigen::Matrix3Xd matrix_of(const std::vector<Eigen::Vector3d>& places) {
    Eigen::Matrix3Xd matrix(3, static_cast<Eigen::Index>(places.size()));
    for (std::size_t i = 0; i < places.size(); ++i) matrix.col(static_cast<Eigen::Index>(i)) = places[i];
    return matrix;
}

/// Whether a key was pressed for the view, and not for a text field.
bool pressed(ImGuiKey key) { return ImGui::IsKeyPressed(key, false) && !ImGui::GetIO().WantTextInput; }

/// Dots at the guides, with a ring around the one that was clicked last.
void draw_guides(const ToolView& tool, const std::vector<Eigen::Vector3d>& places, int chosen) {
    const platform::Theme& theme = tool.context.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto at = window_pixel(tool.view, places[i]);
        if (!at) continue;
        list.AddCircleFilled(*at, (guide_radius + 1.5f) * theme.scale, IM_COL32(0, 0, 0, 160));
        list.AddCircleFilled(*at, guide_radius * theme.scale, platform::packed(theme.accent));
        if (static_cast<int>(i) == chosen) draw_place_ring(tool, places[i]);
    }
}

}  // namespace

std::vector<Eigen::Vector3d> TendonTool::guides(const commands::WorkbenchState& state, const Placing& placing) const {
    if (placing.tendon < 0) return begun_m_;
    std::vector<Eigen::Vector3d> places;
    const auto tendon = static_cast<std::size_t>(placing.tendon);
    if (tendon < state.scene->declared.tendons.size())
        for (const auto& guide : state.scene->declared.tendons[tendon].path_m.colwise()) places.emplace_back(guide);
    return places;
}

bool TendonTool::takes(const commands::WorkbenchState& state, const Placing& placing, const viewport::DrawnScene& scene,
                       const viewport::ViewportState& view, const Eigen::Vector2d& pixel, double reach) const {
    return commands::pick_one(guides(state, placing), scene, view.camera, view.size(), pixel, reach).has_value();
}

bool TendonTool::drag_guides(const ToolView& tool, const Placing& placing, std::vector<Eigen::Vector3d>& places) {
    const auto under = commands::pick_one(places, tool.scene, tool.view.camera, tool.view.size(), tool.view.mouse,
                                          tool.reach());
    // A guide moves in the plane of the image through its place, so that its depth in the view stays.
    const PointDrag::End end = drag_.follow(tool.view, under, [&](std::size_t guide) -> std::optional<Eigen::Vector3d> {
        if (guide >= places.size()) return std::nullopt;
        return viewport::in_image_plane(tool.view.camera, tool.view.size(), tool.view.mouse, places[guide]);
    });
    const auto held = static_cast<std::size_t>(std::max(0, drag_.point()));
    // The held guide is shown where it is held; the declaration follows at the release.
    if ((drag_.held() || end == PointDrag::End::drop) && drag_.place_m() && held < places.size())
        places[held] = *drag_.place_m();
    if (end != PointDrag::End::none) chosen_ = drag_.point();
    if (end == PointDrag::End::drop) {
        if (placing.tendon < 0)
            begun_m_ = places;
        else
            set_tendon_path(tool.context, static_cast<std::size_t>(placing.tendon), matrix_of(places), "tendon/drag");
    }
    return under.has_value() || drag_.held() || end != PointDrag::End::none;
}

void TendonTool::react_to_keys(const ToolView& tool, Placing& placing, const std::vector<Eigen::Vector3d>& places) {
    if (pressed(ImGuiKey_Delete) && chosen_ >= 0 && chosen_ < static_cast<int>(places.size())) {
        std::vector<Eigen::Vector3d> left = places;
        left.erase(left.begin() + chosen_);
        // A declared tendon keeps two guides; a new one may lose all.
        if (placing.tendon < 0)
            begun_m_ = left;
        else if (left.size() >= least_guides)
            set_tendon_path(tool.context, static_cast<std::size_t>(placing.tendon), matrix_of(left), "tendon/guide");
        chosen_ = -1;
    }
    if (!pressed(ImGuiKey_Enter) && !pressed(ImGuiKey_KeyPadEnter)) return;
    // Enter too early is ignored: a thread with one guide cannot be declared.
    if (placing.tendon < 0 && begun_m_.size() < least_guides) return;
    if (placing.tendon < 0) add_tendon(tool.context, matrix_of(begun_m_));
    begun_m_.clear();
    placing = {};
}

void TendonTool::update(const ToolView& tool, Placing& placing) {
    std::vector<Eigen::Vector3d> places = guides(tool.context.state, placing);
    const bool taken = drag_guides(tool, placing, places);
    if (tool.clicked() && !taken && placing.tendon < 0)
        if (const auto place = surface_under_mouse(tool)) {
            // New guides lie below the clicked surface, as channels in a body do.
            begun_m_.push_back(place->point - placing.depth_m * tool.surface.normal(place->triangle));
            places = begun_m_;
            chosen_ = static_cast<int>(places.size()) - 1;
        }
    const std::string hint = placing.tendon >= 0            ? "Drag a guide, Delete removes it. Esc ends."
                             : places.empty()               ? "Click the motor's end of the tendon. Esc ends."
                             : places.size() < least_guides ? "Click the next guide. Esc drops the tendon."
                                                            : "Click the next guide. Enter ends the tendon.";
    draw_guides(tool, places, chosen_);
    draw_hint(tool.context, tool.view, hint, "view/placing_hint");
    react_to_keys(tool, placing, places);
    // The scene is drawn again only if the thread has changed.
    if (!placing.on() || places != shown_m_) ++revision_;
    shown_m_ = placing.on() ? places : std::vector<Eigen::Vector3d>{};
}

void TendonTool::show(const platform::Theme& theme, viewport::DrawnScene& drawn) const {
    if (shown_m_.size() >= least_guides)
        drawn.lines.push_back({matrix_of(shown_m_), viewport::color_of(theme.accent), thread_width});
}

bool TendonTool::cancel() {
    const bool any = drag_.held() || !begun_m_.empty();
    // During a drag only the drag is dropped; the guides that were clicked stay.
    if (!drag_.held()) begun_m_.clear(), shown_m_.clear();
    drag_.cancel();
    chosen_ = -1;
    return any;
}

}  // namespace myo::ui::panels
