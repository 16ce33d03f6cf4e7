#include "backend/recording_import.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "backend/core_scene.hpp"
#include "backend/declaration.hpp"
#include "backend/import_problem.hpp"
#include "commands/place_text.hpp"
#include "experiment/new_trial.hpp"
#include "measurement/gaps.hpp"
#include "measurement/marker_labels.hpp"
#include "measurement/marker_match.hpp"
#include "measurement/motion_start.hpp"
#include "measurement/recording_edit.hpp"
#include "measurement/registration.hpp"
#include "measurement/rest_pose.hpp"
#include "measurement/time_alignment.hpp"
#include "measurement/trace_file.hpp"
#include "mesh/closest_point.hpp"

namespace myo::backend {

namespace fs = std::filesystem;
using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

namespace {

constexpr double unseen = std::numeric_limits<double>::quiet_NaN();
/// For the display of a file without a unit, until the user states one; it cannot be added before.
constexpr double unstated_unit_m = 1e-3;

/// Letters and digits in lower case, so that "Tip - 2" equals "tip_2".
std::string plain(const std::string& name) {
    std::string result;
    for (const char c : name)
        if (std::isalnum(static_cast<unsigned char>(c)))
            result += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return result;
}

/// Mean positions before the start, camera frame [m]; NaN if not visible.
Matrix3Xd places_before(const ui::commands::RecordingFile& file, double start_s) {
    const Result<measurement::RestPose> pose = measurement::rest_pose_before(*file.recording, start_s);
    return pose ? pose->positions_m : Matrix3Xd::Constant(3, static_cast<Index>(file.recording->labels.size()), unseen);
}

/// Registration by all pairs of recorded and known positions; three non-collinear ones also determine the rotation.
///
/// @param view   with target_m; receives rotation, translation and how they were found
/// @param seen   mean positions before the start, 3 x labels [m], camera frame
/// @param pairs  labels with both positions
void place_by_pairs(ui::commands::ImportView& view, const ui::commands::Scene& scene,
                    const ui::commands::ImportChoices& choices, const Matrix3Xd& seen,
                    const std::vector<Index>& pairs) {
    const Index count = seen.cols();
    const Matrix3Xd from = seen(Eigen::all, pairs), to = view.target_m(Eigen::all, pairs);
    // The axes that the user chose count unless the markers determine the rotation.
    view.rotation = axes_rotation(choices.axes);
    const std::string number = std::to_string(pairs.size()) + (pairs.size() == 1 ? " marker" : " markers");
    const Result<measurement::Registration> fit = choices.turns ? measurement::rigid_registration(from, to)
                                                                : Result<measurement::Registration>(Error{"", ""});
    if (fit) {
        view.rotation = fit->motion.rotation;
        view.translation_m = fit->motion.translation;
        view.placed_by = "Turned and shifted by " + number + ".";
    } else if (!pairs.empty()) {
        view.translation_m = (to - view.rotation * from).rowwise().mean();
        view.placed_by = "Shifted by " + number +
                         (choices.turns ? "; three that are not collinear turn it, too." : ".");
    } else {
        // Without pairs the centre of the markers is placed at the centre of the body, so that they are visible.
        Vector3d sum = Vector3d::Zero();
        int finite = 0;
        for (Index i = 0; i < count; ++i)
            if (seen.col(i).allFinite()) sum += seen.col(i), ++finite;
        const Box box = scene.surface.vertices.cols() > 0 ? mesh::bounding_box(scene.surface.vertices) : Box{};
        view.translation_m = 0.5 * (box.lowest + box.highest) - view.rotation * sum / std::max(1, finite);
        view.placed_by = "Not placed yet: its centre is put on the centre of the body.";
    }
}

/// Labels matched to the declared markers, by distances and by names. `size`: diagonal of the body [m].
Result<std::vector<ui::commands::ImportedMarker>> matched_markers(const ui::commands::RecordingFile& file,
                                                                  const ui::commands::ImportChoices& choices,
                                                                  const std::vector<ui::commands::SceneMarker>& markers,
                                                                  double size) {
    const std::vector<std::string>& labels = file.recording->labels;
    std::vector<ui::commands::ImportedMarker> by_distance(choices.markers.size());
    Matrix3Xd rest(3, static_cast<Index>(markers.size()));
    for (std::size_t m = 0; m < markers.size(); ++m) rest.col(static_cast<Index>(m)) = markers[m].rest_m;
    const Matrix3Xd seen = places_before(file, choices.start_s);
    // Markers may deviate from their rest positions by 3 % of the body's diagonal.
    const Result<measurement::MarkerMatch> match = measurement::match_markers(rest, seen, 0.03 * size,
                                                                              axes_rotation(choices.axes));
    if (!match) return match.error();
    for (std::size_t m = 0; m < markers.size(); ++m)
        if (const int label = match->seen[static_cast<Index>(m)]; label >= 0)
            by_distance[static_cast<std::size_t>(label)].name = markers[m].name;
    // Names decide if positions are ambiguous or do not match.
    Index named = 0;
    std::vector<ui::commands::ImportedMarker> by_name(labels.size());
    std::vector<std::string> plain_labels;
    for (const std::string& label : labels) {
        // A colon divides subject and name, see find_labels().
        const std::string_view name = measurement::without_subject(label);
        plain_labels.push_back(name.size() == label.size() ? plain(label)
                                                           : plain(label.substr(0, label.size() - name.size())) + ":" +
                                                                 plain(std::string(name)));
    }
    for (const ui::commands::SceneMarker& marker : markers)
        if (const auto found = measurement::find_labels(plain_labels, plain(marker.name)); found.size() == 1)
            by_name[found.front()].name = marker.name, ++named;
    // A symmetric arrangement of markers fits in several ways; three names are then the better evidence.
    if (named >= 3 && (!match->unique || match->count() < named)) return by_name;

    return by_distance;
}

/// The trial, still without tracks. It is written in the mesh frame and in trial time, so no registration remains to be
/// done.
experiment::NewTrial new_trial(const ui::commands::RecordingFile& file, const ui::commands::ImportChoices& choices,
                               double rms_m, const measurement::Recording& placed) {
    experiment::NewTrial trial;
    trial.name = choices.trial;
    trial.role = choices.fit ? experiment::TrialRole::fit : experiment::TrialRole::validate;
    trial.start = choices.straight ? experiment::StartState::straight : experiment::StartState::equilibrium;
    char about[200];
    std::snprintf(about, sizeof about, " from %.6g s on, registered with %.3g mm rms", choices.start_s, 1e3 * rms_m);
    trial.origin = "From " + file.path.filename().string() + about + ".";
    // Tracks follow in add_recording_trial(), under the names of markers instead of labels.
    trial.recording.time_s = placed.time_s;
    trial.recording.rate_Hz = placed.rate_Hz;
    return trial;
}

/// The declaration with the markers that the user placed during the import.
Result<ui::commands::Declaration> declare_placed(const ui::commands::Scene& scene,
                                                 const ui::commands::Declaration& declaration,
                                                 const ui::commands::ImportChoices& choices,
                                                 const ui::commands::ImportView& view) {
    std::vector<ui::commands::DeclarationEdit> edits;
    for (std::size_t i = 0; i < choices.markers.size(); ++i)
        if (const std::string& name = choices.markers[i].name; !name.empty())
            edits.push_back(ui::commands::SetDeclared{
                {"markers", "rest_m", name}, ui::commands::place_text(view.target_m.col(static_cast<Index>(i)))});
    return edited_declaration(scene, declaration, edits);
}

/// Adds the trial to the experiment in `from`, or to a copy of it in `to`, with the edits of the window.
Result<fs::path> add_to_folder(const fs::path& from, const fs::path& to, const experiment::NewTrial& trial,
                               const ui::commands::Declaration& edited) {
    fs::path folder = from;
    const bool elsewhere = !to.empty() && to != folder;
    if (elsewhere)
        if (const Result<void> copied = experiment::copy_experiment(folder, to); !copied) return copied.error();
    if (elsewhere) folder = to;
    if (const Result<void> added = experiment::add_trial(folder, trial, edited.text.get()); !added) {
        std::error_code ignored;
        // The copy is removed if the trial could not be added.
        if (elsewhere) fs::remove_all(folder, ignored);
        return added.error();
    }
    return folder;
}

}  // namespace

Result<ui::commands::RecordingFile> read_recording_file(const fs::path& path,
                                                        const ui::commands::ReadingOptions& options) {
    // The window asks for unit and rate only if the file lacks them.
    Result<measurement::TraceSource> source = measurement::guess_trace_source(path);
    if (!source) return source.error();
    ui::commands::RecordingFile file;
    file.path = path;
    file.reading = options;
    const measurement::TraceReader& reader = *measurement::find_trace_reader(source->format);
    file.format = reader.label;
    if (source->columns) {
        file.asks_unit = file.asks_rate = true;
        // A usual rate of motion capture until the user states another one.
        if (file.reading.rate_Hz <= 0.0) file.reading.rate_Hz = 100.0;
        source->columns->metres_per_unit = file.reading.metres_per_unit.value_or(unstated_unit_m);
        source->columns->rate_Hz = file.reading.rate_Hz;
        source->columns->zero_is_occluded = options.zero_is_occluded;
    }
    // Some formats have a unit in some files only: the reader fails without one, and a second attempt assumes it.
    Result<measurement::Recording> read = measurement::read_trace(path, *source);
    if (!read && reader.may_lack_unit) {
        file.asks_unit = true;
        source->metres_per_unit = file.reading.metres_per_unit.value_or(unstated_unit_m);
        read = measurement::read_trace(path, *source);
    }
    if (!read) return read.error();
    if (read->labels.empty() || read->sample_count() < 2) return Error{"holds no samples of markers", path.string()};
    // One entry per label, in their order.
    for (const measurement::MarkerGaps& gaps : measurement::gap_map(*read))
        file.seen.push_back(1.0 - gaps.occluded_fraction);
    const measurement::StartOfMotion start = measurement::find_motion_start(*read);
    if (start.found) file.start_s = start.time_s;
    file.start_message = start.message;
    file.recording = std::make_shared<const measurement::Recording>(std::move(*read));
    return file;
}

std::vector<ui::commands::SceneMarker> declared_scene_markers(const ui::commands::Scene& scene) {
    std::vector<ui::commands::SceneMarker> markers;
    const experiment::MarkersDeclaration& own = source_of(scene).experiment.markers;
    for (const experiment::MarkerDeclaration& marker : experiment::recorded_markers(own))
        markers.push_back({marker.name, marker.rest_m});
    return markers;
}

ui::commands::ImportView view_recording(const ui::commands::Scene& scene, const ui::commands::RecordingFile& file,
                                        const ui::commands::ImportChoices& choices) {
    const auto count = static_cast<Index>(file.recording->labels.size());
    const Matrix3Xd seen = places_before(file, choices.start_s);
    const std::vector<ui::commands::SceneMarker> markers = declared_scene_markers(scene);
    ui::commands::ImportView view;
    view.target_m = Matrix3Xd::Constant(3, count, unseen);
    std::vector<Index> pairs;
    for (Index i = 0; i < count; ++i) {
        const ui::commands::ImportedMarker& marker = choices.markers[static_cast<std::size_t>(i)];
        if (marker.name.empty()) continue;
        if (marker.rest_m)
            view.target_m.col(i) = *marker.rest_m;
        else if (const ui::commands::SceneMarker* own = marker_named(markers, marker.name))
            view.target_m.col(i) = own->rest_m;
        if (view.target_m.col(i).allFinite() && seen.col(i).allFinite()) pairs.push_back(i);
    }
    place_by_pairs(view, scene, choices, seen, pairs);
    // NaN stays NaN: labels without a place have no residual.
    view.before_m = (view.rotation * seen).colwise() + view.translation_m;
    view.residual_m = (view.before_m - view.target_m).colwise().norm();
    double squares = 0.0;
    for (const Index i : pairs) squares += view.residual_m[i] * view.residual_m[i];
    view.rms_m = pairs.empty() ? unseen : std::sqrt(squares / static_cast<double>(pairs.size()));
    // Last, as import_problem() reads the registered view.
    const bool unit_is_open = file.asks_unit && !file.reading.metres_per_unit;
    view.problem = unit_is_open ? "Choose the unit of the file's lengths." : import_problem(scene, choices, view);
    return view;
}

Result<ui::commands::ImportChoices> propose_recording_markers(const ui::commands::Scene& scene,
                                                              const ui::commands::MeshedBody& body,
                                                              const ui::commands::RecordingFile& file,
                                                              const ui::commands::ImportChoices& choices) {
    ui::commands::ImportChoices proposed = choices;
    const std::vector<ui::commands::SceneMarker> markers = declared_scene_markers(scene);
    const std::vector<std::string>& labels = file.recording->labels;
    const double size = scene.surface.vertices.cols() > 0 ? mesh::bounding_box(scene.surface.vertices).size().norm()
                                                          : 0.1;
    if (!markers.empty()) {
        const auto matched = matched_markers(file, choices, markers, size);
        if (!matched) return matched.error();
        proposed.markers = *matched;
        return proposed;
    }
    const ui::commands::ImportView view = view_recording(scene, file, choices);
    // Three placed markers determine the rigid motion; the others follow from it and are projected onto the surface.
    const auto placed = std::count_if(choices.markers.begin(), choices.markers.end(),
                                      [](const ui::commands::ImportedMarker& m) { return m.rest_m.has_value(); });
    if (placed < 3)
        return Error{"Click where three of the markers sit on the body; the others can then be matched.", ""};
    const mesh::BoundaryLocator surface(body.mesh, body.boundary);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        const Vector3d place = view.before_m.col(static_cast<Index>(i));
        if (proposed.markers[i].rest_m || !place.allFinite()) continue;
        const mesh::BoundaryPoint nearest = mesh::closest_boundary_point(surface, place);
        if (nearest.distance > 0.1 * size) continue;  // on the mount, or no marker of the body
        proposed.markers[i].rest_m = nearest.point;
        if (proposed.markers[i].name.empty()) proposed.markers[i].name = ui::commands::marker_name(labels[i]);
    }
    return proposed;
}

