#include <cmath>
#include <utility>

#include "base/letter_case.hpp"
#include "commands/search_target.hpp"
#include "commands/sought_signals.hpp"
#include "commands/workbench.hpp"
#include "plot/number_text.hpp"

// Simulations, and searches for parameters and signals that reproduce the measurement.

namespace myo::ui::commands {

void Workbench::show_run(std::shared_ptr<const RunResult> result, const Settings& settings) {
    state_.run = std::move(result);
    state_.run_settings = settings;
    stop_preview();
    const auto span = time_span(state_);
    state_.time_s = std::clamp(state_.time_s, span[0], span[1]);
    if (!state_.run->problem.empty()) log(LogLevel::warning, state_.run->problem);
    for (const std::string& warning : state_.run->warnings) log(LogLevel::warning, warning);
}

void Workbench::show_simulated(RunResult result, const Settings& settings) {
    const double seconds = result.seconds, rms = result.rms_m;
    // Only complete runs are timed: an aborted one has a wrong ratio of time to steps.
    if (result.problem.empty() && result.steps > 0.0)
        remember(state_.preferences.step_costs, {settings.element, request_->on.body->dofs, seconds / result.steps});
    state_.found.reset();
    show_body(request_->on);
    // The run may have shortened the step. The record holds the step that was used.
    Settings used = settings;
    if (result.time_step_s > 0.0) {
        used.time_step_s = result.time_step_s;
        take_step(used.time_step_s);
    }
    show_run(std::make_shared<RunResult>(std::move(result)), used);
    show_checks(state_.run->checks, used);
    const std::string error = std::isfinite(rms) ? "rms error " + plot::millimetres(rms) : "";
    const std::string told = error.empty() ? "." : ", " + error + ".";
    log_done("Simulated in " + plot::value_label(seconds, 3) + " s" + told, state_.run->checks);
    JobRecord record;
    record.seconds = seconds;
    record.settings = used;
    record.run = state_.run;
    if (!state_.run->checks.empty()) record.checks = state_.checks;
    end_task(JobOutcome::done, error, std::move(record));
}

void Workbench::on(const Run&) {
    if (!may_compute()) return;
    // Runs once the body is there, with the settings and the scene of the request: edits meanwhile do not affect it.
    const auto simulate = [this] {
        start(request_->name,
              [this, settings = request_->settings, scene = request_->scene,
               body = request_->on.body](const Progress& progress) -> Job::Completion {
                  auto result = std::make_shared<Result<RunResult>>(
                      backend_->simulate(*scene, *body, settings, std::nullopt, progress));
                  const bool cancelled = progress.cancelled();
                  return [this, settings, result, cancelled] {
                      if (cancelled) {
                          log(LogLevel::information, "Simulation cancelled.");
                          end_task(JobOutcome::stopped, "cancelled");
                      } else if (!*result) {
                          log_failure(result->error(), "Simulation failed");
                          end_task(JobOutcome::failed, result->error().text());
                      } else {
                          show_simulated(std::move(**result), settings);
                      }
                  };
              });
    };
    request("Simulate", [this, simulate] { with_body(simulate); });
}

void Workbench::search(const std::string& verb, Search find) {
    state_.search.reset();
    state_.search_body = request_->on.body;
    // A new mailbox for each search: results of an earlier search cannot arrive in this one.
    live_search_ = std::make_shared<LiveValue<SearchView>>();
    const auto live = live_search_;
    start(request_->name,
          [this, verb, find = std::move(find), live](const Progress& progress) -> Job::Completion {
              const auto show = [live](std::shared_ptr<const SearchView> view) { live->set(std::move(view)); };
              auto result = std::make_shared<Result<SearchResult>>(find(progress, show));
              const bool cancelled = progress.cancelled();
              return [this, verb, result, cancelled] {
                  // The last intermediate results, for the plots of the search.
                  take_live();
                  live_search_.reset();
                  if (*result) return show_found(verb, std::move(**result));
                  if (cancelled)
                      log(LogLevel::information,
                          request_->name + " cancelled without values; the settings are unchanged.");
                  else
                      log_failure(result->error(), request_->name + " failed");
                  end_task(cancelled ? JobOutcome::stopped : JobOutcome::failed,
                           cancelled ? "cancelled" : result->error().text());
              };
          },
          {false, true});
}

void Workbench::on(const Calibrate&) {
    if (!may_compute()) return;
    if (state_.scene->calibrated.empty()) {
        log(LogLevel::warning,
            "Nothing to calibrate: the experiment has no measured trial or declares every value as known.");
        return;
    }
    request("Calibrate", [this] {
        with_body([this] {
            search("Calibrated", [this, settings = request_->settings, scene = request_->scene,
                                  body = request_->on.body](const Progress& progress, const Backend::LiveSearch& live) {
                return backend_->calibrate(*scene, *body, settings, progress, live);
            });
        });
    });
}

void Workbench::on(const Optimize&) {
    if (!may_compute()) return;
    const SceneTrial* const trial = state_.scene_trial();
    if (!trial || !has_target(*trial)) {
        log(LogLevel::warning,
            "Nothing to optimise: the shown trial has neither goals nor measured markers to follow.");
        return;
    }
    OptimizeRequest request_of = offered_request(*state_.scene, state_.settings, state_.optimize);
    request_of.signals = request_of.signals && seeks_any_signal(*state_.scene, state_.settings);
    if (!request_of.signals && request_of.seek.empty()) {
        log(LogLevel::warning, has_actuators(*state_.scene, state_.settings)
                                   ? "Nothing to optimise: tick what the search may change."
                                   : "Nothing to optimise: add a muscle, a chamber or a tendon, or tick a modulus.");
        return;
    }
    // The trial is stored in the request, as another one may be shown when the job starts.
    request_of.trial = trial->name;
    request("Optimise", [this, request_of] {
        with_body([this, request_of] {
            search("Optimised", [this, request_of, settings = request_->settings, scene = request_->scene,
                                 body = request_->on.body](const Progress& progress, const Backend::LiveSearch& live) {
                return backend_->optimize(*scene, *body, settings, request_of, progress, live);
            });
        });
    });
}

void Workbench::log_found(const std::string& verb) {
    const SearchResult& found = *state_.found;
    const std::string errors = "rms error " + plot::millimetres(found.rms_before_m) + " before, " +
                               plot::millimetres(found.rms_after_m) + " after, " + std::to_string(found.evaluations) +
                               (found.evaluations == 1 ? " evaluation." : " evaluations.");
    if (found.stopped)
        log(LogLevel::warning, request_->name + " stopped; the best values so far are kept: " + errors);
    else
        log_done(verb + ": " + errors, found.run.checks);
}

JobRecord Workbench::record_of(const SearchResult& found) const {
    JobRecord record;
    record.seconds = found.run.seconds;
    record.settings = found.settings;
    record.run = state_.run;
    record.found = state_.found;
    record.search = state_.search;
    if (!found.run.checks.empty()) record.checks = state_.checks;
    return record;
}

void Workbench::show_found(const std::string& verb, SearchResult result) {
    show_body(request_->on);
    state_.found = std::make_shared<SearchResult>(std::move(result));
    const SearchResult& found = *state_.found;
    // Settings that were edited during the search are not overwritten.
    const bool untouched = state_.settings == request_->settings;
    const Settings before = state_.settings;
    // A refusal leaves the settings as they are, and says why.
    if (untouched && set_settings(found.settings)) {
        undo_.record(before, verb, false);
        state_.can_undo = true;
        state_.can_redo = false;
    }
    // Shares the ownership of the result instead of copying its run.
    show_run(std::shared_ptr<const RunResult>(state_.found, &found.run), found.settings);
    if (!found.problem.empty()) log(LogLevel::warning, found.problem);
    log_found(verb);
    if (!untouched)
        log(LogLevel::information,
            "The settings were changed meanwhile and are kept; Restore in Jobs applies the result.");
    for (const std::string& warning : found.warnings) log(LogLevel::warning, upper_first(warning));
    show_checks(found.run.checks, found.settings);
    JobRecord record = record_of(found);
    end_task(
        found.stopped ? JobOutcome::stopped : JobOutcome::done,
        "rms error " + plot::millimetres(found.rms_before_m) + " \xe2\x86\x92 " + plot::millimetres(found.rms_after_m),
        std::move(record));
}

void Workbench::on(const ChangeOptimize& c) { state_.optimize = c.request; }

}  // namespace myo::ui::commands
