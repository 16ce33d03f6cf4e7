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

ui::commands::SceneTrial measured_trial(const std::string& name, const std::string& role,
                                        const std::vector<ui::commands::SceneMarker>& markers, unsigned seed) {
    ui::commands::SceneTrial trial{name, role, Eigen::VectorXd::LinSpaced(221, -0.2, 2.0), {}};
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

/// Three checks, the worst first, of which the one of the start is in a stated state.
ui::commands::CheckRows beam_checks(ui::commands::CheckState start) {
    const std::string trial = "gravity_release";
    const ui::commands::CheckRow mesh{"mesh",
                                      "Is the mesh fine enough to bend and to twist?",
                                      ui::commands::CheckState::green,
                                      "",
                                      "4",
                                      "2",
                                      "bench locking",
                                      "4 cells across the beam",
                                      "",
                                      "mesh",
                                      false};
    const ui::commands::CheckRow step{"step",
                                      "Is the time step short enough?",
                                      ui::commands::CheckState::green,
                                      trial,
                                      "0.02 %",
                                      "0.15 %",
                                      "twice the error of the frequency",
                                      "steps of 10 ms make the vibration of 7.75 Hz 0.02 % too slow",
                                      "",
                                      "run",
                                      false};
    ui::commands::CheckRow begin{"start",
                                 "Does the model begin where the recording begins?",
                                 start,
                                 trial,
                                 "5.24 mm",
                                 "0.866 mm",
                                 "5 noise levels",
                                 "at the first sample the markers are 5.24 mm rms from where the model begins",
                                 "",
                                 "measure",
                                 false};
    if (start == ui::commands::CheckState::green) return {mesh, step, begin};
    begin.way_out = "state start = \"equilibrium\"";
    return {begin, mesh, step};
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

std::vector<ui::commands::Choice> SwingingBeam::materials() const {
    return {{"neo_hookean",
             "neo-Hookean",
             "Nearly incompressible: \xcf\x88 = \xce\xbc/2 (J^(\xe2\x88\x92"
             "2/3) tr F\xe1\xb5\x80"
             "F \xe2\x88\x92 3) + U(J)",
             {}},
            {"corotational",
             "Corotational",
             "\xcf\x88 = \xce\xbc |F \xe2\x88\x92 R|\xc2\xb2 + \xce\xbb/2 tr(R\xe1\xb5\x80"
             "F \xe2\x88\x92 I)\xc2\xb2",
             {}},
            {.id = "gent",
             .label = "Gent",
             .explanation = "Stiffens at a finite stretch",
             .numbers = {{"gent_limit", "Limit J", "", "Where the stress is infinite", 30.0, {0.1, 1e4}}}}};
}

std::vector<ui::commands::Choice> SwingingBeam::integrators() const {
    // Of second order: (omega h)^2 / 24.
    const auto quality = [](double omega, const ui::commands::Settings& s) {
        const double error = std::pow(omega * s.time_step_s, 2) / 24.0;
        if (error > 1e-2) return ui::commands::StepQuality{error, ui::commands::CheckState::red};
        return ui::commands::StepQuality{
            error, error > 1.5e-3 ? ui::commands::CheckState::amber : ui::commands::CheckState::green};
    };
    return {
        {"tr_bdf2", "TR-BDF2", "Second order, hardly any numerical damping.", {}, {}, false, quality},
        {"implicit_euler", "Implicit Euler", "First order; damps vibrations.",
         [](double omega, const ui::commands::Settings& s) { return 0.5 * omega * s.time_step_s; },  // to first order
         [](double omega, const ui::commands::Settings& s) { return omega * omega * s.time_step_s; }},
        {"generalized_alpha", "Generalised-\xce\xb1", "Second order, damping by choice.", {}, {}, true}};
}

Result<fibre::Signal> SwingingBeam::read_signal(const std::filesystem::path& path, const std::string&) const {
    const auto known = signals.find(path);
    if (known == signals.end()) return Error{"no such file", path.string()};
    return known->second;
}

Result<void> SwingingBeam::write_signal(const std::filesystem::path& path, const std::string&,
                                        const fibre::Signal& signal) const {
    signals[path] = signal;
    return {};
}

Result<ui::commands::Declaration> SwingingBeam::edited(const ui::commands::Scene&,
                                                       const ui::commands::Declaration& declaration,
                                                       const std::vector<ui::commands::DeclarationEdit>& asked) const {
    ui::commands::Declaration result = declaration;
    edits.insert(edits.end(), asked.begin(), asked.end());
    for (const ui::commands::DeclarationEdit& edit : asked)
        if (const auto* set = std::get_if<ui::commands::SetDeclared>(&edit)) {
            if (set->value == "refused") return Error{"this is refused", ""};
            result.text = std::make_shared<const std::string>(set->value);
        }
    return result;
}

Result<ui::commands::Scene> SwingingBeam::redeclared(const ui::commands::Scene& scene,
                                                     const ui::commands::Declaration& declaration,
                                                     const ui::commands::MeshedBody*) const {
    if (refuses_declarations) return Error{"this is refused", ""};
    ui::commands::Scene result = scene;
    if (declaration.text) result.description = *declaration.text;
    return result;
}

Result<ui::commands::Scene> SwingingBeam::open(const std::filesystem::path& path, std::optional<double> metres_per_unit,
                                               const Progress&) {
    ui::commands::Scene scene;
    scene.path = path;
    scene.name = path.filename().string();
    scene.surface = mesh::box_surface(body_box);
    scene.settings.material = "neo_hookean";
    scene.settings.integrator = "tr_bdf2";
    scene.effects.offered = {
        {"linear_drag", {{"coefficient_Pa_s_m", 22.0}}},
        {"point_mass", {{"mass_kg", 0.005}, {"position_m", Eigen::VectorXd(Eigen::Vector3d(0.1, 0.015, 0.03))}}},
        {"gravity_tilt", {{"tilt_deg", 3.0}, {"axis", Eigen::VectorXd(Eigen::Vector3d::UnitY())}}},
        {"actuation_lag", {{"time_constant_s", 0.04}, {"signal", std::string("signal")}}}};
    scene.effects.lacking = {"", "", "", "a muscle, chamber or tendon"};
    if (path.filename() == "missing") return Error{"no such folder", path.string()};
    if (metres_per_unit) {
        scene.surface.vertices *= *metres_per_unit / 1e-3;
        return scene;
    }
    scene.name = "Swinging beam, batch 3";
    scene.description = "Silicone beam in the jaw, released from straight.";
    scene.clamp_m = Box{{-5e-4, -1e-3, -1e-3}, {5e-4, 0.031, 0.031}};
    scene.markers = {{"tip_left", {0.1, 0.0, 0.024}},
                     {"tip_right", {0.1, 0.03, 0.006}},
                     {"tip_top", {0.1, 0.015, 0.03}},
                     {"middle", {0.05, 0.0, 0.015}}};
    scene.trials = {measured_trial("gravity_release", "fit", scene.markers, 1),
                    measured_trial("pull_release", "validate", scene.markers, 2)};
    for (const ui::commands::ImportChoices& choices : added)
        scene.trials.push_back(measured_trial(choices.trial, choices.fit ? "fit" : "validate", scene.markers, 3));
    scene.is_experiment = as_experiment;
    for (ui::commands::SceneTrial& trial : scene.trials) trial.repairs = {as_experiment, 1.5, {}};
    scene.frequency_Hz = 7.75;
    scene.damping_ratio = 0.06;
    scene.calibrated = {"Young's modulus E", "Damping \xcf\x84"};
    scene.warnings = {"Marker tip_right is occluded in 9 % of the samples."};
    scene.checks = beam_checks(start_opened);
    return scene;
}

Result<ui::commands::RecordingFile> SwingingBeam::read_recording(const std::filesystem::path& path,
                                                                 const ui::commands::ReadingOptions& options) const {
    if (path.filename() == "missing") return Error{"no such file", path.string()};
    const Result<ui::commands::Scene> scene = const_cast<SwingingBeam*>(this)->open("beam", std::nullopt, {});
    auto recording = std::make_shared<measurement::Recording>();
    recording->time_s = Eigen::VectorXd::LinSpaced(151, 0.0, 1.5);
    recording->rate_Hz = 100.0;
    for (std::size_t m = 0; m < scene->markers.size(); ++m) {
        recording->labels.push_back("label " + std::to_string(m));
        Eigen::Matrix3Xd track(3, 151);
        for (int i = 0; i < 151; ++i)
            track.col(i) = beam_point(scene->markers[m].rest_m, measured_modulus, recording->time_s[i] - 0.3) +
                           Eigen::Vector3d(0.5, 0.0, 0.0);
        if (m == 1) track.middleCols(40, 30).setConstant(std::numeric_limits<double>::quiet_NaN());
        recording->tracks.push_back(track);
    }
    ui::commands::RecordingFile file{path,
                                     "C3D",
                                     path.extension() == ".txt",
                                     path.extension() == ".txt",
                                     options,
                                     recording,
                                     {1.0, 0.8, 1.0, 1.0},
                                     0.3,
                                     "It moves from 0.3 s on."};
    return file;
}

ui::commands::ImportView SwingingBeam::view_import(const ui::commands::Scene& scene,
                                                   const ui::commands::RecordingFile& file,
                                                   const ui::commands::ImportChoices& choices) const {
    const auto count = static_cast<Eigen::Index>(file.recording->labels.size());
    ui::commands::ImportView view;
    view.translation_m = Eigen::Vector3d(-0.5, 0.0, 0.0);
    view.before_m = view.target_m = Eigen::Matrix3Xd::Constant(3, count, std::numeric_limits<double>::quiet_NaN());
    int named = 0;
    for (Eigen::Index i = 0; i < count; ++i) {
        const ui::commands::ImportedMarker& marker = choices.markers[static_cast<std::size_t>(i)];
        view.before_m.col(i) = file.recording->tracks[static_cast<std::size_t>(i)].col(0) + view.translation_m;
        if (marker.rest_m) view.target_m.col(i) = *marker.rest_m;
        for (const ui::commands::SceneMarker& own : scene.markers)
            if (!marker.rest_m && own.name == marker.name) view.target_m.col(i) = own.rest_m;
        named += marker.name.empty() ? 0 : 1;
    }
    view.residual_m = (view.before_m - view.target_m).colwise().norm();
    view.placed_by = "Shifted.";
    if (named == 0) view.problem = "No label is assigned to a marker yet.";
    return view;
}

Result<ui::commands::ImportChoices> SwingingBeam::propose_markers(const ui::commands::Scene& scene,
                                                                  const ui::commands::MeshedBody&,
                                                                  const ui::commands::RecordingFile&,
                                                                  const ui::commands::ImportChoices& choices) const {
    ui::commands::ImportChoices proposed = choices;
    for (std::size_t m = 0; m < scene.markers.size(); ++m) proposed.markers[m].name = scene.markers[m].name;
    return proposed;
}

Result<std::filesystem::path> SwingingBeam::add_recording(const ui::commands::Scene& scene,
                                                          const ui::commands::Settings&,
                                                          const ui::commands::RecordingFile&,
                                                          const ui::commands::ImportChoices& choices) const {
    if (choices.trial == "taken") return Error{"the experiment has a trial of this name already", "\"taken\""};
    added.push_back(choices);
    return scene.path;
}

ui::commands::MeshPrediction SwingingBeam::predict(const ui::commands::Scene&,
                                                   const ui::commands::Settings& settings) const {
    const Eigen::Vector3i n = mesh::box_cells(body_box, settings.resolution_m);
    const double cells = n.prod();
    const double nodes = (n.array() + 1).prod();
    if (settings.element == mesh::CellType::hex8) return {cells, 3.0 * nodes, true};
    const double part = fewer_foretold ? 0.5 : 1.0;
    return {part * 6.0 * cells, part * 3.0 * (settings.element == mesh::CellType::tet4 ? nodes : 7.0 * nodes), false};
}

Result<ui::commands::MeshedBody> SwingingBeam::mesh(const ui::commands::Scene&, const ui::commands::Settings& settings,
                                                    const Progress&) {
    ui::commands::MeshedBody body;
    const Eigen::Vector3i n = mesh::box_cells(body_box, settings.resolution_m);
    body.mesh = settings.element == mesh::CellType::hex8 ? mesh::box_hex_mesh(body_box, n)
                                                         : mesh::tet_box_mesh(body_box, n, settings.element);
    body.boundary = mesh::boundary_faces(body.mesh);
    body.dofs = 3.0 * static_cast<double>(body.mesh.node_count());
    if (has_chamber) {
        ui::commands::ShownChamber chamber;
        for (Eigen::Index f = 0; f < body.boundary.count(); ++f)
            if (body.mesh.nodes(0, body.boundary.nodes.col(f)).minCoeff() > body_box.highest.x() - 1e-9)
                chamber.walls.push_back(static_cast<int>(f));
        body.actuators.chambers = {chamber};
    }
    body.report = {{"Volume error", "0.00 %", false}, {"Worst shape", "0.98", false}};
    return body;
}

const std::vector<ui::commands::FieldKind>& SwingingBeam::fields() const {
    static const std::vector<ui::commands::FieldKind> kinds{
        {"height", "Height", "mm", 1e-3, true, "Above the rest position."},
        {"place", "Place", "m", 1.0, false, "x at rest."}};
    return kinds;
}

Eigen::VectorXd SwingingBeam::field(const std::string& id, const ui::commands::MeshedBody& body,
                                    const ui::commands::RunResult& run, std::size_t trial, std::size_t frame) const {
    std::this_thread::sleep_for(std::chrono::duration<double>(field_delay_s.load()));
    if (id == "place") return body.mesh.nodes.row(0).transpose();
    return (run.trials[trial].frames[frame] - body.mesh.nodes).row(2).transpose();
}

Result<ui::commands::RunResult> SwingingBeam::simulate(const ui::commands::Scene& scene,
                                                       const ui::commands::MeshedBody& body,
                                                       const ui::commands::Settings& settings,
                                                       const std::optional<ui::commands::RunExtent>& only,
                                                       const Progress& progress) {
    ui::commands::RunResult result;
    const auto& rest = body.mesh.nodes;
    for (const ui::commands::SceneTrial& measured : scene.trials) {
        ui::commands::SimulatedTrial trial;
        trial.name = measured.name;
        if (only && &measured != &scene.trials[only->trial]) {
            trial.rms_m = std::numeric_limits<double>::quiet_NaN();
            result.trials.push_back(trial);
            continue;
        }
        trial.frame_time_s = Eigen::VectorXd::LinSpaced(101, 0.0, 2.0);
        if (only) trial.frame_time_s.conservativeResize((trial.frame_time_s.array() <= only->end_s + 1e-9).count());
        for (Eigen::Index f = 0; f < trial.frame_time_s.size(); ++f) {
            if (progress.cancelled()) return Error{"cancelled", ""};
            std::this_thread::sleep_for(std::chrono::duration<double>(step_delay_s.load()));
            progress.report({"simulate", static_cast<double>(f), 101.0, "steps", "Trial " + measured.name});
            Eigen::Matrix3Xd x(3, rest.cols());
            for (Eigen::Index i = 0; i < rest.cols(); ++i)
                x.col(i) = beam_point(rest.col(i), settings.youngs_modulus_Pa, trial.frame_time_s[f]);
            trial.frames.push_back(x);
        }
        for (std::size_t m = 0; m < scene.markers.size(); ++m) {
            Eigen::Matrix3Xd track(3, measured.time_s.size());
            for (Eigen::Index i = 0; i < track.cols(); ++i) {
                track.col(i) = beam_point(scene.markers[m].rest_m, settings.youngs_modulus_Pa, measured.time_s[i]);
                if (only && measured.time_s[i] > only->end_s + 1e-9)
                    track.col(i).setConstant(std::numeric_limits<double>::quiet_NaN());
            }
            trial.marker_rms_m.push_back(rms(track, measured.measured[m]));
            trial.markers.push_back(track);
            trial.rms_m += trial.marker_rms_m.back() / static_cast<double>(scene.markers.size());
        }
        result.rms_m += trial.rms_m / (only ? 1.0 : static_cast<double>(scene.trials.size()));
        result.trials.push_back(trial);
    }
    if (!only) result.checks = beam_checks(start_after);
    if (!settings.own_step) result.time_step_s = chosen_step_s;
    result.seconds = 1.3;
    result.steps = 100.0 * static_cast<double>(scene.trials.size());
    return result;
}

Result<ui::commands::SearchResult> SwingingBeam::calibrate(const ui::commands::Scene& scene,
                                                           const ui::commands::MeshedBody& body,
                                                           const ui::commands::Settings& settings,
                                                           const Progress& progress, const LiveSearch& live) {
    const auto before = simulate(scene, body, settings, std::nullopt, progress);
    if (!before) return before.error();
    if (live) {
        ui::commands::SearchView view;
        view.log = {{4.0, before->rms_m, 2.0}};
        view.parameters = {{"E", "kPa", settings.youngs_modulus_Pa / 1e3, settings.youngs_modulus_Pa / 1e3,
                            std::numeric_limits<double>::quiet_NaN()}};
        view.settings = settings;
        view.best = std::make_shared<const ui::commands::RunResult>(*before);
        live(std::make_shared<const ui::commands::SearchView>(view));
    }
    while (hold_search && !progress.cancelled()) {
        progress.report({"calibrate", 1.0, 60.0, "evaluations", "held"});
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    ui::commands::SearchResult result;
    result.title = "Calibrated";
    result.settings = settings;
    result.settings.youngs_modulus_Pa = measured_modulus;
    result.settings.damping_s = 3.1e-3;
    auto after = simulate(scene, body, result.settings, std::nullopt, progress);
    if (!after) return after.error();
    result.run = std::move(*after);
    result.rms_before_m = before->rms_m;
    result.rms_after_m = result.run.rms_m;
    result.evaluations = 5;
    result.parameters = {{"E", "kPa", settings.youngs_modulus_Pa / 1e3, measured_modulus / 1e3, 0.42},
                         {"Damping \xcf\x84", "ms", settings.damping_s * 1e3, 3.1, 0.05}};
    return result;
}

Result<ui::commands::SearchResult> SwingingBeam::optimize(const ui::commands::Scene& scene,
                                                          const ui::commands::MeshedBody& body,
                                                          const ui::commands::Settings& settings,
                                                          const ui::commands::OptimizeRequest& request,
                                                          const Progress& progress, const LiveSearch& live) {
    ui::commands::SearchView view;
    view.loss_unit = "mm\xc2\xb2";
    ui::commands::SearchResult result;
    result.title = "Optimised";
    for (int k = 0; k < 5 && !progress.cancelled(); ++k) {
        auto run = simulate(scene, body, settings, std::nullopt, progress);
        if (!run) break;
        result.settings = settings;
        result.settings.muscles.front().signal = fibre::Signal{{0.0, 1.0}, {1.0, 1.0 - 0.05 * k}};
        result.run = *run;
        view.log.push_back({10.0 / (k + 1), 1e-3 / (k + 1), 1.0 / (k + 1)});
        view.parameters = {{settings.muscles.front().name + ", minimum a", "", 1.0, 1.0 - 0.05 * k,
                            std::numeric_limits<double>::quiet_NaN()}};
        view.settings = result.settings;
        view.best = std::make_shared<const ui::commands::RunResult>(*run);
        if (live) live(std::make_shared<const ui::commands::SearchView>(view));
        progress.report(
            {"optimize", k + 1.0, static_cast<double>(request.max_evaluations), "evaluations", request.trial});
    }
    if (view.log.empty()) return Error{"stopped before the first evaluation", ""};
    result.evaluations = static_cast<int>(view.log.size());
    result.parameters = view.parameters;
    result.rms_before_m = 1e-3;
    result.rms_after_m = view.log.back().rms_m;
    result.stopped = progress.cancelled();
    return result;
}

Result<ui::commands::Project> SwingingBeam::read_project(const std::filesystem::path& file) const {
    const auto found = projects.find(file);
    if (found == projects.end()) return Error{"file not found", file.string()};
    return found->second;
}

Result<void> SwingingBeam::write_project(const std::filesystem::path& file,
                                         const ui::commands::Project& project) const {
    std::this_thread::sleep_for(std::chrono::duration<double>(write_delay_s.load()));
    if (file.parent_path() == "/forbidden") return Error{"cannot be written", file.string()};
    projects[file] = project;
    return {};
}

Result<std::vector<std::string>> SwingingBeam::write_report(const std::filesystem::path& folder,
                                                            const ui::commands::Scene&, const ui::commands::RunResult&,
                                                            const ui::commands::SearchResult*,
                                                            const ui::commands::DiagnosisView*) const {
    reports.push_back(folder);
    return std::vector<std::string>{"trial.csv"};
}

}  // namespace myo::test
