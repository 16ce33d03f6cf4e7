#include "panels/place_tool.hpp"

#include <imgui.h>

#include "commands/picked_place.hpp"
#include "panels/view_points.hpp"

namespace myo {
namespace {

/// The next label without a place, from `label` on and round; `label` itself when all have one.
int next_unplaced(const ImportChoices& choices, int label) {
    const int count = static_cast<int>(choices.markers.size());
    for (int step = 1; step < count; ++step) {
        const int other = (label + step) % count;
        if (!choices.markers[static_cast<std::size_t>(other)].rest_m) return other;
    }
    return label;
}

}  // namespace

bool update_placing(PanelContext& context, const DrawnScene& scene, const ViewportState& view) {
    const WorkbenchState& state = context.state;
    if (!state.import || !state.import->placing || !state.body) return false;
    const RecordingImport& import = *state.import;
    const std::string& label = import.file.recording->labels[static_cast<std::size_t>(import.label)];
    if (escape_pressed()) context.emit(command::ChooseLabel{import.label, false});
    if (view.clicked) {
        const auto place = pick_place(state, scene, view.camera, view.size(), view.mouse, 0.0);
        if (place && place->marker < 0) {
            ImportChoices choices = import.choices;
            ImportedMarker& marker = choices.markers[static_cast<std::size_t>(import.label)];
            marker.rest_m = place_at_rest(*place, state);
            if (marker.name.empty()) marker.name = marker_name(label);
            context.emit(command::ChangeImport{choices});
            context.emit(command::ChooseLabel{next_unplaced(choices, import.label), true});
        }
    }
    draw_hint(context, view, "Click where " + label + " sits on the body. Esc ends.", "view/placing_hint");
    return true;
}

}  // namespace myo
