#pragma once

#include <array>
#include <string>

#include "commands/workbench_state.hpp"

namespace myo::ui::commands {

/// The way from a body to an answer.
enum class Step { body, mesh, material, fibres, run, measure, fit, diagnose, report };
inline constexpr std::array<Step, 9> all_steps{Step::body,    Step::mesh, Step::material, Step::fibres, Step::run,
                                               Step::measure, Step::fit,  Step::diagnose, Step::report};

/// "body", for commands and tests; "Body", for people.
const char* step_id(Step step);
const char* step_title(Step step);

enum class StepState {
    missing,  // something it needs is not there
    ready,    // can be done now
    stale,    // was done with other settings than the present ones
    done,
};

struct StepStatus {
    StepState state = StepState::missing;
    std::string next;                       // what to do, or what there is: one sentence
    CheckState checks = CheckState::green;  // of what was done here: it deserves a tick only where they are green
};
StepStatus step_status(const WorkbenchState& state, Step step);

/// The first step that wants something, for those who do not know where to go on: stale before ready; report when all
/// is done.
Step next_step(const WorkbenchState& state);

}  // namespace myo::ui::commands
