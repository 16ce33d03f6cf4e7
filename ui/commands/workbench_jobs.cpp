#include <algorithm>
#include <ctime>
#include <utility>

#include "commands/workbench.hpp"

// Jobs: one runs, others wait, and ended ones are kept in the history.

namespace myo::ui::commands {
namespace {

constexpr std::size_t max_records = 60;  // in the history
constexpr double max_bytes = 1.5e9;      // memory limit for the frames of all records [bytes]

/// Local time as "14:05:09".
std::string clock_now() {
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    char text[16];
    std::strftime(text, sizeof text, "%H:%M:%S", &local);
    return text;
}

/// Memory of a run's frames [bytes]; its other data are small.
double bytes_of(const RunResult& run) {
    double bytes = 0.0;
    for (const SimulatedTrial& trial : run.trials)
        for (const Eigen::Matrix3Xd& frame : trial.frames) bytes += 8.0 * static_cast<double>(frame.size());
    return bytes;
}

/// Releases runs and searches of the oldest records if all records together need too much memory. Their settings are
/// kept. The newest record always keeps its run.
void save_memory(std::vector<JobRecord>& history) {
    if (history.size() > max_records) history.erase(history.begin());
    double bytes = 0.0;
    for (auto record = history.rbegin(); record != history.rend(); ++record) {
        if (record->run) bytes += bytes_of(*record->run);
        if (bytes <= max_bytes || record == history.rbegin()) continue;
        record->run.reset();
        record->found.reset();
        record->search.reset();
        record->compared = false;
    }
}

}  // namespace

bool Workbench::may_compute() {
    if (!state_.scene) {
        log(LogLevel::warning, "Open an experiment folder first.");
        return false;
    }
    return true;
}

void Workbench::request(const std::string& name, std::function<void()> begin_work) {
    // Settings and scene of now: edits while the request waits do not concern it.
    Request request{next_id_++, name, "", state_.settings, state_.scene, std::move(begin_work), {}};
    if (!request_) return begin(std::move(request));
    log(LogLevel::information, name + " waits until " + request_->name + " has ended.");
    queue_.push_back(std::move(request));
    update_queue();
}

void Workbench::begin(Request request) {
    request.clock = clock_now();
    request_ = std::move(request);
    // The function may replace request_, and with it itself: keep a copy.
    const std::function<void()> work = request_->begin;
    work();
    // The request may have ended without starting a job.
    if (!job_) begin_next();
}

void Workbench::begin_next() {
    request_.reset();
    if (queue_.empty()) return;
    Request next = std::move(queue_.front());
    queue_.pop_front();
    update_queue();
    begin(std::move(next));
}

void Workbench::update_queue() {
    state_.queue.clear();
    for (const Request& request : queue_) state_.queue.push_back({request.id, request.name});
}

void Workbench::start(const std::string& name, Job::Work work, JobKind kind) {
    const auto failed = [this, name](const std::string& what) -> Job::Completion {
        return [this, name, what] {
            log(LogLevel::failure, name + " stopped: " + what);
            end_task(JobOutcome::failed, what);
        };
    };
    if (preview_job_ && !preview_given_up_) {
        // A job gets all processor cores; the preview continues after it.
        cancel_preview();
        state_.preview.working = true;
    }
    job_ = std::make_unique<Job>(name, std::move(work), failed, wake_, kind);
    state_.job = job_->view();
}

void Workbench::with_body(std::function<void()> then) {
    if (!state_.body || !same_mesh(request_->settings, state_.body_settings)) return build_mesh(std::move(then));
    request_->on = {state_.body, state_.ground, state_.body_settings};
    then();
}

void Workbench::end_task(JobOutcome outcome, const std::string& summary, JobRecord with) {
    if (!request_) return;
    with.id = request_->id;
    with.name = request_->name;
    with.clock = request_->clock;
    with.outcome = outcome;
    with.summary = summary;
    // Searches and runs have set the settings that belong to their results.
    if (!with.run && !with.diagnosis) with.settings = request_->settings;
    // Another body may be shown by now, so the one of the request is stored.
    with.on = request_->on.body ? request_->on : PlacedBody{state_.body, state_.ground, state_.body_settings};
    state_.history.push_back(std::move(with));
    save_memory(state_.history);
}

void Workbench::on(const RestoreRecord& command) {
    const JobRecord* const found = state_.record(command.id);
    if (!found || !found->can_be_restored()) return;
    const JobRecord record = *found;
    // The declaration alone can be refused, so it comes before anything else is changed.
    const Settings before = state_.settings;
    if (!take_declaration(record.settings.declaration, record.on.body.get())) return;
    // An undo entry, so that the user can return to the settings before the restore.
    if (!(record.settings == before)) undo_.record(before, "restore", false);
    // Then the body: muscles are placed on it, and the frames of the run have its nodes.
    show_body(record.on);
    state_.run.reset();
    state_.found.reset();
    stop_preview();
    set_settings(record.settings);
    if (record.run) show_run(record.run, record.settings);
    state_.found = record.found;
    // Intermediate results of a running search or diagnosis take precedence.
    if (record.search && !state_.searching()) state_.search = record.search;
    if (record.checks) state_.checks = record.checks;
    if (record.diagnosis && !state_.diagnosing()) {
        state_.diagnosis = record.diagnosis;
        state_.diagnosis_settings = record.settings;
    }
    log(LogLevel::information, record.name + " of " + record.clock + " is restored, with its settings.");
}

void Workbench::on(const ForgetRecord& command) {
    std::erase_if(state_.history, [&](const JobRecord& record) { return record.id == command.id; });
}

void Workbench::on(const Cancel&) {
    if (job_) job_->cancel();
}

void Workbench::on(const Pause& c) {
    if (job_) job_->pause(c.paused);
}

void Workbench::on(const Unqueue& c) {
    std::erase_if(queue_, [&](const Request& request) { return request.id == c.id; });
    update_queue();
}

void Workbench::on(const CompareRecord& c) {
    for (JobRecord& record : state_.history)
        // A run that was released to save memory cannot be drawn.
        if (record.id == c.id) record.compared = c.compared && record.run;
}

}  // namespace myo::ui::commands
