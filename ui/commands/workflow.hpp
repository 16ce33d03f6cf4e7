#pragma once

#include <array>
#include <string>

#include "commands/workbench_state.hpp"

namespace myo::ui::commands {

/// Tasks of the window's left column, in the order from a body to a report.
enum class Step { body, mesh, material, fibres, run, measure, fit, diagnose, report };
inline constexpr std::array<Step, 9> all_steps{Step::body,    Step::mesh, Step::material, Step::fibres, Step::run,
                                               Step::measure, Step::fit,  Step::diagnose, Step::report};

/// Id of a task for commands and tests: "body"; and its title in the window: "Body".
const char* step_id(Step step);
const char* step_title(Step step);

/// State of a task.
enum class StepState {
    missing,  // something that it requires does not exist
    ready,    // can be done now
    stale,    // was done with other settings than the present ones
    done,     // done with the present settings
};

/// State of a task and what the user can do there.
struct StepStatus {
    StepState state = StepState::missing;
    std::string next;                       // next action or result, one sentence
    CheckState checks = CheckState::green;  // of a task that is done: the tick is shown only if they are green
};
/// State of a task for the present state of the workbench. Computed per frame; cheap.
StepStatus step_status(const WorkbenchState& state, Step step);

/// The task to continue with: the first outdated one, otherwise the first that can be done, otherwise the report.
Step next_step(const WorkbenchState& state);

}  // namespace myo::ui::commands
