#include <cmath>

#include "commands/force_arrows.hpp"
#include "commands/workbench.hpp"
#include "plot/number_text.hpp"

// Diagnosis: started, shown while it runs, and its effects added to the model.

namespace myo::ui::commands {

void Workbench::end_diagnosis(Result<DiagnosisView> result, bool cancelled) {
    live_diagnosis_.reset();
    if (result) return show_diagnosis(std::move(*result));
    if (cancelled)
        log(LogLevel::information, "Diagnosis cancelled without results.");
    else
        log_failure(result.error(), "Diagnosis failed");
    end_task(cancelled ? JobOutcome::stopped : JobOutcome::failed, cancelled ? "cancelled" : result.error().text());
}

void Workbench::on(const Diagnose&) {
    if (!may_compute()) return;
    if (!can_be_diagnosed(*state_.scene)) {
        log(LogLevel::warning, "Nothing to diagnose: the experiment has no trial of role fit with measured markers.");
        return;
    }
    request(diagnose_job, [this] {
        with_body([this] {
            // Shown from the start, so that the panel follows the intermediate results of this diagnosis only.
            state_.diagnosis.reset();
            state_.candidate.clear();
            state_.diagnosis_settings = request_->settings;
            live_diagnosis_ = std::make_shared<LiveValue<DiagnosisView>>();
            start(diagnose_job,
                  // The thread owns copies and shared pointers only, so that edits during the diagnosis do not affect
                  // it.
                  [this, settings = request_->settings, scene = request_->scene, body = request_->on.body,
                   live = live_diagnosis_](const Progress& progress) -> Job::Completion {
                      const auto show = [live](std::shared_ptr<const DiagnosisView> view) {
                          live->set(std::move(view));
                      };
                      auto result = std::make_shared<Result<DiagnosisView>>(
                          backend_->diagnose(*scene, *body, settings, progress, show));
                      const bool cancelled = progress.cancelled();
                      return [this, result, cancelled] { end_diagnosis(std::move(*result), cancelled); };
                  },
                  {true, false});
        });
    });
}

void Workbench::show_diagnosis(DiagnosisView diagnosis) {
    state_.diagnosis = std::make_shared<const DiagnosisView>(std::move(diagnosis));
    const DiagnosisView& d = *state_.diagnosis;
    if (d.stopped)
        log(LogLevel::information, "Diagnosis cancelled; interim results are shown, without a verdict.");
    else
        log_done("Diagnosed in " + plot::value_label(d.seconds, 3) + " s: " + d.headline + ", confidence " +
                     plot::value_label(100.0 * d.confidence, 2) + " %.",
                 d.checks);
    for (const std::string& note : d.notes) log(LogLevel::information, note);
    show_checks(d.checks, request_->settings);
    JobRecord record;
    record.seconds = d.seconds;
    record.settings = request_->settings;
    record.diagnosis = state_.diagnosis;
    if (!d.checks.empty()) record.checks = state_.checks;
    end_task(d.stopped ? JobOutcome::stopped : JobOutcome::done, d.stopped ? "stopped without a verdict" : d.headline,
             std::move(record));
    look_at_forces();
}

// At a time without forces the arrows of a row would be missing, without a visible reason.
void Workbench::look_at_forces() {
    const PatchForces* const forces = shown_forces(state_);
    if (forces && !state_.playing) state_.time_s = time_with_forces(*forces, state_.time_s);
}

void Workbench::on(const AddEffect& command) {
    const DiagnosisRow* const row = state_.diagnosis ? state_.diagnosis->row(command.key) : nullptr;
    if (!row || !row->fitted || row->kind != DiagnosisRow::Kind::effects) {
        log(LogLevel::warning, "Only an effect that was fitted can be added to the model.");
        return;
    }
    Settings settings = state_.settings;
    // Modulus and damping were fitted together with the effect; without them the effect would not fit.
    settings.effects = row->settings.effects;
    settings.youngs_modulus_Pa = row->settings.youngs_modulus_Pa;
    settings.damping_s = row->settings.damping_s;
    if (settings == state_.settings) return;
    change_settings({settings, "effects"});
    log(LogLevel::done, row->name +
                            " was added to the model, with the modulus and damping that were fitted with it. Run "
                            "to see its motion.");
}

void Workbench::on(const ChooseCandidate& c) {
    state_.candidate = c.key;
    look_at_forces();
}

}  // namespace myo::ui::commands
