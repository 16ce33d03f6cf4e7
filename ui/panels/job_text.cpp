#include "panels/job_text.hpp"

#include <algorithm>
#include <cmath>

#include "base/letter_case.hpp"
#include "panels/widgets.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {
namespace {

/// Rates change while a job runs: what is left lies between these multiples of the extrapolation.
struct TimeLeftPolicy {
    double least = 0.75;  // times the extrapolation
    double most = 1.5;    // times the extrapolation
};
constexpr TimeLeftPolicy time_left_policy;

/// A unit of time and the steps in which times are stated.
struct TimeStep {
    double unit_s;  // [s]
    const char* unit;
    double step;  // in the unit
};

/// The coarsest step that still separates times up to this one.
TimeStep step_for(double seconds) {
    if (seconds <= 90.0) return {1.0, "s", 5.0};
    if (seconds <= 600.0) return {60.0, "min", 1.0};
    if (seconds <= 5400.0) return {60.0, "min", 5.0};
    return {3600.0, "h", 1.0};
}

/// Number of units, rounded to a multiple of the step: down, or up to at least one step.
std::string in_steps(const TimeStep& step, double seconds, bool up) {
    const double steps = seconds / (step.unit_s * step.step);
    return std::to_string(std::lround((up ? std::max(1.0, std::ceil(steps)) : std::floor(steps)) * step.step));
}

/// Small counts exactly, large ones with separators.
std::string count_label(double count) { return count < 1000.0 ? plot::plain_label(count, 3) : with_separators(count); }

}  // namespace

std::string counted_text(const commands::JobView& job) {
    const ProgressEvent& progress = job.progress;
    if (!job.counts() || progress.unit.empty()) return "";
    // Only times are counted in fractions; a part of an evaluation is no evaluation.
    const double done = progress.unit == "s" ? progress.done : std::floor(progress.done);
    return count_label(done) + " of " + count_label(progress.total) + " " + progress.unit;
}

std::string stage_words(const commands::JobView& job) {
    const std::string& task = job.progress.task;
    // The work that the job is named after needs no other name.
    for (const char* own : {"", "simulate", "fit", "optimize"})
        if (task == own) return "";
    return task == lower_case(job.name) ? "" : upper_first(task);
}

std::string readable_detail(const commands::JobView& job) {
    std::string text = job.progress.message;
    std::replace(text.begin(), text.end(), '_', ' ');
    return text;
}

std::string time_left_range(double seconds) {
    const double longest_s = time_left_policy.most * seconds;
    const TimeStep step = step_for(longest_s);
    const std::string low = in_steps(step, time_left_policy.least * seconds, false),
                      high = in_steps(step, longest_s, true);
    return (low == "0" ? "less than " : low + " to ") + high + " " + step.unit;
}

/// A cancelled or paused job has no remaining time.
std::string time_text(const commands::JobView& job) {
    if (job.cancelling) return "stopping";
    if (job.paused) return "paused";
    if (!job.remaining_s) return duration_label(job.elapsed_s) + " so far";
    if (job.remaining_of == commands::TimeLeft::at_most) {
        const TimeStep step = step_for(*job.remaining_s);
        return "at most " + in_steps(step, *job.remaining_s, true) + " " + step.unit + " left of this phase";
    }
    const std::string left = time_left_range(*job.remaining_s) + " left";
    return job.remaining_of == commands::TimeLeft::of_phase ? left + " of this phase" : left;
}

std::string bar_text(const commands::JobView& job) {
    return job.counts() ? plot::value_label(100.0 * job.fraction(), 2) + " %" : "working";
}

}  // namespace myo::ui::panels