Result<double> align_recording(const ui::commands::Scene& scene, const ui::commands::SimulatedTrial& run,
                               const Eigen::VectorXd& time_s, const ui::commands::RecordingFile& file,
                               const ui::commands::ImportChoices& choices) {
    std::vector<Matrix3Xd> simulated, recorded;
    const ui::commands::ImportView view = view_recording(scene, file, choices);
    for (std::size_t i = 0; i < choices.markers.size(); ++i)
        for (std::size_t m = 0; m < scene.markers.size() && m < run.markers.size(); ++m) {
            if (choices.markers[i].name != scene.markers[m].name || run.markers[m].cols() != time_s.size()) continue;
            simulated.push_back(run.markers[m]);
            // The translation is left out: only displacements are correlated.
            recorded.push_back(view.rotation * file.recording->tracks[i]);
        }
    // At least one marker must be in the recording and in the run.
    if (simulated.empty()) return Error{"No marker of the recording has been simulated.", ""};
    const Result<measurement::TimeAlignment> found = measurement::align_in_time(time_s, simulated,
                                                                                file.recording->time_s, recorded);
    if (!found) return found.error();
    if (found->correlation < 0.5) return Error{"The recording does not resemble the run.", ""};
    return found->delay_s;
}

Result<fs::path> add_recording_trial(const ui::commands::Scene& scene, const ui::commands::Settings& settings,
                                     const ui::commands::RecordingFile& file,
                                     const ui::commands::ImportChoices& choices) {
    const ui::commands::ImportView view = view_recording(scene, file, choices);
    if (!view.problem.empty()) return Error{view.problem, ""};
    // Mesh frame and trial time from here on.
    const measurement::Recording placed = measurement::shift_time(
        measurement::transform(*file.recording, {view.rotation, view.translation_m}), -choices.start_s);
    experiment::Experiment declared = with_settings(source_of(scene).experiment, settings);
    experiment::NewTrial trial = new_trial(file, choices, view.rms_m, placed);
    const auto add = [&](const std::string& name, Matrix3Xd track) {
        trial.recording.labels.push_back(name);
        trial.recording.tracks.push_back(std::move(track));
    };
    // Three cases: a plain mesh becomes an experiment, an experiment without markers gets those that were placed, one
    // with markers gets a trial only.
    if (!has_trials(scene)) {
        declared.markers = {};
        for (std::size_t i = 0; i < choices.markers.size(); ++i) {
            const std::string& name = choices.markers[i].name;
            if (name.empty()) continue;
            declared.markers.on_body.push_back({name, view.target_m.col(static_cast<Index>(i)), name});
            add(name, placed.tracks[i]);
        }
        const Result<void> written = experiment::write_experiment(choices.folder, declared, source_of(scene).surface,
                                                                  trial);
        if (!written) return written.error();
        return choices.folder;
    }
    if (!has_markers(scene)) {
        Result<ui::commands::Declaration> named = declare_placed(scene, settings.declaration, choices, view);
        if (!named) return named.error();
        for (std::size_t i = 0; i < choices.markers.size(); ++i)
            if (!choices.markers[i].name.empty()) add(choices.markers[i].name, placed.tracks[i]);
        return add_to_folder(declared.folder, choices.folder, trial, *named);
    }
    for (const ui::commands::SceneMarker& own : declared_scene_markers(scene)) {
        const auto found = std::find_if(choices.markers.begin(), choices.markers.end(),
                                        [&](const ui::commands::ImportedMarker& m) { return m.name == own.name; });
        // A declared marker that was not recorded is occluded throughout.
        add(own.name, found != choices.markers.end()
                          ? placed.tracks[static_cast<std::size_t>(found - choices.markers.begin())]
                          : Matrix3Xd::Constant(3, placed.sample_count(), unseen));
    }
    return add_to_folder(declared.folder, choices.folder, trial, settings.declaration);
}

}  // namespace myo::backend
