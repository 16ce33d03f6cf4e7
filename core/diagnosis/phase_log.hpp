#pragma once

#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/stopwatch.hpp"

namespace myo::diagnosis {

/// Cost of one phase of a diagnosis.
struct PhaseCost {
    std::string phase;
    // Wall-clock time, summed over all times that the phase ran.
    double seconds = 0.0;
    int runs = 0;  // trial runs, tangents included
};

/// Progress and costs of the phases of a diagnosis. Phases write to it; of what it holds they read only whether the
/// user cancelled or a limit of time passed, so that results depend on nothing else of it.
class PhaseLog {
public:
    explicit PhaseLog(const Progress& progress) : progress_(progress) {}

    const Progress& progress() const { return progress_; }
    bool cancelled() const { return progress_.cancelled(); }
    /// In the order in which the phases first ran.
    const std::vector<PhaseCost>& costs() const { return costs_; }

    /// Reports the phase, runs the task, and adds its time and trial runs. Returns the value of the task.
    ///
    /// @param runs  trial runs of the task, as far as they are known before it; see add() for the others
    template <class Task>
    auto timed(const std::string& phase, int runs, const Task& task) {
        progress_.report({phase, 0.0, 1.0, "phase", {}});
        const Stopwatch watch;
        auto value = task();
        add(phase, watch.seconds(), runs);
        return value;
    }
    /// Adds to the cost of a phase; its entry is made if there is none.
    /// Not thread-safe: called from the thread of the diagnosis, between tasks.
    void add(const std::string& phase, double seconds, int runs);

private:
    friend class PhaseLimit;

    Progress progress_;
    std::vector<PhaseCost> costs_;
};

/// Moment at which this share of the time that is left is over; the last of the clock without a limit.
Progress::Moment share_of_rest(const Progress& progress, double share);

/// As long as it lives, the phases count as cancelled from a moment on, or from an earlier one of a limit around it.
class PhaseLimit {
public:
    PhaseLimit(PhaseLog& log, Progress::Moment end) : log_(log), before_(log.progress_) {
        log.progress_ = before_.until(end);
    }
    ~PhaseLimit() { log_.progress_ = before_; }
    PhaseLimit(const PhaseLimit&) = delete;
    PhaseLimit& operator=(const PhaseLimit&) = delete;

    /// Whether the phases were ended by this limit, and not by the user or an outer limit.
    bool passed() const { return log_.cancelled() && !before_.cancelled(); }

private:
    PhaseLog& log_;
    Progress before_;
};

}  // namespace myo::diagnosis
