#pragma once

#include "commands/backend.hpp"

// The part of the core's backend that makes trials of recordings. Each function is the one of Backend of its name.

namespace myo {

Result<RecordingFile> read_recording_file(const std::filesystem::path& path, const ReadingOptions& options);
std::vector<SceneMarker> declared_scene_markers(const Scene& scene);
ImportView view_recording(const Scene& scene, const RecordingFile& file, const ImportChoices& choices);
Result<ImportChoices> propose_recording_markers(const Scene& scene, const MeshedBody& body, const RecordingFile& file, const ImportChoices& choices);
Result<double> align_recording(const Scene& scene, const SimulatedTrial& run, const Eigen::VectorXd& time_s, const RecordingFile& file, const ImportChoices& choices);
Result<std::filesystem::path> add_recording_trial(const Scene& scene, const Settings& settings, const RecordingFile& file, const ImportChoices& choices);

}  // namespace myo
