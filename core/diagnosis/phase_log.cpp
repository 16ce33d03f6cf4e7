#include "diagnosis/phase_log.hpp"

#include <algorithm>

namespace myo::diagnosis {

void PhaseLog::add(const std::string& phase, double seconds, int runs) {
    auto same = std::find_if(costs_.begin(), costs_.end(), [&](const PhaseCost& cost) { return cost.phase == phase; });
    if (same == costs_.end()) same = costs_.insert(same, PhaseCost{phase});
    same->seconds += seconds;
    same->runs += runs;
}

Progress::Moment share_of_rest(const Progress& progress, double share) {
    const Progress::Moment now = std::chrono::steady_clock::now();
    if (progress.end() == Progress::Moment::max()) return progress.end();
    return now + std::chrono::duration_cast<Progress::Moment::duration>(share * (progress.end() - now));
}

}  // namespace myo::diagnosis
