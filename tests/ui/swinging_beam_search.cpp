#include <chrono>
#include <cmath>
#include <thread>

#include "ui/swinging_beam.hpp"

namespace myo::test {
namespace {

using Tracks = std::vector<Eigen::Matrix3Xd>;

/// Measured less what the beam of these settings does.
Tracks residual(const ui::commands::Scene& scene, const ui::commands::SceneTrial& trial, double E) {
    Tracks tracks;
    for (std::size_t m = 0; m < scene.markers.size(); ++m) {
        tracks.push_back(trial.measured[m]);
        for (Eigen::Index i = 0; i < trial.time_s.size(); ++i)
            tracks.back().col(i) -= beam_point(scene.markers[m].rest_m, E, trial.time_s[i]);
    }
    return tracks;
}

ui::commands::DiagnosisRow candidate(const ui::commands::DiagnosisView& view, const ui::commands::Settings& settings,
                                     const std::string& key, const std::string& name, double part, double value) {
    ui::commands::DiagnosisRow row;
    row.key = key;
    row.name = name;
    row.explained = 1.0 - (1.0 - part) * (1.0 - part);
    row.fitted = part > 0.3;
    row.brief = row.fitted ? std::to_string(static_cast<int>(value)) + " \xc2\xb1 2 Pa s/m" : "";
    row.one_number = row.fitted;
    row.value = row.fitted ? "coefficient " + row.brief : "not fitted";
    for (const ui::commands::DiagnosisTrial& trial : view.trials) {
        row.predicted_m.emplace_back();
        for (const Eigen::Matrix3Xd& track : trial.residual_m) row.predicted_m.back().push_back(part * track);
        row.after_m.push_back((1.0 - part) * trial.before_m);
    }
    if (!row.fitted) return row;
    row.held_out = 1.0 + 8.0 * (1.0 - part);
    row.weight = 0.06;
    row.settings = settings;
    row.settings.youngs_modulus_Pa = 2.55e5;
    row.settings.effects = {{{key, {{"coefficient_Pa_s_m", value}}, true},
                             name,
                             "coefficient " + std::to_string(static_cast<int>(value)) + " Pa s/m"}};
    return row;
}

/// Upwards, more of it further out, in five patches along the beam.
std::shared_ptr<const ui::commands::PatchForces> upward_force() {
    ui::commands::PatchForces forces;
    forces.time_s = Eigen::VectorXd::LinSpaced(21, 0.0, 2.0);
    for (const double t : forces.time_s) {
        Eigen::Matrix3Xd force = Eigen::Matrix3Xd::Zero(3, 5);
        for (int p = 0; p < 5; ++p) force(2, p) = 2e-3 * (p + 1) * std::exp(-t);
        forces.force_N.push_back(force);
    }
    forces.largest_N = 1e-2;
    return std::make_shared<const ui::commands::PatchForces>(forces);
}

}  // namespace

Result<ui::commands::DiagnosisView> SwingingBeam::diagnose(const ui::commands::Scene& scene,
                                                           const ui::commands::MeshedBody& body,
                                                           const ui::commands::Settings& settings,
                                                           const Progress& progress, const LiveDiagnosis& live) {
    ui::commands::DiagnosisView view;
    view.noise_m = 1e-4;
    for (const ui::commands::SceneTrial& trial : scene.trials) {
        ui::commands::DiagnosisTrial left{trial.name, trial.role == "fit",
                                          residual(scene, trial, settings.youngs_modulus_Pa), 1.2e-3};
        view.trials.push_back(std::move(left));
    }
    view.worst_axis = 2;
    const auto wait = [&](const std::string& phase, int steps) {
        for (int k = 0; k <= steps && !progress.cancelled(); ++k) {
            progress.report({phase, static_cast<double>(k), static_cast<double>(steps), "fits", "linear_drag"});
            std::this_thread::sleep_for(std::chrono::duration<double>(step_delay_s.load()));
        }
    };
    wait("declared fit", 1);
    ui::commands::DiagnosisRow declared;
    declared.kind = ui::commands::DiagnosisRow::Kind::declared;
    declared.key = "declared";
    declared.name = "Declared model";
    declared.fitted = true;
    declared.held_out = 12.1;
    declared.weight = 0.01;
    view.rows.push_back(declared);
    if (live) live(std::make_shared<const ui::commands::DiagnosisView>(view));
    wait("score", 10);
    view.rows.push_back(candidate(view, settings, "quadratic_drag", "Quadratic drag", 0.7, 620));
    view.rows.push_back(candidate(view, settings, "added_mass", "Added mass", 0.2, 0));
    if (live) live(std::make_shared<const ui::commands::DiagnosisView>(view));
    wait("refit", 20);
    while (hold_diagnosis && !progress.cancelled()) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (progress.cancelled()) {
        view.stopped = true;
        return view;
    }
    view.complete = true;
    view.seconds = 41.0;
    view.patches = 5;
    view.patch_of_node.resize(body.mesh.nodes.cols());
    for (Eigen::Index i = 0; i < body.mesh.nodes.cols(); ++i)
        view.patch_of_node(i) = std::min(4, static_cast<int>(50.0 * body.mesh.nodes(0, i)));
    view.because =
        "With linear drag the residual is 1.1 times the noise instead of 12.0; no test finds more than noise in it.";
    view.confounded = {
        "Confounded here: linear drag and extra damping (cosine 0.982); a release in another direction would "
        "separate them."};
    if (unexplained) {
        view.headline = "An effect is missing that none of the known effects explains";
        view.because = "The residual is significant, and no effect of the catalogue takes it away.";
        view.confidence = 0.8;
        ui::commands::DiagnosisRow force;
        force.kind = ui::commands::DiagnosisRow::Kind::missing_force;
        force.key = "missing force";
        force.name = "Missing force";
        force.value = "up to 10 mN at the free end, along +z";
        force.chosen = force.fitted = true;
        force.explained = 0.93;
        force.force = {upward_force(), nullptr};
        view.missing_force = {scene.trials.front().name,
                              force.force[0]->time_s,
                              {"1: at the free end, along +z"},
                              {0.01 * (-force.force[0]->time_s.array()).exp()}};
        view.rows.insert(view.rows.begin() + 1, force);
        return view;
    }
    view.verdict = ui::commands::DiagnosisVerdict::effects;
    view.headline = "Linear drag is missing: coefficient 41 \xc2\xb1 2 Pa s/m";
    view.confidence = 0.93;
    ui::commands::DiagnosisRow found = candidate(view, settings, "linear_drag", "Linear drag", 0.95, 41);
    found.chosen = true;
    found.weight = 0.93;
    found.like = "extra damping";
    found.force = {upward_force(), upward_force()};
    view.rows.insert(view.rows.begin() + 1, found);
    return view;
}

}  // namespace myo::test
