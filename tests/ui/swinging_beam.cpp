#include "ui/swinging_beam.hpp"

#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <thread>

#include "mesh/box_mesh.hpp"

namespace myo::test {
namespace {

const Box body_box{{0.0, 0.0, 0.0}, {0.1, 0.03, 0.03}};

SceneTrial measured_trial(const std::string& name, const std::string& role, const std::vector<SceneMarker>& markers, unsigned seed) {
    SceneTrial trial{name, role, Eigen::VectorXd::LinSpaced(221, -0.2, 2.0), {}};
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 1e-4);
    for (std::size_t m = 0; m < markers.size(); ++m) {
        Eigen::Matrix3Xd track(3, trial.time_s.size());
        for (Eigen::Index i = 0; i < track.cols(); ++i) {
            track.col(i) = beam_point(markers[m].rest_m, SwingingBeam::measured_modulus, trial.time_s[i]);
            for (int k = 0; k < 3; ++k) track(k, i) += noise(random);
            // The second marker is hidden for a while.
            if (m == 1 && i > 80 && i < 100) track.col(i).setConstant(std::numeric_limits<double>::quiet_NaN());
        }
        trial.measured.push_back(track);
    }
    return trial;
}

double rms(const Eigen::Matrix3Xd& a, const Eigen::Matrix3Xd& b) {
    double sum = 0.0;
    int count = 0;
    for (Eigen::Index i = 0; i < a.size(); ++i) {
        const double d = a.data()[i] - b.data()[i];
        if (!std::isfinite(d)) continue;
        sum += d * d;
        ++count;
    }
    return std::sqrt(sum / std::max(1, count));
}

}  // namespace

Eigen::Vector3d beam_point(const Eigen::Vector3d& rest, double E, double t) {
    if (t <= 0.0) return rest;
    const double omega = 2.0 * std::numbers::pi * 3.0 * std::sqrt(E / 2.6e5);
    const double tip = -0.009 * 2.6e5 / E * (1.0 - std::exp(-0.06 * omega * t) * std::cos(omega * t));
    const double s = rest.x() / 0.1;
    const double shape = s * s * (3.0 - s) / 2.0;
    const double slope = tip * (6.0 * s - 3.0 * s * s) / 2.0 / 0.1;
    return rest + Eigen::Vector3d(-slope * (rest.z() - 0.015) - 0.3 * tip * tip * s / 0.1, 0.0, tip * shape);
}

std::vector<Choice> SwingingBeam::materials() const {
    return {{"neo_hookean", "neo-Hookean", "Nearly incompressible: \xcf\x88 = \xce\xbc/2 (J^(\xe2\x88\x92" "2/3) tr F\xe1\xb5\x80" "F \xe2\x88\x92 3) + U(J)", {}},
            {"corotational", "Corotational", "\xcf\x88 = \xce\xbc |F \xe2\x88\x92 R|\xc2\xb2 + \xce\xbb/2 tr(R\xe1\xb5\x80" "F \xe2\x88\x92 I)\xc2\xb2", {}}};
}

std::vector<Choice> SwingingBeam::integrators() const {
    return {{"tr_bdf2", "TR-BDF2", "Second order, hardly any numerical damping.", {}},
            {"implicit_euler", "Implicit Euler", "First order; damps vibrations.",
             [](double omega, const Settings& s) { return 0.5 * omega * s.time_step_s; },       // to first order
             [](double omega, const Settings& s) { return omega * omega * s.time_step_s; }},
            {"generalized_alpha", "Generalised-\xce\xb1", "Second order, damping by choice.", {}, {}, true}};
}

Result<Scene> SwingingBeam::open(const std::filesystem::path& path, std::optional<double> metres_per_unit, const Progress&) {
    Scene scene;
    scene.path = path;
    scene.name = path.filename().string();
    scene.surface = box_surface(body_box);
    scene.settings.material = "neo_hookean";
    scene.settings.integrator = "tr_bdf2";
    if (path.filename() == "missing") return Error{"no such folder", path.string()};
    if (metres_per_unit) {
        scene.surface.vertices *= *metres_per_unit / 1e-3;
        scene.cannot_run = "A mesh alone cannot be simulated: open an experiment folder that says how it is held.";
        return scene;
    }
    scene.name = "Swinging beam, batch 3";
    scene.description = "Silicone beam in the jaw, released from straight.";
    scene.clamp_m = Box{{-5e-4, -1e-3, -1e-3}, {5e-4, 0.031, 0.031}};
    scene.markers = {{"tip_left", {0.1, 0.0, 0.024}}, {"tip_right", {0.1, 0.03, 0.006}}, {"tip_top", {0.1, 0.015, 0.03}}, {"middle", {0.05, 0.0, 0.015}}};
    scene.trials = {measured_trial("gravity_release", "fit", scene.markers, 1), measured_trial("pull_release", "validate", scene.markers, 2)};
    scene.frequency_Hz = 7.75;
    scene.calibrated = {"Young's modulus E", "Damping \xcf\x84"};
    scene.warnings = {"Marker tip_right is occluded in 9 % of the samples."};
    return scene;
}

