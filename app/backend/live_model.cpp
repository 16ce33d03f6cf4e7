#include "backend/live_model.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <utility>

#include "backend/body_actuators.hpp"
#include "backend/core_scene.hpp"
#include "backend/fields.hpp"
#include "backend/mesh_scene.hpp"
#include "dynamics/live_run.hpp"
#include "experiment/actuators.hpp"
#include "measurement/marker_binding.hpp"
#include "prediction/run_trials.hpp"
#include "setup/actuator_signals.hpp"

namespace myo::backend {
namespace {

using ui::commands::LiveActuator;
using ui::commands::LiveControls;
using ui::commands::LiveFrame;

/// Numbers of playing live; the accuracy is that of a picture.
struct LiveModelPolicy {
    double tolerance = 1e-4;  // of the stages: places within 0.1 % of the deflection (test LiveRun), below what is seen
    double least_activation = 0.5, greatest_activation = 1.5;  // of the sliders
    /// The spring of the mouse, over modulus times the cube root of the volume. A slender beam of silicone then bends
    /// by half of what the mouse moves; at ten times as much the cells under the mouse are crushed.
    double spring_share = 0.005;
};
constexpr LiveModelPolicy live_model_policy;

/// What is needed to play a trial.
struct LiveTrial {
    model::Model model;
    dynamics::SimulationOptions options;
    measurement::MarkerSet markers;
    measurement::ObservationError observed;
};

/// Model, options and observed markers of a trial with the settings. Errors: see make_live_model().
Result<LiveTrial> live_trial(const ui::commands::Scene& scene, const ui::commands::MeshedBody& body,
                             const ui::commands::Settings& settings, std::size_t trial, const Progress& progress) {
    if (source_of(scene).experiment.trials.empty()) {
        Result<effect::Affected> release = mesh_scene_release(scene, body, settings);
        if (!release) return release.error();
        // A plain mesh has neither markers nor a camera.
        return LiveTrial{std::move(release->model), release->options, {}, {}};
    }
    const Result<setup::Setup> setup = scene_setup(scene, body, settings, setup_settings(settings), progress);
    if (!setup) return setup.error();
    // Free levels have their declared values until a slider moves them.
    const prediction::ParameterValues values = prediction::with_predicted_levels(*setup,
                                                                                 prediction::declared_values(*setup));
    effect::Affected affected = prediction::affected_trial(*setup, trial, values);
    return LiveTrial{std::move(affected.model), affected.options,
                     measurement::seen_markers(setup->markers, affected.observation_error),
                     std::move(affected.observation_error)};
}

/// See ui::commands::LiveModel. Actuators are the muscles that follow none, then chambers and tendons.
///
/// Two frames occur: the model computes in that of its mount, the window shows the laboratory. The two agree unless an
/// effect moves the mount.
class CoreLiveModel final : public ui::commands::LiveModel {
public:
    CoreLiveModel(std::unique_ptr<dynamics::LiveRun> run, LiveTrial trial, experiment::Experiment experiment,
                  std::size_t shown, std::size_t trials)
        : run_(std::move(run)),
          trial_(std::move(trial)),
          experiment_(std::move(experiment)),
          shown_(shown),
          trials_(trials),
          begun_(dynamics::controls_of(run_->model(), 0.0)) {}

    const dynamics::LiveRun& run() const { return *run_; }

    std::vector<LiveActuator> actuators() const override {
        std::vector<LiveActuator> result;
        std::size_t command = 0, muscle = 0;
        for (const experiment::Actuator& actuator : experiment::actuators(experiment_)) {
            if (actuator.kind == experiment::ActuatorKind::muscle) {
                const std::size_t own = muscle++;
                if (!experiment_.muscles[own].follows && own < begun_.activation.size())
                    result.push_back(slider_of_muscle(actuator.name, begun_.activation[own]));
            } else if (command < begun_.commands.size()) {
                result.push_back(slider_of_command(actuator, begun_.commands[command]));
                ++command;
            }
        }
        return result;
    }

    double spring_N_m() const override {
        const model::Model& model = run_->model();
        // Young's modulus of the stiffest cell, E = 3 mu for an incompressible material.
        double modulus = 0.0;
        for (const material::Moduli& moduli : model.moduli) modulus = std::max(modulus, 3.0 * moduli.mu);
        return live_model_policy.spring_share * modulus * std::cbrt(model.body->volume_m3);
    }

    // Markers are those of the moved body in the laboratory, without errors of clock, scale or lens.
    Result<LiveFrame> step(const LiveControls& controls, const Progress& progress) override {
        const Result<void> stepped = run_->advance(core_controls(controls), progress);
        if (!stepped) return stepped.error();
        LiveFrame frame;
        frame.time_s = run_->time_s();
        frame.step_s = controls.time_step_s;
        Eigen::Matrix3Xd x = run_->state().x;
        if (trial_.observed.mount) x = mount_pose().in_laboratory(x);
        for (const measurement::MarkerBinding& marker : trial_.markers.bindings)
            frame.markers_m.push_back(measurement::marker_position(marker, x(Eigen::all, marker.nodes)));
        // Mean place of the held patch less its offsets at the grip: the end of the spring on the body.
        if (controls.grip) {
            frame.force_N = run_->grip_force().norm();
            frame.pulled_m = (x(Eigen::all, controls.grip->nodes) - controls.grip->offsets_m) * controls.grip->shares;
        }
        frame.run = shown_run(std::move(x));
        return frame;
    }

private:
    model::MountPose mount_pose() const { return trial_.observed.mount->at(run_->time_s()); }
    /// Places of the laboratory in the frame of the model, which moves with the mount.
    Eigen::Matrix3Xd held_places(const Eigen::Matrix3Xd& places_m) const {
        if (!trial_.observed.mount) return places_m;
        const model::MountPose pose = mount_pose();
        return (pose.rotation.transpose() * (places_m.colwise() - pose.place_m)).colwise() + pose.pivot_m;
    }

