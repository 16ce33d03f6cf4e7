#pragma once

#include "commands/backend.hpp"

// The part of the core's backend that makes trials of recordings. Each function is the one of Backend of its name.

namespace myo::backend {

Result<ui::commands::RecordingFile> read_recording_file(const std::filesystem::path& path,
                                                        const ui::commands::ReadingOptions& options);
std::vector<ui::commands::SceneMarker> declared_scene_markers(const ui::commands::Scene& scene);
ui::commands::ImportView view_recording(const ui::commands::Scene& scene, const ui::commands::RecordingFile& file,
                                        const ui::commands::ImportChoices& choices);
Result<ui::commands::ImportChoices> propose_recording_markers(const ui::commands::Scene& scene,
                                                              const ui::commands::MeshedBody& body,
                                                              const ui::commands::RecordingFile& file,
                                                              const ui::commands::ImportChoices& choices);
Result<double> align_recording(const ui::commands::Scene& scene, const ui::commands::SimulatedTrial& run,
                               const Eigen::VectorXd& time_s, const ui::commands::RecordingFile& file,
                               const ui::commands::ImportChoices& choices);
Result<std::filesystem::path> add_recording_trial(const ui::commands::Scene& scene,
                                                  const ui::commands::Settings& settings,
                                                  const ui::commands::RecordingFile& file,
                                                  const ui::commands::ImportChoices& choices);

}  // namespace myo::backend
