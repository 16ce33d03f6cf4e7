#pragma once

#include <string>
#include <vector>

#include "check/checked_job.hpp"

namespace myo::check {

/// When a check can be made.
enum class CheckTime { before, after, both };

/// One thing that a model takes for granted.
struct Check {
    std::string id;
    std::string question;  // "Is the time step short enough?"
    CheckTime time = CheckTime::before;
    std::string source;  // of its threshold
    std::vector<Finding> (*find)(const CheckedJob&) = nullptr;
    bool explains_residual = false;  // what a fit leaves may come from it
};

/// All checks, those last that judge by the findings of others.
const std::vector<Check>& check_catalogue();
const Check* find_check(const std::string& id);

/// What one of them finds, with its id and source.
std::vector<Finding> run_check(const Check& check, const CheckedJob& job);

/// All findings before a job, fine ones among them.
std::vector<Finding> check_before(const setup::Setup& setup);

/// All findings after a job. A check that is made at both times is made anew, with the job's values; what can be asked
/// before it alone is taken from `before`, or asked now where that is empty.
std::vector<Finding> check_after(const CheckedJob& job, const std::vector<Finding>& before = {});

}  // namespace myo::check