    /// Slider of an activation [-]; its range is widened to hold the level at which the model begins.
    static LiveActuator slider_of_muscle(const std::string& name, double level) {
        LiveActuator slider{
            name, "Activation", "", 1.0, live_model_policy.least_activation, live_model_policy.greatest_activation,
            level};
        slider.lowest = std::min(slider.lowest, level);
        slider.highest = std::max(slider.highest, level);
        return slider;
    }

    /// Slider of a pressure, tension or shortening, between the declared limits and the level at which the model
    /// begins.
    LiveActuator slider_of_command(const experiment::Actuator& actuator, double level) const {
        const ui::commands::ShownCommand shown = shown_unit(actuator);
        const std::vector<std::string> names = setup::actuator_names(experiment_);
        const auto number = static_cast<std::size_t>(std::find(names.begin(), names.end(), actuator.name) -
                                                     names.begin());
        const setup::LevelBounds bounds = setup::level_bounds(experiment_, number);
        std::string quantity = experiment::quantity_word(actuator.kind);
        quantity[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(quantity[0])));
        return {actuator.name,
                quantity,
                shown.unit,
                shown.per_unit,
                std::min(bounds.lower, level),
                std::max(bounds.upper, level),
                level};
    }

    /// Controls of the core from those of the window; without levels the actuators stay as the model begins.
    dynamics::LiveControls core_controls(const LiveControls& controls) const {
        dynamics::LiveControls core = begun_;
        core.h_s = controls.time_step_s;
        core.damping_s = controls.damping_s;
        core.velocity_force_1_s = controls.velocity_force_1_s;
        // `controls.levels` has no entries of followers; the second loop computes them from their leaders, as
        // with_level() does: followers scale a - 1 by their ratio.
        std::size_t level = 0;
        for (std::size_t m = 0; m < core.activation.size() && level < controls.levels.size(); ++m)
            if (!experiment_.muscles[m].follows) core.activation[m] = controls.levels[level++];
        for (std::size_t m = 0; m < core.activation.size(); ++m)
            if (const auto& follows = experiment_.muscles[m].follows)
                for (std::size_t leader = 0; leader < experiment_.muscles.size(); ++leader)
                    if (experiment_.muscles[leader].name == follows->muscle)
                        core.activation[m] = 1.0 + follows->ratio * (core.activation[leader] - 1.0);
        for (std::size_t c = 0; c < core.commands.size() && level < controls.levels.size(); ++c)
            core.commands[c] = controls.levels[level++];
        if (controls.grip)
            core.grip = dynamics::Grip{controls.grip->nodes, controls.grip->shares,
                                       held_places(controls.grip->offsets_m.colwise() + controls.grip->place_m),
                                       controls.spring_N_m};
        return core;
    }

    /// A run that holds one frame of the shown trial.
    std::shared_ptr<const ui::commands::RunResult> shown_run(Eigen::Matrix3Xd x) const {
        auto result = std::make_shared<ui::commands::RunResult>();
        result->trials.resize(trials_);
        result->trials[shown_].frame_time_s = Eigen::VectorXd::Constant(1, run_->time_s());
        result->trials[shown_].frames.push_back(std::move(x));
        auto models = std::make_shared<RunModels>();
        models->trials.resize(trials_);  // the others have no frames
        models->trials[shown_] = run_->model();
        result->source = std::move(models);
        return result;
    }

    std::unique_ptr<dynamics::LiveRun> run_;
    LiveTrial trial_;
    experiment::Experiment experiment_;
    std::size_t shown_, trials_;
    dynamics::LiveControls begun_;  // as the model begins
};

}  // namespace

Result<std::unique_ptr<ui::commands::LiveModel>> make_live_model(
    const ui::commands::Scene& scene, const ui::commands::MeshedBody& body, const ui::commands::Settings& settings,
    std::size_t trial, const ui::commands::LiveModel* before, const Progress& progress) {
    Result<LiveTrial> live = live_trial(scene, body, settings, trial, progress);
    if (!live) return live.error();
    live->options.solver.tolerance = live_model_policy.tolerance;
    const auto* const played = dynamic_cast<const CoreLiveModel*>(before);
    if (played && played->run().state().x.cols() == live->model.body->node_count())
        live->options.initial = {played->run().state().x, played->run().state().v};
    dynamics::LiveControls controls = dynamics::controls_of(live->model, 0.0);
    controls.h_s = settings.time_step_s;
    Result<std::unique_ptr<dynamics::LiveRun>> run = dynamics::LiveRun::begin(live->model, live->options, controls,
                                                                              progress);
    if (!run) return run.error();
    return std::unique_ptr<ui::commands::LiveModel>(std::make_unique<CoreLiveModel>(
        std::move(*run), std::move(*live), with_settings(source_of(scene).experiment, settings), trial,
        scene.trials.size()));
}

}  // namespace myo::backend
