#include "commands/workbench.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace myo::ui::commands {

std::array<double, 2> time_span(const WorkbenchState& state) {
    std::array<double, 2> span{0.0, 0.0};
    bool first = true;
    const auto include = [&](const Eigen::VectorXd& time) {
        if (time.size() == 0) return;
        span[0] = first ? time[0] : std::min(span[0], time[0]);
        span[1] = first ? time[time.size() - 1] : std::max(span[1], time[time.size() - 1]);
        first = false;
    };
    // During an import the timeline shows the recording; its times count from the chosen start.
    if (state.import) {
        include(state.import->file.recording->time_s.array() - state.import->choices.start_s);
        return span;
    }
    if (const SceneTrial* trial = state.scene_trial()) include(trial->time_s);
    if (const SimulatedTrial* trial = state.simulated_trial()) include(trial->frame_time_s);
    return span;
}

const DiagnosisRow* WorkbenchState::diagnosis_row() const {
    // An id that no longer exists, and an empty one, fall back to the verdict's row, then to the best effect.
    if (!diagnosis || diagnosis->rows.empty()) return nullptr;
    if (const DiagnosisRow* const asked = diagnosis->row(candidate); asked && !candidate.empty()) return asked;
    for (const DiagnosisRow& row : diagnosis->rows)
        if (row.chosen) return &row;
    return diagnosis->rows.size() > 1 ? &diagnosis->rows[1] : &diagnosis->rows.front();
}

Workbench::Workbench(std::shared_ptr<Backend> backend, std::function<void()> wake)
    : backend_(std::move(backend)), wake_(std::move(wake)) {
    // Valid ids before anything is opened, so that the panels always find the selected entries.
    state_.materials = backend_->materials();
    state_.integrators = backend_->integrators();
    state_.examples = backend_->examples();
    if (!state_.materials.empty()) state_.settings.material = state_.materials.front().id;
    if (!state_.integrators.empty()) state_.settings.integrator = state_.integrators.front().id;
}

void Workbench::log(LogLevel level, const std::string& text) {
    if (state_.log.size() >= max_log_lines)
        // A tenth at once, as erasing at the front of a vector moves all other lines.
        state_.log.erase(state_.log.begin(), state_.log.begin() + max_log_lines / 10);
    state_.log.push_back({level, text});
    ++state_.logged;
}

void Workbench::log_failure(const Error& error, const std::string& what) {
    log(LogLevel::failure, what + ": " + error.text());
}

void Workbench::execute(const Command& asked) {
    std::visit([this](const auto& command) { on(command); }, asked);
    // Values that follow from others are updated once here, not in each handler.
    state_.can_undo = state_.import ? import_undo_.can_undo() : undo_.can_undo();
    state_.can_redo = state_.import ? import_undo_.can_redo() : undo_.can_redo();
    if (job_) state_.job = job_->view();
}

void Workbench::advance(double seconds) {
    // Values of running jobs first: their completion below must see the last ones.
    take_autosaved();
    take_live();
    if (job_) {
        if (auto completion = job_->take_result()) {
            // The completion may start the next job of the same request.
            job_.reset();
            state_.job.reset();
            if (*completion) (*completion)();
            if (!job_) begin_next();
            if (!request_) state_.asks_to_stop = false;  // the user who was asked sees the result first
        }
        if (job_) state_.job = job_->view();
    }
    // After the job: only when none runs, a preview may begin.
    advance_preview();
    take_live_frame();
    if (state_.playing) {
        const auto span = time_span(state_);
        state_.time_s += seconds * state_.speed;
        // The best iterate of a search and a preview are played in a loop.
        if (state_.time_s >= (state_.previewing() ? state_.preview.end_s : span[1]) &&
            (state_.searching() || state_.previewing())) {
            state_.time_s = span[0];
        } else if (state_.time_s >= span[1]) {
            state_.time_s = span[1];
            state_.playing = false;
        }
    }
}

void Workbench::take_live() {
    if (live_diagnosis_)
        if (auto known = live_diagnosis_->take()) state_.diagnosis = std::move(known);
    if (live_search_)
        if (auto known = live_search_->take()) {
            // The first motion of a search is played, as it is what the user waits for.
            const bool first = known->best && !(state_.search && state_.search->best);
            state_.search = std::move(known);
            if (first) execute(Play{});
        }
}

}  // namespace myo::ui::commands
