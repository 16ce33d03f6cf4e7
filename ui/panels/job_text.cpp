#include "panels/job_text.hpp"

#include "panels/widgets.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {
namespace {

/// Small counts exactly, large ones with separators.
std::string count_label(double count) { return count < 1000.0 ? plot::plain_label(count, 3) : with_separators(count); }

}  // namespace

std::string counted_text(const commands::JobView& job) {
    const ProgressEvent& progress = job.progress;
    if (!job.counts() || progress.unit.empty()) return "";
    return count_label(progress.done) + " of " + count_label(progress.total) + " " + progress.unit;
}

/// A cancelled or paused job has no remaining time.
std::string time_text(const commands::JobView& job) {
    if (job.cancelling) return "stopping";
    if (job.paused) return "paused";
    if (!job.remaining_s) return duration_label(job.elapsed_s) + " so far";
    const std::string left = duration_label(*job.remaining_s) + " left";
    if (job.remaining_of == commands::TimeLeft::at_most) return "at most " + left;
    return job.remaining_of == commands::TimeLeft::of_phase ? left + " of this phase" : left;
}

std::string bar_text(const commands::JobView& job) {
    return job.counts() ? plot::value_label(100.0 * job.fraction(), 2) + " %" : "working";
}

}  // namespace myo::ui::panels
