#pragma once

#include <string>
#include <vector>

#include "check/checked_job.hpp"

namespace myo::check {

/// When a check applies: before a job, after it, or both.
enum class CheckTime { before, after, both };

/// A check of one assumption of the model, numerical or experimental.
struct Check {
    std::string id;        // in files, and on the command line
    std::string task;      // id of the workbench's task in which a finding is remedied: "mesh", "measure"
    std::string question;  // "Is the time step short enough?"
    CheckTime time = CheckTime::before;
    std::string source;  // of its threshold
    /// The check itself; returns no finding if it does not apply.
    std::vector<Finding> (*find)(const CheckedJob&) = nullptr;
    std::string cause = {};  // as which a violation explains a residual: "the time step"; empty: it explains none
};

/// All checks, in order; checks that use the findings of others come last.
const std::vector<Check>& check_catalogue();
/// The check with this id, or null.
const Check* find_check(const std::string& id);

/// Findings of one check, with its id and source filled in. A check with time `after` needs CheckedJob::run.
std::vector<Finding> run_check(const Check& check, const CheckedJob& job);

/// Findings of all checks that apply before a job, passed checks included.
std::vector<Finding> check_before(const setup::Setup& setup);

/// Findings of all checks after a job, passed checks included.
///
/// @param before  findings of check_before(): those of checks that apply only before a job are taken from here; empty:
///                these checks run now. Checks of both times always run again, with the values of the job
std::vector<Finding> check_after(const CheckedJob& job, const std::vector<Finding>& before = {});

}  // namespace myo::check
