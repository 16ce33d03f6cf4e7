#pragma once

#include "commands/backend.hpp"

// Part of the backend that turns recordings into trials. Each function implements a method of Backend of similar name
// (ui/commands/backend.hpp).

namespace myo::backend {

/// Reads a recording and finds its start; see Backend::read_recording(). What the file does not say and the options
/// leave open is assumed for display (1 mm per unit, 100 Hz) and reported by asks_unit and asks_rate.
///
/// Errors: those of the readers; fewer than two samples.
Result<ui::commands::RecordingFile> read_recording_file(const std::filesystem::path& path,
                                                        const ui::commands::ReadingOptions& options);
/// All declared markers of a scene, on the body and fixed, with rest positions [m].
std::vector<ui::commands::SceneMarker> declared_scene_markers(const ui::commands::Scene& scene);
/// Registration of a recording with the current choices, residuals [m] and the first problem.
///
/// @param choices  with one marker per label of the file
ui::commands::ImportView view_recording(const ui::commands::Scene& scene, const ui::commands::RecordingFile& file,
                                        const ui::commands::ImportChoices& choices);
/// Assigns labels to declared markers by position and name; without declared markers, extends three placed ones to all.
///
/// Errors: no assignment found; fewer than three markers placed.
Result<ui::commands::ImportChoices> propose_recording_markers(const ui::commands::Scene& scene,
                                                              const ui::commands::MeshedBody& body,
                                                              const ui::commands::RecordingFile& file,
                                                              const ui::commands::ImportChoices& choices);
/// Start of the recording [s, in the file's time] by correlation with a simulated run.
///
/// @param time_s  sample times of the run
/// Errors: no common marker; correlation below 0.5.
Result<double> align_recording(const ui::commands::Scene& scene, const ui::commands::SimulatedTrial& run,
                               const Eigen::VectorXd& time_s, const ui::commands::RecordingFile& file,
                               const ui::commands::ImportChoices& choices);
/// Writes the recording as a trial: to the experiment, to a copy of it, or to a new experiment for a mesh.
///
/// A bundled example is never changed: the choices must name a folder for its copy, see import_problem().
///
/// @return   folder of the experiment
/// Errors: ImportView::problem; a file cannot be written.
Result<std::filesystem::path> add_recording_trial(const ui::commands::Scene& scene,
                                                  const ui::commands::Settings& settings,
                                                  const ui::commands::RecordingFile& file,
                                                  const ui::commands::ImportChoices& choices);

}  // namespace myo::backend