MeshPrediction SwingingBeam::predict(const Scene&, const Settings& settings) const {
    const Eigen::Vector3i n = box_cells(body_box, settings.resolution_m);
    const double cells = n.prod();
    const double nodes = (n.array() + 1).prod();
    if (settings.element == CellType::hex8) return {cells, 3.0 * nodes, true};
    return {6.0 * cells, 3.0 * (settings.element == CellType::tet4 ? nodes : 7.0 * nodes), false};
}

Result<MeshedBody> SwingingBeam::mesh(const Scene&, const Settings& settings, const Progress&) {
    MeshedBody body;
    const Eigen::Vector3i n = box_cells(body_box, settings.resolution_m);
    body.mesh = settings.element == CellType::hex8 ? box_hex_mesh(body_box, n) : tet_box_mesh(body_box, n, settings.element);
    body.boundary = boundary_faces(body.mesh);
    body.dofs = 3.0 * static_cast<double>(body.mesh.node_count());
    body.report = {{"Volume error", "0.00 %", false}, {"Worst shape", "0.98", false}};
    return body;
}

Result<RunResult> SwingingBeam::simulate(const Scene& scene, const MeshedBody& body, const Settings& settings, const Progress& progress) {
    RunResult result;
    const auto& rest = body.mesh.nodes;
    for (const SceneTrial& measured : scene.trials) {
        SimulatedTrial trial;
        trial.name = measured.name;
        trial.frame_time_s = Eigen::VectorXd::LinSpaced(101, 0.0, 2.0);
        for (Eigen::Index f = 0; f < trial.frame_time_s.size(); ++f) {
            if (progress.cancelled()) return Error{"cancelled", ""};
            std::this_thread::sleep_for(std::chrono::duration<double>(step_delay_s.load()));
            progress.report({"simulate", static_cast<double>(f), 101.0, "steps", "Trial " + measured.name});
            Eigen::Matrix3Xd x(3, rest.cols());
            for (Eigen::Index i = 0; i < rest.cols(); ++i) x.col(i) = beam_point(rest.col(i), settings.youngs_modulus_Pa, trial.frame_time_s[f]);
            trial.frames.push_back(x);
        }
        for (std::size_t m = 0; m < scene.markers.size(); ++m) {
            Eigen::Matrix3Xd track(3, measured.time_s.size());
            for (Eigen::Index i = 0; i < track.cols(); ++i) {
                track.col(i) = beam_point(scene.markers[m].rest_m, settings.youngs_modulus_Pa, measured.time_s[i]);
            }
            trial.marker_rms_m.push_back(rms(track, measured.measured[m]));
            trial.markers.push_back(track);
            trial.rms_m += trial.marker_rms_m.back() / static_cast<double>(scene.markers.size());
        }
        result.rms_m += trial.rms_m / static_cast<double>(scene.trials.size());
        result.trials.push_back(trial);
    }
    result.seconds = 1.3;
    return result;
}

Result<CalibrationResult> SwingingBeam::calibrate(const Scene& scene, const MeshedBody& body, const Settings& settings,
                                                  const Progress& progress) {
    const auto before = simulate(scene, body, settings, progress);
    if (!before) return before.error();
    CalibrationResult result;
    result.settings = settings;
    result.settings.youngs_modulus_Pa = measured_modulus;
    result.settings.damping_s = 3.1e-3;
    auto after = simulate(scene, body, result.settings, progress);
    if (!after) return after.error();
    result.run = std::move(*after);
    result.rms_before_m = before->rms_m;
    result.rms_after_m = result.run.rms_m;
    result.evaluations = 5;
    result.parameters = {{"E", "kPa", settings.youngs_modulus_Pa / 1e3, measured_modulus / 1e3, 0.42},
                         {"Damping \xcf\x84", "ms", settings.damping_s * 1e3, 3.1, 0.05}};
    return result;
}

}  // namespace myo::test
