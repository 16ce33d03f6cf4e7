#include <utility>

#include "commands/workbench.hpp"

// Playing live: the shown model moves in real time next to everything else; the recorded run stays.

namespace myo::ui::commands {
namespace {

/// The controls with what the settings determine: step, damping and velocity force. Levels and pull are kept.
LiveControls controlled_by(const Settings& settings, LiveControls controls) {
    controls.time_step_s = settings.time_step_s;
    controls.own_step = settings.own_step;
    controls.damping_s = settings.damping_s;
    controls.velocity_force_1_s = settings.velocity_force_1_s;
    return controls;
}

/// Whether settings differ in more than a model that moves can follow.
bool needs_new_model(Settings a, const Settings& b) {
    a.time_step_s = b.time_step_s;
    a.own_step = b.own_step;
    a.damping_s = b.damping_s;
    a.velocity_force_1_s = b.velocity_force_1_s;
    return !(a == b);
}

}  // namespace

LivePlay::Make Workbench::live_model() const {
    return [this, scene = state_.scene, body = state_.body, settings = state_.settings,
            trial = static_cast<std::size_t>(state_.trial)](const LiveModel* before, const Progress& progress) {
        return backend_->live(*scene, *body, settings, trial, before, progress);
    };
}

void Workbench::on(const PlayLive& c) {
    if (!c.on) return stop_live();
    if (live_ || !state_.scene) return;
    if (!state_.mesh_is_current()) {
        log(LogLevel::warning, "Build the mesh first: live playing moves the mesh of these settings.");
        return;
    }
    // The recorded motion and the live one would both move the body.
    state_.playing = false;
    live_settings_ = state_.settings;
    live_ = std::make_unique<LivePlay>(live_model(), controlled_by(state_.settings, {}));
    state_.live = live_->view();
}

void Workbench::on(const SteerLive& c) {
    if (!live_ || !state_.live) return;
    state_.live->controls = controlled_by(state_.settings, c.controls);
    live_->steer(state_.live->controls);
}

void Workbench::on(const RestartLive&) {
    if (!live_) return;
    stop_live();
    on(PlayLive{true});
}

void Workbench::stop_live() {
    live_.reset();
    state_.live.reset();
}

void Workbench::follow_settings_live() {
    if (!live_) return;
    // Another mesh or experiment is another body.
    if (!state_.mesh_is_current()) return stop_live();
    live_->steer(controlled_by(state_.settings, live_->view().controls));
    if (needs_new_model(live_settings_, state_.settings)) live_->replace(live_model());
    live_settings_ = state_.settings;
}

void Workbench::take_live_frame() {
    if (live_) state_.live = live_->view();
}

}  // namespace myo::ui::commands
