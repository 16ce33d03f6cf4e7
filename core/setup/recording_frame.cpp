#include "setup/recording_frame.hpp"

#include <cmath>

#include "base/text.hpp"
#include "experiment/read_experiment.hpp"
#include "experiment/read_trial.hpp"
#include "measurement/gaps.hpp"
#include "measurement/motion_start.hpp"
#include "measurement/recorded_mount.hpp"
#include "measurement/recording_edit.hpp"
#include "measurement/registration.hpp"
#include "measurement/rest_pose.hpp"

namespace myo::setup {
namespace {

/// Thresholds above which the times of a trace are attributed to another clock than the trial's.
struct ClockPolicy {
    /// Sampling intervals between t = 0 and the first sample that give a warning; a camera may have been started late.
    double late_intervals = 20.0;
    double max_lead = 10.0;  // lead over the length of the trace; nobody simulates so much to compare so little
};
constexpr ClockPolicy clock_policy;

// The trace begins many sampling intervals after t = 0.
bool begins_late(const measurement::Recording& recording) {
    return recording.rate_Hz > 0.0 && recording.time_s(0) * recording.rate_Hz > clock_policy.late_intervals;
}

/// Without start_s, file time is trial time, so the trace must overlap the trial.
Result<void> check_clock(const experiment::Experiment& experiment, const experiment::TrialDeclaration& declaration,
                         const measurement::Recording& recording) {
    const double first = recording.time_s(0), last = recording.time_s(recording.sample_count() - 1);
    if (last >= 0.0 && !(begins_late(recording) && first > clock_policy.max_lead * (last - first))) return {};
    return experiment::declaration_error(
        experiment, experiment::trial_key(experiment, declaration) + ".start_s",
        declaration.trace.filename().string() + " runs from " +
            format_number(first, recording_frame_policy.clock_digits) + " s to " +
            format_number(last, recording_frame_policy.clock_digits) +
            " s, far from the trial's t = 0: it was recorded by another clock; state start_s, the "
            "time in the file at which the trial starts");
}

// Order of precedence: declared start, file time if the recording follows the mesh frame, detected start of motion.
Result<void> find_start(const experiment::Experiment& experiment, const experiment::TrialDeclaration& declaration,
                        const measurement::Recording& recording, PreparedTrial& trial) {
    if (declaration.start_s) {
        trial.start_s = *declaration.start_s;
        trial.start_message = "start declared at " + std::to_string(trial.start_s) + " s of the file";
        return {};
    }
    if (declaration.hold) {
        trial.start_s = recording.time_s(0);
        trial.start_message = "held pose";
        return {};
    }
    if (!is_foreign_recording(experiment, declaration)) {
        trial.start_message = "t = 0 is the file's";
        return check_clock(experiment, declaration, recording);
    }
    std::vector<std::string> body_markers;
    for (const experiment::MarkerDeclaration& marker : experiment.markers.on_body) body_markers.push_back(marker.name);
    const measurement::StartOfMotion start = measurement::find_motion_start(recording, body_markers);
    trial.start_message = start.message;
    trial.start_s = start.time_s;
    // The start remains uncertain by a few frames; the fit may shift it, see free_parameters().
    trial.start_found = start.found;
    // Without any marker to look at there is no time to start from; other doubtful starts are used, with their message.
    if (!start.found && start.last_still < 0 && start.movers.empty())
        return experiment::declaration_error(
            experiment, experiment::trial_key(experiment, declaration) + ".start_s",
            "the start of the motion was not found in the trace (" + start.message + "); state it");
    return {};
}

/// Rest-pose registration: rigid motion, camera to mesh, of all markers visible before the start.
Result<measurement::RigidMotion> register_rest_pose(const experiment::Experiment& experiment,
                                                    const experiment::TrialDeclaration& declaration,
                                                    const measurement::RestPose& pose, PreparedTrial& trial) {
    std::vector<experiment::MarkerDeclaration> declared = experiment.markers.on_body;
    declared.insert(declared.end(), experiment.markers.fixed.begin(), experiment.markers.fixed.end());
    Eigen::Matrix3Xd rest(3, static_cast<Eigen::Index>(declared.size()));
    Eigen::VectorXd weights(rest.cols());
    for (Eigen::Index i = 0; i < rest.cols(); ++i) {
        rest.col(i) = declared[static_cast<std::size_t>(i)].rest_m;
        weights(i) = pose.positions_m.col(i).allFinite() ? 1.0 : 0.0;
    }
    // Occluded markers get weight 0; their NaN is cleared because 0 * NaN is NaN.
    Eigen::Matrix3Xd seen = pose.positions_m;
    for (Eigen::Index i = 0; i < seen.cols(); ++i)
        if (weights(i) == 0.0) seen.col(i).setZero();
    Result<measurement::Registration> fit = measurement::rigid_registration(seen, rest, weights);
    if (!fit)
        return experiment::declaration_error(experiment, experiment::trial_key(experiment, declaration) + ".trace",
                                             "registration: " + fit.error().what);
    trial.registration_rms_m = fit->rms_m;
    // Markers on the mount are exact: only those on the body have a place of their own.
    if (experiment.markers.placement_m > 0.0)
        trial.registration_by_places = measurement::d_registration_d_to(rest, weights)
                                           .leftCols(3 * static_cast<Eigen::Index>(experiment.markers.on_body.size()));
    return fit->motion;
}

/// Positions of the markers before the start, to which displacements refer.
Result<void> set_references(const experiment::Experiment& experiment, const std::string& key,
                            const measurement::RestPose& pose, const measurement::RigidMotion& camera_to_mesh,
                            PreparedTrial& trial) {
    for (std::size_t m = 0; m < experiment.markers.on_body.size(); ++m) {
        // A probe is compared with nothing, so any reference serves.
        if (experiment.markers.on_body[m].probe) {
            trial.reference_m.push_back(experiment.markers.on_body[m].rest_m);
            continue;
        }
        const Eigen::Vector3d mean = camera_to_mesh.apply(pose.positions_m.col(static_cast<Eigen::Index>(m)));
        // Without a reference position the marker has no displacement.
        if (!mean.allFinite())
            return experiment::declaration_error(
                experiment, key + ".trace",
                "marker '" + experiment.markers.on_body[m].name + "' is not seen before the start");
        trial.reference_m.push_back(mean);
    }
    return {};
}

/// End of the compared samples in trial time [s]: declared, or the last sample.
double end_of(const experiment::TrialDeclaration& declaration, const measurement::Recording& placed, double start_s) {
    return declaration.end_s ? *declaration.end_s - start_s : placed.time_s(placed.sample_count() - 1);
}

/// Takes the tracks of the markers on the body, with their gaps.
Result<void> take_samples(const experiment::Experiment& experiment, const std::string& key,
                          measurement::Recording placed, PreparedTrial& trial) {
    // Fixed markers come last and serve registration only.
    placed.labels.resize(experiment.markers.on_body.size());
    placed.tracks.resize(experiment.markers.on_body.size());
    if (!placed.residual_m.empty()) placed.residual_m.resize(experiment.markers.on_body.size());
    // Samples before t = 0 are kept for display but are not compared.
    while (trial.first_sample < placed.sample_count() && placed.time_s(trial.first_sample) < 0.0) ++trial.first_sample;
    if (trial.first_sample >= placed.sample_count())
        return experiment::declaration_error(experiment, key + ".end_s",
                                             "no sample lies between the start and the end of the trial");
    for (const measurement::MarkerGaps& gaps : measurement::gap_map(placed))
        trial.occluded_fraction.push_back(gaps.occluded_fraction);
    trial.measured = std::move(placed);
    return {};
}

/// Motion of the mount from the fixed markers, which come last.
Result<void> find_mount(const experiment::Experiment& experiment, const experiment::TrialDeclaration& declaration,
                        const measurement::Recording& placed, PreparedTrial& trial) {
    if (experiment.mount != experiment::MountMotion::markers) return {};
    const std::vector<experiment::MarkerDeclaration>& fixed = experiment.markers.fixed;
    measurement::Recording seen;
    seen.time_s = placed.time_s;
    // Tracks of the fixed markers follow those of the markers on the body.
    seen.tracks.assign(placed.tracks.end() - static_cast<std::ptrdiff_t>(fixed.size()), placed.tracks.end());
    Eigen::Matrix3Xd rest(3, static_cast<Eigen::Index>(fixed.size()));
    for (Eigen::Index i = 0; i < rest.cols(); ++i) rest.col(i) = fixed[static_cast<std::size_t>(i)].rest_m;
    // The fit finds the frame later, so the motion is taken against the mean place before t = 0, not the declared
    // places.
    const bool limited = !experiment.registration.known &&
                         experiment.registration.method == experiment::RegistrationMethod::limited;
    const Result<measurement::RecordedMount> mount = measurement::recorded_mount(seen, rest, limited);
    if (!mount)
        return experiment::declaration_error(experiment, experiment::trial_key(experiment, declaration) + ".trace",
                                             declaration.trace.filename().string() + ": " + mount.error().what);
    trial.mount = mount->motion;
    trial.mount_gap_s = mount->gap_s;
    // The mount moves by the clock of the recording: with another start the motion would be another one.
    trial.start_found = false;
    return {};
}

}  // namespace

bool is_foreign_recording(const experiment::Experiment& experiment, const experiment::TrialDeclaration& declaration) {
    return experiment.registration.method == experiment::RegistrationMethod::rest_pose ||
           experiment.markers.compare == experiment::Comparison::displacement ||
           measurement::find_trace_reader(declaration.format)->of_cameras;
}

Result<void> place_recording(const experiment::Experiment& experiment, const experiment::TrialDeclaration& declaration,
                             const measurement::Recording& recording, PreparedTrial& trial) {
    const std::string key = experiment::trial_key(experiment, declaration);
    if (const Result<void> started = find_start(experiment, declaration, recording, trial); !started)
        return started.error();
    const bool displacement = experiment.markers.compare == experiment::Comparison::displacement;
    const bool rest_registration = !experiment.registration.known &&
                                   experiment.registration.method == experiment::RegistrationMethod::rest_pose;
    measurement::RigidMotion camera_to_mesh;
    // Displacements need the mean position before the start; only after registration is it in the mesh frame.
    if (displacement || rest_registration) {
        const Result<measurement::RestPose> pose = measurement::rest_pose_before(recording, trial.start_s);
        if (!pose)
            return experiment::declaration_error(experiment, key + ".trace",
                                                 "no rest pose before the start: " + pose.error().what);
        if (rest_registration) {
            const Result<measurement::RigidMotion> motion = register_rest_pose(experiment, declaration, *pose, trial);
            if (!motion) return motion.error();
            camera_to_mesh = *motion;
        }
        if (displacement)
            if (const Result<void> found = set_references(experiment, key, *pose, camera_to_mesh, trial); !found)
                return found.error();
    }
    // Time first, then space; both maps are recorded in `trial` for the report.
    measurement::Recording placed = measurement::transform(measurement::shift_time(recording, -trial.start_s),
                                                           camera_to_mesh);
    // On the whole recording: the motion of the mount is needed before the first and after the last compared sample.
    if (const Result<void> found = find_mount(experiment, declaration, placed, trial); !found) return found.error();
    placed = measurement::slice_time(placed, placed.time_s(0), end_of(declaration, placed, trial.start_s));
    return take_samples(experiment, key, std::move(placed), trial);
}

std::vector<std::string> doubtful_frames(const Setup& setup) {
    std::vector<std::string> warnings;
    const Box body = mesh::bounding_box(setup.surface.vertices);
    for (const PreparedTrial& trial : setup.trials) {
        if (begins_late(trial.measured))
            warnings.push_back("trial " + trial.name + ": its trace begins " +
                               format_number(trial.measured.time_s(0), 4) +
                               " s after the start, t = 0; if its clock began elsewhere, state start_s");
        if (trial.mount_gap_s > recording_frame_policy.mount_gap_s)
            warnings.push_back("trial " + trial.name + ": three markers of the mount are not seen for " +
                               format_number(trial.mount_gap_s, 3) + " s; its motion is bridged there");
        if (trial.registration_rms_m &&
            *trial.registration_rms_m > recording_frame_policy.far_of_body * (body.highest - body.lowest).maxCoeff())
            warnings.push_back("trial " + trial.name + ": before its start the markers are " +
                               format_number(1e3 * *trial.registration_rms_m, 3) +
                               " mm rms from their declared rest positions: was the body at rest, and was the right "
                               "marker meant by each name?");
    }
    return warnings;
}

}  // namespace myo::setup
