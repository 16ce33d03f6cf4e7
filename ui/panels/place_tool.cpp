#include "panels/place_tool.hpp"

#include <imgui.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "commands/picked_place.hpp"
#include "panels/escape.hpp"
#include "panels/view_points.hpp"

namespace myo::ui::panels {
namespace {

/// The next label after `label`, cyclically, that is not assigned yet; `label` itself if all are.
///
/// @param plain  a mesh without declared markers: labels need a position, not a marker
int next_open(const commands::ImportChoices& choices, int label, bool plain) {
    const int count = static_cast<int>(choices.markers.size());
    for (int step = 1; step < count; ++step) {
        const int other = (label + step) % count;
        const commands::ImportedMarker& marker = choices.markers[static_cast<std::size_t>(other)];
        if (plain ? !marker.rest_m : marker.name.empty()) return other;
    }
    return label;
}

/// Assigns the declared marker under the mouse to the selected label. Returns false if there is none.
bool assign_clicked(const PanelContext& context, const viewport::DrawnScene& scene, const viewport::ViewportState& view,
                    commands::ImportChoices& choices) {
    const commands::RecordingImport& import = *context.state.import;
    std::vector<Eigen::Vector3d> places;
    for (const commands::SceneMarker& own : import.declared) places.push_back(own.rest_m);
    const auto picked = commands::pick_one(places, scene, view.camera, view.size(), view.mouse,
                                           static_cast<double>(marker_reach * context.theme.scale));
    if (picked) commands::assign_marker(choices, static_cast<std::size_t>(import.label), import.declared[*picked].name);
    return picked.has_value();
}

/// The body under the mouse, or close to it: markers sit on edges, and a click there often misses the body by a pixel.
/// Rings of growing radius around the mouse are tried, so that the nearest place is found first.
std::optional<commands::PickedPlace> place_near(const PanelContext& context, const viewport::DrawnScene& scene,
                                                const viewport::ViewportState& view) {
    constexpr int directions = 8;
    const double widest = static_cast<double>(marker_reach * context.theme.scale);
    for (const double reach : {0.0, 0.5 * widest, widest})
        for (int k = 0; k < (reach > 0.0 ? directions : 1); ++k) {
            const double angle = 2.0 * std::numbers::pi * k / directions;
            const Eigen::Vector2d at = view.mouse + reach * Eigen::Vector2d(std::cos(angle), std::sin(angle));
            // reach 0: only the body
            const auto place = commands::pick_place(context.state, scene, view.camera, view.size(), at, 0.0);
            if (place && place->marker < 0) return place;
        }
    return std::nullopt;
}

/// Places the selected label on the body under the mouse. Returns false if the mouse is not over it.
bool place_clicked(const PanelContext& context, const viewport::DrawnScene& scene, const viewport::ViewportState& view,
                   commands::ImportChoices& choices) {
    const commands::RecordingImport& import = *context.state.import;
    const auto place = place_near(context, scene, view);
    if (!place) return false;
    const auto label = static_cast<std::size_t>(import.label);
    choices.markers[label].rest_m = commands::place_at_rest(*place, context.state);
    if (choices.markers[label].name.empty())
        choices.markers[label].name = commands::marker_name(import.file.recording->labels[label]);
    return true;
}

}  // namespace

// The tool is active only while the import asks for it, so it has no state of its own.
bool update_placing(PanelContext& context, const viewport::DrawnScene& scene, const viewport::ViewportState& view) {
    const commands::WorkbenchState& state = context.state;
    if (!state.import || !state.import->placing || !state.body) return false;
    const commands::RecordingImport& import = *state.import;
    const std::string& label = import.file.recording->labels[static_cast<std::size_t>(import.label)];
    // Without declared markers a click gives a position instead of a name.
    const bool plain = import.declared.empty();
    if (escape_closes()) context.emit(commands::ChooseLabel{import.label, false});
    if (view.clicked) {
        // A click that hits nothing changes nothing, and says so. A hit continues with the next label.
        commands::ImportChoices choices = import.choices;
        if (plain ? place_clicked(context, scene, view, choices) : assign_clicked(context, scene, view, choices)) {
            context.emit(commands::ChangeImport{choices});
            context.emit(commands::ChooseLabel{next_open(choices, import.label, plain), true});
        } else {
            context.emit(commands::LogMessage{commands::LogLevel::warning,
                                              plain ? "The click was beside the body: " + label + " is not placed."
                                                    : "The click was on no ring: " + label + " is not assigned."});
        }
    }
    const std::string where = plain ? "Click where " + label + " sits on the body."
                                    : "Click on the ring of the marker for " + label + ".";
    draw_hint(context, view, where + " Esc ends.", "view/placing_hint");
    return true;
}

}  // namespace myo::ui::panels
