#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/progress.hpp"

namespace myo::ui::commands {

/// What a job's time left is of.
enum class TimeLeft {
    exact,     // all of it, as far as it goes on evenly
    at_most,   // it may end earlier: only the greatest number of its evaluations is known
    of_stage,  // the present stage; others come after it
};

/// What a person sees of a running job.
struct JobView {
    std::string name;
    ProgressEvent progress;
    double elapsed_s = 0.0;
    std::optional<double> remaining_s;  // empty while it cannot be told
    TimeLeft remaining_of = TimeLeft::exact;
    bool cancelling = false;
    bool paused = false;
    bool searches = false;  // for values: what it knows so far is shown

    /// Whether it knows its end; a stage that is only named does not.
    bool counts() const { return progress.total > 0.0 && progress.unit != "stage"; }
    /// Done part, 0 to 1; 0 when the total is unknown.
    double fraction() const { return counts() ? std::min(1.0, std::max(0.0, progress.done / progress.total)) : 0.0; }
};

/// Time left when `fraction` took `elapsed` seconds: linear, and only once it means something (2 % and half a second).
std::optional<double> remaining_time(double fraction, double elapsed_s);

/// How a job counts, and what it is.
struct JobKind {
    bool staged = false;  // its progress counts anew in every stage
    bool searches = false;
};

/// Long work on its own thread, which hands its result over when asked at the start of a frame.
///
/// The work gets a Progress whose cancel flag is the job's, and returns what shall be done with the result on the
/// caller's thread. Exceptions of the work become a call of `failed`. The destructor cancels and waits.
class Job {
public:
    using Completion = std::function<void()>;
    using Work = std::function<Completion(const Progress&)>;

    /// @param wake  called from the work's thread when there is something new to draw; may be empty
    Job(std::string name, Work work, std::function<Completion(const std::string&)> failed, std::function<void()> wake,
        JobKind kind = {});
    ~Job();
    Job(const Job&) = delete;
    Job& operator=(const Job&) = delete;

    void cancel();
    /// The work waits at its next report of progress until it goes on or is cancelled; its time stands still.
    void pause(bool paused);
    JobView view() const;

    /// The completion, once, when the work is done.
    std::optional<Completion> take_result();

private:
    struct Content;
    std::unique_ptr<Content> content_;
};

}  // namespace myo::ui::commands
