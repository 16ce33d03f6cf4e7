#include "backend/trial_repairs.hpp"

namespace myo::backend {

ui::commands::TraceRepairs shown_repairs(const experiment::TrialDeclaration& declared,
                                         const setup::PreparedTrial& trial) {
    ui::commands::TraceRepairs repairs;
    // A hold is shown as its mean, in which no span can be chosen.
    repairs.possible = declared.role != experiment::TrialRole::simulate && !declared.hold;
    repairs.start_s = trial.start_s;
    for (const measurement::TraceRepair& repair : declared.repairs)
        repairs.made.push_back(measurement::repair_words(repair, -trial.start_s));
    return repairs;
}

}  // namespace myo::backend
