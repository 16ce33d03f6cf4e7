#include "reproduce/real_robots.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "measurement/c3d_reader.hpp"
#include "measurement/column_files.hpp"
#include "measurement/motion_start.hpp"
#include "measurement/noise.hpp"
#include "measurement/recording_edit.hpp"
#include "measurement/registration.hpp"
#include "measurement/rest_pose.hpp"
#include "measurement/trace_csv.hpp"

namespace myo::reproduce {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Markers of a robot with their nominal positions, moving ones first, and the point that they determine.
struct Layout {
    std::vector<std::string> labels;
    std::vector<Vector3d> nominal_mm;
    std::size_t moving = 0;  // number of moving markers
    Vector3d tracked_mm = Vector3d::Zero();
};

/// Marker layouts of the published scripts: the sweep, the steps, and the steps of another recording.
const std::vector<Layout>& arm_layouts() {
    static const std::vector<Vector3d> triangle{{-9.645, -26.5, 0},  {-9.645, 26.5, 0},   {-28.2, 0, 0},
                                                {-50.5, -20.5, 102}, {-30.5, -50.5, 102}, {-10.5, 50.5, 102},
                                                {-50.5, 23.5, 102}};
    static const std::vector<Layout> layouts{
        {{"tip_1", "tip_2", "tip_3", "frame_1", "frame_2", "frame_3", "frame_4"}, triangle, 3},
        {{"Tip - 1", "Tip - 2", "Tip - 3", "Base - 1", "Base - 2", "Base - 3", "Base - 4"}, triangle, 3},
        {{"tip - 1", "tip - 2", "tip - 3", "tip - 4", "base - 1", "base - 2", "base - 3", "base - 4"},
         {{21.4436, 5.746, 0},
          {9.3821, -20.12, 0},
          {-15.69777, -15.69777, 0},
          {-20.12, 9.3821, 0},
          {-43.12, 28.28, 102},
          {14.1, -57.3, 102},
          {-52.31, -19.09, 102},
          {-21.21, -50.19, 102}},
         4}};
    return layouts;
}

/// Layout of the fish tail; its tracked point is the marker on the spine.
const Layout fish_layout{{"spine", "base_1", "base_2", "base_3"},
                         {{0, -14.19, 52.21}, {0, -32, -7}, {-16.12, -32, -26.622}, {16.12, -32, -26.622}},
                         1,
                         {0, -14.19, 52.21}};

/// Affine weights of the moving markers that give the tracked point in x and y: the solution of minimum norm. Three
/// markers have exactly one.
VectorXd tracked_weights(const Layout& layout) {
    const auto n = static_cast<Index>(layout.moving);
    if (n == 1) return VectorXd::Ones(1);
    Matrix3Xd A(3, n);
    for (Index i = 0; i < n; ++i) A.col(i) << 1.0, layout.nominal_mm[static_cast<std::size_t>(i)].head<2>();
    const Vector3d wanted(1.0, layout.tracked_mm(0), layout.tracked_mm(1));
    return A.transpose() * (A * A.transpose()).inverse() * wanted;
}

/// Finds the onset of a recording and turns the displacements into the frame of the robot.
///
/// Errors (place: the file): labels missing; no onset; markers hidden before it.
Result<RobotTrial> make_trial(const measurement::Recording& recording, const Layout& layout,
                              const std::filesystem::path& path) {
    const std::vector<std::string> moving(layout.labels.begin(),
                                          layout.labels.begin() + static_cast<std::ptrdiff_t>(layout.moving));
    const Result<measurement::Recording> all = measurement::select_labels(recording, layout.labels);
    if (!all) return Error{all.error().what, path.string()};
    const measurement::StartOfMotion start = measurement::find_motion_start(*all, moving);
    if (!start.found) return Error{start.message, path.string()};
    const Result<measurement::RestPose> rest = measurement::rest_pose_before(*all, start.time_s);
    if (!rest) return Error{rest.error().what, path.string()};
    Matrix3Xd nominal(3, static_cast<Index>(layout.labels.size()));
    for (Index i = 0; i < nominal.cols(); ++i) nominal.col(i) = 1e-3 * layout.nominal_mm[static_cast<std::size_t>(i)];
    // Frame of the robot from its rest pose, fixed and moving markers together.
    const Result<measurement::Registration> frame = measurement::rigid_registration(rest->positions_m, nominal);
    if (!frame) return Error{frame.error().what, path.string()};
    const VectorXd weights = tracked_weights(layout);
    RobotTrial trial;
    trial.name = path.stem().string();
    trial.frame_rms_m = frame->rms_m;
    trial.time_s = all->time_s.array() - start.time_s;
    trial.tip_m.setZero(3, trial.time_s.size());
    double variance = 0.0;
    for (Index i = 0; i < weights.size(); ++i) {
        const Matrix3Xd& track = all->tracks[static_cast<std::size_t>(i)];
        trial.marker_m.push_back(frame->motion.rotation * (track.colwise() - rest->positions_m.col(i)));
        // Displacements of an affine combination are the combination of the displacements; a hidden marker makes NaN.
        trial.tip_m += weights(i) * trial.marker_m.back();
        const measurement::NoiseEstimate noise = measurement::estimate_track_noise(track);
        // Noise of the tracked point: independent markers, weighted sum.
        variance += std::pow(weights(i) * noise.sigma_m, 2);
    }
    trial.noise_m = std::sqrt(variance);
    return trial;
}

/// Pressure from a file name [mbar]: the whole number before "mbar"; empty if there is none.
std::optional<double> pressure_in(const std::string& name) {
    const std::size_t end = name.find("mbar");
    if (end == std::string::npos) return std::nullopt;
    std::size_t first = end;
    while (first > 0 && name[first - 1] >= '0' && name[first - 1] <= '9') --first;
    double pressure = 0.0;
    const auto [last, code] = std::from_chars(name.data() + first, name.data() + end, pressure);
    return code == std::errc() && last == name.data() + end ? std::optional(pressure) : std::nullopt;
}

/// Files of a folder with this extension and a pressure in their name, sorted; none if the folder does not exist.
std::vector<std::filesystem::path> pressure_files(const std::filesystem::path& folder, const std::string& extension) {
    std::vector<std::filesystem::path> files;
    std::error_code code;
    for (const auto& entry : std::filesystem::directory_iterator(folder, code))
        if (entry.path().extension() == extension && pressure_in(entry.path().stem().string()))
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

/// Reads a recording of the arm, a step (.c3d) or one of the sweep (.csv), with its pressure.
Result<RobotTrial> read_arm_file(const std::filesystem::path& path) {
    const bool stepped = path.extension() == ".c3d";
    const Result<measurement::Recording> read = stepped ? measurement::read_c3d(path)
                                                        : measurement::read_trace_csv(path);
    if (!read) return read.error();
    // The last layout whose labels all occur; the first is the fallback, whose missing labels make a readable error.
    const Layout* layout = &arm_layouts().front();
    for (const Layout& other : arm_layouts())
        if (std::all_of(other.labels.begin(), other.labels.end(),
                        [&](const std::string& label) { return measurement::label_index(*read, label).has_value(); }))
            layout = &other;
    Result<RobotTrial> trial = make_trial(*read, *layout, path);
    if (!trial) return trial.error();
    trial->pressure_mbar = *pressure_in(trial->name);
    trial->stepped = stepped;
    return trial;
}

/// Reads all recordings of a folder in the order of their names; the first error ends the reading.
Result<std::vector<RobotTrial>> read_arm_files(const std::filesystem::path& folder, const std::string& extension) {
    std::vector<RobotTrial> trials;
    for (const std::filesystem::path& path : pressure_files(folder, extension)) {
        Result<RobotTrial> trial = read_arm_file(path);
        if (!trial) return trial.error();
        trials.push_back(std::move(*trial));
    }
    return trials;
}

}  // namespace

Matrix3Xd mean_between(const RobotTrial& trial, double from_s, double until_s) {
    Matrix3Xd sum = Matrix3Xd::Zero(3, 1 + static_cast<Index>(trial.marker_m.size()));
    int count = 0;
    for (Index k = 0; k < trial.time_s.size(); ++k) {
        if (trial.time_s(k) < from_s || trial.time_s(k) > until_s || !trial.tip_m.col(k).allFinite()) continue;
        sum.col(0) += trial.tip_m.col(k);
        for (std::size_t i = 0; i < trial.marker_m.size(); ++i)
            sum.col(1 + static_cast<Index>(i)) += trial.marker_m[i].col(k);
        ++count;
    }
    return sum / static_cast<double>(count);
}

double bending_direction(const std::vector<Matrix3Xd>& poses_m, double bends_to) {
    double x = 0.0, y = 0.0;
    for (const Matrix3Xd& pose : poses_m) {
        // Unit vectors are averaged, not angles: angles jump at half a turn, and small displacements count like large
        // ones.
        const double radius = std::hypot(pose(0, 0), pose(1, 0));
        x += bends_to * pose(0, 0) / radius;
        y += bends_to * pose(1, 0) / radius;
    }
    return std::atan2(y, x);
}

Result<std::vector<RobotTrial>> read_arm_sweep(const ReproduceSettings& settings) {
    Result<std::vector<RobotTrial>> trials = read_arm_files(settings.data / "data/mocap/arm_pressure_sweep", ".csv");
    if (trials)
        std::sort(trials->begin(), trials->end(),
                  [](const RobotTrial& a, const RobotTrial& b) { return a.pressure_mbar < b.pressure_mbar; });
    return trials;
}

Result<std::vector<RobotTrial>> read_arm_steps(const ReproduceSettings& settings) {
    return read_arm_files(settings.data / "data/mocap/arm", ".c3d");
}

Result<std::vector<RobotTrial>> read_fish(const ReproduceSettings& settings) {
    std::vector<RobotTrial> trials;
    const std::filesystem::path path = settings.data / "data/mocap/fish/soft_fish_data.csv";
    if (!std::filesystem::exists(path)) return trials;
    const Result<measurement::Recording> read = measurement::read_columns(
        path, {.labels = fish_layout.labels, .metres_per_unit = 1e-3, .separator = ';', .rate_Hz = 100.0});
    if (!read) return read.error();
    Result<RobotTrial> trial = make_trial(*read, fish_layout, path);
    if (!trial) return trial.error();
    trials.push_back(std::move(*trial));
    return trials;
}

}  // namespace myo::reproduce
