#pragma once

#include <string>
#include <vector>

#include "commands/settings.hpp"

// Results of checks as they are shown: of an experiment when it is opened, and of each job after it has ended.

namespace myo::ui::commands {

/// Result of a check: fine, doubtful, or wrong. The order is that of severity.
enum class CheckState { green, amber, red };
/// "green", "amber" or "red".
const char* check_word(CheckState state);

/// Result of one check for one subject. Numbers in texts carry their units.
struct CheckRow {
    std::string id;        // id of the check
    std::string question;  // "Is the time step short enough?"
    CheckState state = CheckState::green;
    std::string subject;    // trial or parameter; empty: the whole experiment
    std::string figure;     // measured value, "0.42 %"; empty: none
    std::string threshold;  // limit beyond which the value is doubtful; empty: none
    std::string source;     // where the threshold comes from
    std::string sentence;   // the finding in words
    std::string way_out;    // what the user can do; empty if all is well
    std::string task;       // id of the task where it can be corrected: "mesh"
    bool warned = false;    // already reported by a warning with file and line
};
using CheckRows = std::vector<CheckRow>;

/// The most severe state of the rows; green if there are none.
CheckState worst_state(const CheckRows& rows);
/// Counts of all states: "11 green, 1 amber, 1 red".
std::string count_text(const CheckRows& rows);
/// Counts of the states that need attention: "1 red, 2 amber"; otherwise "all green".
std::string doubt_text(const CheckRows& rows);

/// The checks of one job, with the settings that it used or found.
struct CheckReport {
    std::string job;    // name of the job: "Simulate"
    std::string clock;  // local time of its start, "14:05:09"
    Settings settings;
    CheckRows rows;  // most severe first
};

}  // namespace myo::ui::commands
