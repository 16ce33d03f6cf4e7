#include "commands/job.hpp"

#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

namespace myo {

std::optional<double> remaining_time(double fraction, double elapsed_s) {
    if (!(fraction > 0.02) || elapsed_s < 0.5) return std::nullopt;
    return elapsed_s * (1.0 - fraction) / fraction;
}

struct Job::Content {
    std::string name;
    using Clock = std::chrono::steady_clock;
    Clock::time_point start = Clock::now();
    JobKind kind;
    std::atomic<bool> cancel = false;
    mutable std::mutex mutex;              // guards what follows
    std::condition_variable goes_on;
    bool paused = false;
    Clock::time_point paused_since;
    Clock::duration paused_for{0};
    ProgressEvent progress;
    std::optional<Completion> result;
    std::function<void()> wake;
    std::thread thread;
};

Job::Job(std::string name, Work work, std::function<Completion(const std::string&)> failed, std::function<void()> wake, JobKind kind)
    : content_(std::make_unique<Content>()) {
    Content* c = content_.get();
    c->name = std::move(name);
    c->wake = std::move(wake);
    c->kind = kind;
    c->thread = std::thread([c, work = std::move(work), failed = std::move(failed)] {
        const Progress progress(
            [c](const ProgressEvent& event) {
                {
                    std::unique_lock lock(c->mutex);
                    c->progress = event;
                    c->goes_on.wait(lock, [c] { return !c->paused || c->cancel; });
                }
                if (c->wake) c->wake();
            },
            &c->cancel);
        Completion completion;
        try {
            completion = work(progress);
        } catch (const std::exception& problem) {
            // Out of memory, above all: a mesh too fine must not end the program.
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
    cancel();
    if (content_->thread.joinable()) content_->thread.join();
}

void Job::cancel() {
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
        if (paused) content_->paused_since = Content::Clock::now();
        else content_->paused_for += Content::Clock::now() - content_->paused_since;
    }
    content_->goes_on.notify_all();
}

JobView Job::view() const {
    JobView view;
    Content::Clock::duration waited{0};
    {
        const std::lock_guard lock(content_->mutex);
        view.progress = content_->progress;
        view.paused = content_->paused;
        waited = content_->paused_for;
        if (view.paused) waited += Content::Clock::now() - content_->paused_since;
    }
    view.name = content_->name;
    view.searches = content_->kind.searches;
    view.elapsed_s = std::chrono::duration<double>(Content::Clock::now() - content_->start - waited).count();
    // Of a fit's evaluations only the greatest number is known.
    if (view.progress.unit != "evaluations" && !content_->kind.staged) view.remaining_s = remaining_time(view.fraction(), view.elapsed_s);
    view.cancelling = content_->cancel;
    return view;
}

std::optional<Job::Completion> Job::take_result() {
    const std::lock_guard lock(content_->mutex);
    return std::exchange(content_->result, std::nullopt);
}

}  // namespace myo
