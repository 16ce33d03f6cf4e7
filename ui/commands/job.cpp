#include "commands/job.hpp"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "base/cancellation.hpp"

namespace myo::ui::commands {

std::optional<double> remaining_time(double fraction, double elapsed_s) {
    if (!(fraction > 0.02) || elapsed_s < 0.5) return std::nullopt;
    return elapsed_s * (1.0 - fraction) / fraction;
}

/// State that the two threads share. On the heap: its address must not change while the job's thread runs.
struct Job::Content {
    std::string name;
    using Clock = std::chrono::steady_clock;
    Clock::time_point start = Clock::now();
    JobKind kind;
    std::atomic<bool> cancel = false;
    mutable std::mutex mutex;         // guards the members below
    std::condition_variable goes_on;  // notified when the job continues or is cancelled
    bool paused = false;
    Clock::time_point paused_since;
    Clock::duration paused_for{0};
    ProgressEvent progress;
    double stage_start_s = 0.0;        // working time at which the present count began
    double stage_start = 0.0;          // fraction of it that was done then
    std::optional<Completion> result;  // set once, when the work has ended
    std::function<void()> wake;        // called on the job's thread
    std::thread thread;

    /// Working time since the start [s], without pauses. The caller holds the mutex.
    double working_s() const {
        const Clock::time_point now = Clock::now();
        return std::chrono::duration<double>(now - start - paused_for -
                                             (paused ? now - paused_since : Clock::duration{0}))
            .count();
    }

    // A new task, a new unit or a count that goes back starts a new estimate of the remaining time. What was done
    // before does not speed it up.
    void take(const ProgressEvent& event) {
        const bool starts = event.task != progress.task || event.unit != progress.unit ||
                            std::min(event.done, event.total > 0.0 ? event.total : event.done) < progress.done;
        progress = event;
        if (progress.total > 0.0) progress.done = std::min(progress.done, progress.total);
        if (!starts) return;
        stage_start_s = working_s();
        stage_start = progress.total > 0.0 ? progress.done / progress.total : 0.0;
    }
};

Job::Job(std::string name, Work work, std::function<Completion(const std::string&)> failed, std::function<void()> wake,
         JobKind kind)
    : content_(std::make_unique<Content>()) {
    Content* c = content_.get();
    c->name = std::move(name);
    c->wake = std::move(wake);
    c->kind = kind;
    c->thread = std::thread([c, work = std::move(work), failed = std::move(failed)] {
        // Runs on the job's thread. It blocks here while the job is paused, so the work needs no code for pausing.
        const Progress progress(
            [c](const ProgressEvent& event) {
                {
                    std::unique_lock lock(c->mutex);
                    c->take(event);
                    c->goes_on.wait(lock, [c] { return !c->paused || c->cancel; });
                }
                if (c->wake) c->wake();
            },
            &c->cancel);
        // Solvers without a Progress of their own check the flag through the scope.
        const CancellationScope scope(&progress);
        Completion completion;
        try {
            completion = work(progress);
        } catch (const std::exception& problem) {
            // Mainly std::bad_alloc: a mesh that is too fine must not end the program.
            completion = failed(problem.what());
        }
        {
            const std::lock_guard lock(c->mutex);
            c->result = std::move(completion);
        }
        if (c->wake) c->wake();
    });
}

Job::~Job() {
    // The thread uses content_, so it has to end first.
    cancel();
    if (content_->thread.joinable()) content_->thread.join();
}

void Job::cancel() {
    // Under the mutex, so that a work that is about to wait for the end of a pause does not miss the notification.
    {
        const std::lock_guard lock(content_->mutex);
        content_->cancel = true;
    }
    content_->goes_on.notify_all();
}

void Job::pause(bool paused) {
    {
        const std::lock_guard lock(content_->mutex);
        if (paused == content_->paused) return;
        content_->paused = paused;
        if (paused)
            content_->paused_since = Content::Clock::now();
        else
            content_->paused_for += Content::Clock::now() - content_->paused_since;
    }
    content_->goes_on.notify_all();
}

JobView Job::view() const {
    JobView view;
    double stage_s = 0.0, stage_start = 0.0;
    {
        const std::lock_guard lock(content_->mutex);
        view.progress = content_->progress;
        view.paused = content_->paused;
        view.elapsed_s = content_->working_s();
        stage_s = view.elapsed_s - content_->stage_start_s;
        stage_start = content_->stage_start;
    }
    view.name = content_->name;
    view.searches = content_->kind.searches;
    // Outside the mutex: the job's thread reports progress often and must not wait for this.
    // Extrapolated over the present count only: what was done when it began took none of its time.
    if (stage_start < 1.0)
        view.remaining_s = remaining_time((view.fraction() - stage_start) / (1.0 - stage_start), stage_s);
    // Behind a search come the step that its result needs, perhaps a search with it, and deviations.
    if (content_->kind.searches && view.progress.unit == "evaluations")
        view.remaining_of = TimeLeft::at_most;
    else if (content_->kind.staged || content_->kind.searches)
        view.remaining_of = TimeLeft::of_phase;
    view.cancelling = content_->cancel;
    return view;
}

std::optional<Job::Completion> Job::take_result() {
    const std::lock_guard lock(content_->mutex);
    return std::exchange(content_->result, std::nullopt);
}

}  // namespace myo::ui::commands
