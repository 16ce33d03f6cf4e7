#include "commands/job.hpp"

#include <atomic>
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
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    bool staged = false;
    std::atomic<bool> cancel = false;
    mutable std::mutex mutex;              // guards the two below
    ProgressEvent progress;
    std::optional<Completion> result;
    std::function<void()> wake;
    std::thread thread;
};

Job::Job(std::string name, Work work, std::function<Completion(const std::string&)> failed, std::function<void()> wake, bool staged)
    : content_(std::make_unique<Content>()) {
    Content* c = content_.get();
    c->name = std::move(name);
    c->wake = std::move(wake);
    c->staged = staged;
    c->thread = std::thread([c, work = std::move(work), failed = std::move(failed)] {
        const Progress progress(
            [c](const ProgressEvent& event) {
                {
                    const std::lock_guard lock(c->mutex);
                    c->progress = event;
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

void Job::cancel() { content_->cancel = true; }

JobView Job::view() const {
    JobView view;
    {
        const std::lock_guard lock(content_->mutex);
        view.progress = content_->progress;
    }
    view.name = content_->name;
    view.elapsed_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - content_->start).count();
    // Of a fit's evaluations only the greatest number is known.
    if (view.progress.unit != "evaluations" && !content_->staged) view.remaining_s = remaining_time(view.fraction(), view.elapsed_s);
    view.cancelling = content_->cancel;
    return view;
}

std::optional<Job::Completion> Job::take_result() {
    const std::lock_guard lock(content_->mutex);
    return std::exchange(content_->result, std::nullopt);
}

}  // namespace myo
