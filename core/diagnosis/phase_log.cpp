#include "diagnosis/phase_log.hpp"

#include <algorithm>

namespace myo::diagnosis {

void PhaseLog::add(const std::string& phase, double seconds, int runs) {
    auto same = std::find_if(costs_.begin(), costs_.end(), [&](const PhaseCost& cost) { return cost.phase == phase; });
    if (same == costs_.end()) same = costs_.insert(same, PhaseCost{phase});
    same->seconds += seconds;
    same->runs += runs;
}

}  // namespace myo::diagnosis
