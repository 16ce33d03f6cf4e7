#include "commands/import_drawing.hpp"

#include "commands/scene_at_time.hpp"

namespace myo {

void add_import(DrawnScene& drawn, const WorkbenchState& state, const Theme& theme) {
    const RecordingImport& import = *state.import;
    const Recording& recording = *import.file.recording;
    const auto color_of = [](const ImVec4& c) { return Color(c.x, c.y, c.z, 1.0f); };
    const TimePlace place = place_in_time(recording.time_s, state.time_s + import.choices.start_s);
    for (std::size_t i = 0; i < recording.labels.size(); ++i) {
        const ImportedMarker& marker = import.choices.markers[i];
        const bool chosen = static_cast<int>(i) == import.label;
        const Eigen::Vector3d now = import.view.rotation * at_time(recording.tracks[i], place) + import.view.translation_m;
        const std::string& label = marker.name.empty() ? recording.labels[i] : marker.name;
        if (now.allFinite()) drawn.markers.push_back({now, color_of(chosen ? theme.accent : marker.name.empty() ? theme.muted : theme.measured), false, label, -1});
        const Eigen::Vector3d target = import.view.target_m.col(static_cast<Eigen::Index>(i));
        if (!target.allFinite()) continue;
        drawn.markers.push_back({target, color_of(chosen ? theme.accent : theme.simulated), true, "", -1});
        const Eigen::Vector3d before = import.view.before_m.col(static_cast<Eigen::Index>(i));
        if (!before.allFinite()) continue;
        Eigen::Matrix3Xd apart(3, 2);
        apart << before, target;
        drawn.lines.push_back({apart, color_of(theme.failure), 2.0});
    }
}

}  // namespace myo
