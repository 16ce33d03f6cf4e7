#pragma once

#include <string>
#include <vector>

#include "check/checked_job.hpp"

namespace myo {

/// When a check can be made.
enum class CheckTime { before, after, both };

/// One thing that a model takes for granted.
struct Check {
    std::string id;
    std::string question;   // "Is the time step short enough?"
    CheckTime time = CheckTime::before;
    std::string source;     // of its threshold
    std::vector<Finding> (*find)(const CheckedJob&) = nullptr;
    bool explains_residual = false;   // what a fit leaves may come from it
};

/// All checks, those last that judge by the findings of others.
const std::vector<Check>& check_catalogue();
const Check* find_check(const std::string& id);

/// All findings before a job, and after it; fine ones are among them. A check that is made at both times is made anew
/// after the job, with its values.
std::vector<Finding> check_before(const Study& study);
std::vector<Finding> check_after(const CheckedJob& job);

}  // namespace myo
