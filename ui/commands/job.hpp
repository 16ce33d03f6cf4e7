#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "base/progress.hpp"

namespace myo::ui::commands {

/// What the estimate of the remaining time refers to.
enum class TimeLeft {
    exact,     // the whole job, if it continues at the same rate
    at_most,   // upper limit of the present part: only the maximum number of its evaluations is known
    of_phase,  // the present part only; others follow
};

/// State of a running job as it is shown.
struct JobView {
    std::string name;                   // as shown
    ProgressEvent progress;             // last report of the work
    double elapsed_s = 0.0;             // without pauses
    std::optional<double> remaining_s;  // empty while it cannot be estimated
    TimeLeft remaining_of = TimeLeft::exact;
    bool cancelling = false;  // cancelled, but the work has not ended yet
    bool paused = false;
    bool searches = false;  // it is a search, whose intermediate results are shown

    /// Whether progress is a fraction of a known total. A part that is only named has none.
    bool counts() const { return progress.total > 0.0 && progress.unit != "phase"; }
    /// Fraction done, 0 to 1; 0 if the total is unknown.
    double fraction() const { return counts() ? std::min(1.0, std::max(0.0, progress.done / progress.total)) : 0.0; }
};

/// Remaining time [s] by linear extrapolation. Empty before 2 % and half a second, when it would mean nothing.
///
/// @param fraction  done so far, 0 to 1
/// @param elapsed_s  time that this took
std::optional<double> remaining_time(double fraction, double elapsed_s);

/// Properties of a job that the display needs.
struct JobKind {
    bool staged = false;    // its count restarts in each part
    bool searches = false;  // it is a search
};

/// A long computation on its own thread. The UI thread polls it once per frame and takes its result.
///
/// `work` runs on the job's thread. It gets a Progress whose cancel flag belongs to the job, and returns the
/// completion: a function that the UI thread executes to show the result. An exception in the work is turned into a
/// call of `failed`. The destructor cancels the job and waits for its thread.
class Job {
public:
    using Completion = std::function<void()>;
    using Work = std::function<Completion(const Progress&)>;

    /// Starts the thread.
    ///
    /// @param name  shown
    /// @param failed  makes the completion for an exception, from its message
    /// @param wake  called on the job's thread when there is something new to draw; may be empty
    Job(std::string name, Work work, std::function<Completion(const std::string&)> failed, std::function<void()> wake,
        JobKind kind = {});
    ~Job();
    Job(const Job&) = delete;
    Job& operator=(const Job&) = delete;

    /// Sets the cancel flag; the work ends at its next check. Also ends a pause.
    void cancel();
    /// Pauses the work at its next progress report, until it continues or is cancelled. Paused time does not count.
    void pause(bool paused);
    /// A copy of the present state, for display.
    JobView view() const;

    /// Returns the completion, once, after the work has ended; empty before and afterwards.
    std::optional<Completion> take_result();

private:
    struct Content;
    std::unique_ptr<Content> content_;
};

}  // namespace myo::ui::commands
