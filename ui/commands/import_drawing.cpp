#include "commands/import_drawing.hpp"

#include <algorithm>

#include "commands/scene_at_time.hpp"

namespace myo::ui::commands {

namespace {

/// The target ring and the line to it show how far label i lies from its marker before the start.
void add_target(viewport::DrawnScene& drawn, const ImportView& view, std::size_t i, const platform::Theme& theme,
                bool chosen) {
    const Eigen::Vector3d target = view.target_m.col(static_cast<Eigen::Index>(i));
    if (!target.allFinite()) return;
    drawn.markers.push_back({target, viewport::color_of(chosen ? theme.accent : theme.simulated), true, "", -1});
    const Eigen::Vector3d before = view.before_m.col(static_cast<Eigen::Index>(i));
    if (!before.allFinite()) return;
    Eigen::Matrix3Xd apart(3, 2);
    apart << before, target;
    drawn.lines.push_back({apart, viewport::color_of(theme.failure), 2.0});
}

}  // namespace

void add_import(viewport::DrawnScene& drawn, const WorkbenchState& state, const platform::Theme& theme) {
    const RecordingImport& import = *state.import;
    const measurement::Recording& recording = *import.file.recording;
    // Rings for declared markers that no label is assigned to yet, with their names: targets for clicks.
    for (const SceneMarker& own : import.declared) {
        const auto is_own = [&](const ImportedMarker& m) { return m.name == own.name; };
        if (std::none_of(import.choices.markers.begin(), import.choices.markers.end(), is_own))
            drawn.markers.push_back({own.rest_m, viewport::color_of(theme.text), true, own.name, -1});
    }
    // state.time_s counts from the chosen start, the recording from the beginning of the file.
    const TimePlace place = place_in_time(recording.time_s, state.time_s + import.choices.start_s);
    for (std::size_t i = 0; i < recording.labels.size(); ++i) {
        const ImportedMarker& marker = import.choices.markers[i];
        const bool chosen = static_cast<int>(i) == import.label;
        // From the cameras' frame to that of the body, as the choices place the recording.
        const Eigen::Vector3d now = import.view.rotation * at_time(recording.tracks[i], place) +
                                    import.view.translation_m;
        const std::string& label = marker.name.empty() ? recording.labels[i] : marker.name;
        if (now.allFinite())
            drawn.markers.push_back({now,
                                     viewport::color_of(chosen                ? theme.accent
                                                        : marker.name.empty() ? theme.muted
                                                                              : theme.measured),
                                     false, label, -1});
        add_target(drawn, import.view, i, theme, chosen);
    }
}

}  // namespace myo::ui::commands
