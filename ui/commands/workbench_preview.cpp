#include <algorithm>
#include <utility>

#include "commands/workbench.hpp"

// Live preview: short runs next to everything else, each cancelled by the next edit.

namespace myo::ui::commands {

void Workbench::on(const ChangePreview& asked) {
    const bool longer = asked.length_s != state_.preview.length_s;
    // A command that changes nothing must not cancel the running preview.
    if (asked.on == state_.preview.on && !longer) return;
    state_.preview.on = asked.on;
    state_.preview.length_s = asked.length_s;
    // A change of the length needs another run; switching off removes the shown one.
    if (asked.on)
        want_preview();
    else
        stop_preview();
}

void Workbench::want_preview() {
    if (!state_.preview.on) return;
    cancel_preview();
    state_.preview.working = true;
    begin_preview();
}

void Workbench::cancel_preview() {
    if (!preview_job_) return;
    preview_job_->cancel();
    // The thread ends at its next check of the flag; advance_preview() then discards the result.
    preview_given_up_ = true;
}

void Workbench::stop_preview() {
    cancel_preview();
    state_.preview.working = false;
    state_.preview.run.reset();
    state_.preview.problem.clear();
    state_.time_s = std::clamp(state_.time_s, time_span(state_)[0], time_span(state_)[1]);
}

void Workbench::begin_preview() {
    // Only one preview at a time, and none while a job needs the processor.
    if (!state_.preview.working || preview_job_ || request_) return;
    const bool possible = state_.scene_trial() && state_.mesh_is_current();
    // A complete run with these settings is better than a preview.
    if (!possible || state_.run_is_current()) return stop_preview();
    const RunExtent extent{static_cast<std::size_t>(state_.trial), preview_length_s(state_)};
    const auto work = [this, extent, settings = state_.settings, scene = state_.scene,
                       body = state_.body](const Progress& progress) -> Job::Completion {
        auto result = std::make_shared<Result<RunResult>>(
            backend_->simulate(*scene, *body, settings, extent, progress));
        return [this, extent, result] { show_preview(extent.end_s, std::move(*result)); };
    };
    const auto failed = [this, extent](const std::string& what) -> Job::Completion {
        return [this, extent, what] { show_preview(extent.end_s, Error{what, ""}); };
    };
    preview_given_up_ = false;
    preview_job_ = std::make_unique<Job>("Preview", work, failed, wake_);
}

void Workbench::show_preview(double end_s, Result<RunResult> result) {
    LivePreview& preview = state_.preview;
    const bool first = !preview.run;
    preview.working = false;
    preview.problem = result ? "" : result.error().text();
    preview.run = result ? std::make_shared<const RunResult>(std::move(*result)) : nullptr;
    preview.end_s = end_s;
    // Beyond the end of the preview there is nothing to see.
    if (first && preview.run && state_.time_s > end_s) state_.time_s = end_s;
}

void Workbench::advance_preview() {
    // A cancelled preview must not overwrite the state, but its thread has to end before the next one starts.
    if (preview_job_)
        if (auto completion = preview_job_->take_result()) {
            preview_job_.reset();
            if (!preview_given_up_) (*completion)();
        }
    begin_preview();
}

}  // namespace myo::ui::commands
