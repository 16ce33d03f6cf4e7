#pragma once

#include <array>
#include <string>

#include "commands/workbench_state.hpp"

namespace myo::ui::commands {

/// Tasks of the window's left column, in the order from a body to a report.
enum class Task { body, mesh, material, fibres, run, measure, fit, diagnose, report };
inline constexpr std::array<Task, 9> all_tasks{Task::body,    Task::mesh, Task::material, Task::fibres, Task::run,
                                               Task::measure, Task::fit,  Task::diagnose, Task::report};

/// Id of a task for commands and tests: "body".
const char* task_id(Task task);
/// Title of a task in the window: "Body".
const char* task_title(Task task);

/// State of a task.
enum class TaskState {
    missing,  // something that it requires does not exist
    ready,    // can be done now
    stale,    // was done with other settings than the present ones
    done,     // done with the present settings
};

/// State of a task and what the user can do there.
struct TaskStatus {
    TaskState state = TaskState::missing;
    std::string next;                       // next action or result, one sentence
    CheckState checks = CheckState::green;  // of a task that is done: the tick is shown only if they are green
};
/// State of a task for the present state of the workbench. Computed per frame; cheap.
TaskStatus task_status(const WorkbenchState& state, Task task);

/// The task to continue with: the first outdated one, otherwise the first that can be done, otherwise the report.
Task next_task(const WorkbenchState& state);

}  // namespace myo::ui::commands
