#include "reproduce/real_beam.hpp"

#include "measurement/c3d_reader.hpp"
#include "measurement/motion_start.hpp"
#include "measurement/recording_edit.hpp"
#include "measurement/registration.hpp"
#include "measurement/rest_pose.hpp"
#include "reproduce/paper_beam.hpp"

namespace myo::reproduce {
namespace {

using Eigen::Matrix3Xd;

/// A recording and the weight of its test.
struct TrialFile {
    const char* name;
    double tip_force_N;
};
constexpr double weight_N = 1.00062;  // of the scripts; the paper's table prints 0.991
constexpr TrialFile trial_files[] = {{"beam_gravity_V2_a", 0.0},
                                     {"beam_gravity_V2_b", 0.0},
                                     {"beam_load101_V2_a", weight_N},
                                     {"beam_load101_V2_b", weight_N}};

const std::vector<std::string> tip_labels{"Tip - 1", "Tip - 2", "Tip - 3"};

/// Nominal marker positions, tip then base [m], in the frame of the beam.
Matrix3Xd nominal_positions() {
    Matrix3Xd X(3, 6);
    X << 0, 0, 0, -94, -94, -94, 15, -6, 36, -10, 40, 40, 36, 24, 6, -1, 27.5, 0;
    return 1e-3 * X;
}

/// Reads a recording, finds the release and turns the displacements into the frame of the beam.
///
/// Errors (place: the file): those of the reader; labels missing; no release; markers hidden before it or at the end.
Result<BeamTrial> read_trial_file(const std::filesystem::path& path, const TrialFile& file) {
    const Result<measurement::Recording> read = measurement::read_c3d(path);
    if (!read) return read.error();
    const Result<measurement::Recording> all = measurement::select_labels(
        *read, {"Tip - 1", "Tip - 2", "Tip - 3", "Base - 1", "Base - 2", "Base - 3"});
    if (!all) return Error{all.error().what, path.string()};
    const measurement::StartOfMotion start = measurement::find_motion_start(*all, tip_labels);
    if (!start.found) return Error{start.message, path.string()};
    const Result<measurement::RestPose> rest = measurement::rest_pose_before(*all, start.time_s);
    if (!rest) return Error{rest.error().what, path.string()};
    // The held pose registers the camera frame to the beam; displacements then need the rotation only.
    const Result<measurement::Registration> frame = measurement::rigid_registration(rest->positions_m,
                                                                                    nominal_positions());
    if (!frame) return Error{frame.error().what, path.string()};
    BeamTrial trial;
    trial.name = file.name;
    trial.tip_force_N = file.tip_force_N;
    trial.frame_rms_m = frame->rms_m;
    trial.time_s = all->time_s.array() - start.time_s;
    // The last fifth is taken for the beam at rest.
    const Eigen::Index tail = std::max<Eigen::Index>(1, trial.time_s.size() / 5);
    for (Eigen::Index i = 0; i < 3; ++i) {
        const Matrix3Xd& track = all->tracks[static_cast<std::size_t>(i)];
        trial.displacement_m.push_back(frame->motion.rotation * (track.colwise() - rest->positions_m.col(i)));
        trial.steady_m.col(i) = trial.displacement_m.back().rightCols(tail).rowwise().mean();
    }
    if (!trial.steady_m.allFinite())
        return Error{"markers of the tip are hidden where the beam is at rest", path.string()};
    return trial;
}

}  // namespace

Result<std::vector<BeamTrial>> read_beam_trials(const ReproduceSettings& settings) {
    std::vector<BeamTrial> trials;
    for (const TrialFile& file : trial_files) {
        const std::filesystem::path path = settings.data / "data/mocap/beam" / (std::string(file.name) + ".c3d");
        if (!std::filesystem::exists(path)) continue;
        Result<BeamTrial> trial = read_trial_file(path, file);
        if (!trial) return trial.error();
        trials.push_back(std::move(*trial));
    }
    return trials;
}

inverse::DampedCosine measured_vibration(const BeamTrial& trial) {
    const Matrix3Xd& left = trial.displacement_m[left_marker];
    // A hand releases slowly: the first half period, about 65 ms, is not free yet. After 1.5 s a thirtieth is left.
    std::vector<Eigen::Index> used;
    for (Eigen::Index k = 0; k < trial.time_s.size(); ++k)
        if (trial.time_s(k) >= 0.065 && trial.time_s(k) <= 1.5 && left.col(k).allFinite()) used.push_back(k);
    if (used.size() < 8) return {};
    return inverse::fit_damped_cosine(trial.time_s(used), left.row(2).transpose()(used));
}

}  // namespace myo::reproduce
