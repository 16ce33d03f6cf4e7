#pragma once

#include <string>
#include <vector>

#include "commands/settings.hpp"

// What the checks found, as it is shown: of an experiment when it is opened, and of every job after it.

namespace myo::ui::commands {

/// Fine, doubtful, wrong.
enum class CheckState { green, amber, red };
const char* check_word(CheckState state);

/// What one check found of one subject. Figures carry their units.
struct CheckRow {
    std::string id;        // of the check
    std::string question;  // "Is the time step short enough?"
    CheckState state = CheckState::green;
    std::string subject;    // trial or parameter; empty: the whole experiment
    std::string figure;     // "0.42 %"; empty: it has none
    std::string threshold;  // beyond which it is doubtful; empty: none
    std::string source;     // of the threshold
    std::string sentence;
    std::string way_out;  // empty where all is well
    std::string step;     // of the window where it is mended, by its id: "mesh"
    bool told = false;    // a warning with file and line says so already
};
using CheckRows = std::vector<CheckRow>;

/// Of the worst row; green without any.
CheckState worst_state(const CheckRows& rows);
/// "11 green, 1 amber, 1 red"
std::string count_words(const CheckRows& rows);
/// "1 red, 2 amber"; "all green" where there is nothing else.
std::string doubt_words(const CheckRows& rows);

/// The checks of one job, with the settings that it worked on or found.
struct CheckReport {
    std::string job;    // "Simulate"
    std::string clock;  // when it began, "14:05:09"
    Settings settings;
    CheckRows rows;  // the worst first
};

}  // namespace myo::ui::commands
