#include <cmath>

#include "commands/force_arrows.hpp"
#include "commands/workbench.hpp"
#include "plot/ticks.hpp"

// The diagnosis of the workbench: started, shown while it runs, and its effects taken into the model.

namespace myo {

void Workbench::diagnose() {
    if (!may_compute()) return;
    if (!can_be_diagnosed(*state_.scene)) {
        log(LogLevel::warning, "Nothing to diagnose: the experiment has no trial of role fit with measured markers.");
        return;
    }
    if (!state_.mesh_is_current()) {
        build_mesh([this] { diagnose(); });
        return;
    }
    const Settings settings = state_.settings;
    const auto scene = state_.scene;
    const auto body = state_.body;
    state_.diagnosis.reset();
    state_.candidate.clear();
    state_.diagnosis_settings = settings;
    live_ = std::make_shared<LiveDiagnosis>();
    const auto live = live_;
    start(
        diagnose_job,
        [this, settings, scene, body, live](const Progress& progress) -> Job::Completion {
            const auto show = [live](std::shared_ptr<const DiagnosisView> view) {
                const std::lock_guard lock(live->mutex);
                live->latest = std::move(view);
            };
            auto result = std::make_shared<Result<DiagnosisView>>(backend_->diagnose(*scene, *body, settings, progress, show));
            const bool cancelled = progress.cancelled();
            return [this, result, cancelled] {
                if (*result) show_diagnosis(std::move(**result));
                else if (cancelled) log(LogLevel::information, "Diagnosis cancelled before it knew anything.");
                else log_failure(result->error(), "Diagnosis failed");
            };
        },
        true);
}

void Workbench::take_live_diagnosis() {
    if (!live_) return;
    const std::lock_guard lock(live_->mutex);
    if (live_->latest) state_.diagnosis = std::move(live_->latest);
    live_->latest.reset();
}

void Workbench::show_diagnosis(DiagnosisView diagnosis) {
    live_.reset();
    state_.diagnosis = std::make_shared<const DiagnosisView>(std::move(diagnosis));
    const DiagnosisView& d = *state_.diagnosis;
    if (d.stopped) log(LogLevel::information, "Diagnosis cancelled; what it knew by then is shown, without a verdict.");
    else log(LogLevel::done, "Diagnosed in " + value_label(d.seconds, 3) + " s: " + d.headline + ", confidence " + value_label(100.0 * d.confidence, 2) + " %.");
    for (const std::string& note : d.notes) log(LogLevel::information, note);
    look_at_forces();
}

void Workbench::look_at_forces() {
    const PatchForces* const forces = shown_forces(state_);
    if (forces && !state_.playing) state_.time_s = time_with_forces(*forces, state_.time_s);
}

void Workbench::add_effect(const std::string& key) {
    const DiagnosisRow* const row = state_.diagnosis ? state_.diagnosis->row(key) : nullptr;
    if (!row || !row->fitted || row->kind != DiagnosisRow::Kind::effects) {
        log(LogLevel::warning, "Only an effect that was fitted can be added to the model.");
        return;
    }
    Settings settings = state_.settings;
    settings.effects = row->settings.effects;
    settings.youngs_modulus_Pa = row->settings.youngs_modulus_Pa;
    settings.damping_s = row->settings.damping_s;
    if (settings == state_.settings) return;
    change_settings({settings, "effects"});
    log(LogLevel::done, row->name + " is part of the model now, with the modulus and damping that were fitted beside it. Run to see the motion with it.");
}

}  // namespace myo
