#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "base/progress.hpp"
#include "cases/case_range.hpp"
#include "sweep/case_folder.hpp"

namespace myo::sweep {

/// How the cases of a sweep are run.
struct SweepRun {
    int jobs = 1;          // cases at a time
    cases::Share share;    // cases of this process
    bool retry = false;    // repeats cases that failed
    bool replace = false;  // repeats cases of other values, data or versions; otherwise they are refused
    // Absolute path of this program, which each case runs as a child.
    std::filesystem::path program;
    // For a cancelled case to end by itself before it is killed.
    double grace_s = SweepPolicy().grace_s;
};

/// Checks that finished cases in a folder belong to this sweep; unfinished ones are run again anyway.
///
/// Errors: a case was run with other values, options or data, or by another version.
Result<void> check_kept_cases(const PreparedSweep& sweep, const std::filesystem::path& out);

/// Runs the cases of a share that have not ended yet. Cases that another process runs are left to it. Cancelled, cases
/// at work are stopped and no error is returned.
///
/// @param ended  called with every case that this call ran to its end, one at a time; may be null
/// Errors: those of check_kept_cases() and run_case(); the other cases at work are stopped.
Result<void> run_sweep(const PreparedSweep& sweep, const std::filesystem::path& out, const SweepRun& run,
                       const Progress& progress,
                       const std::function<void(const SweepCase&, const CaseMarker&)>& ended = {});

/// Marker of every case, in their order: not_run without one, or with that of other values; running if a process works
/// on it.
std::vector<CaseMarker> case_markers(const PreparedSweep& sweep, const std::filesystem::path& out);

}  // namespace myo::sweep
