#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "sweep/sweep_cases.hpp"

namespace myo::sweep {

/// How a case stands. What was not run, is running or was stopped is run when a sweep continues.
enum class CaseState {
    not_run,
    running,      // by another process
    done,         // the command ended with status 0
    unconverged,  // its fit or search ended before it converged; the report is complete
    failed,       // it ended otherwise; what it wrote is kept
    stopped,      // interrupted: nothing is kept but the fits of a diagnosis
};
/// As in the marker, in tables and on the terminal: "not run", "not converged".
std::string to_string(CaseState state);

/// The file case.json in the folder of a case. Written before the command begins and again when it has ended.
struct CaseMarker {
    // Identifies the case that was run; a marker with another fingerprint does not count.
    std::string fingerprint;  // hexadecimal
    CaseState state = CaseState::not_run;
    std::string message = {};  // why it is not done
    double seconds = 0.0;      // wall-clock time of the command
};

/// True for cases with a report or a failure: done, unconverged, failed.
bool has_ended(CaseState state);

/// Folder of a case, OUT/cases/0007; not made by this function.
std::filesystem::path case_folder(const std::filesystem::path& out, int number);

/// Fingerprint as the marker holds it: 16 hexadecimal digits.
std::string fingerprint_text(const SweepCase& sweep_case);

/// Marker of a folder; empty if there is none that can be read. Missing keys keep their defaults.
std::optional<CaseMarker> read_marker(const std::filesystem::path& folder);

/// The program that runs the cases, and how.
struct CaseRunner {
    // Absolute path; the cases work in other folders.
    std::filesystem::path program;
    CaseCommand command = CaseCommand::simulate;
    std::filesystem::path home;  // folder against which the text of a case names files
    double grace_s = 0.0;        // see ChildCall
};

/// Runs a case in its folder and waits for its end.
///
/// Writes the marker and experiment.toml, runs the command on it with one thread, keeps what it printed in output.txt
/// and messages.txt, and writes the marker again. What an earlier run of the case left is removed before, except the
/// fits of a diagnosis, from which it continues.
///
/// @return  an ended state, stopped, or running if another process works in the folder
/// Errors: the folder holds files but no marker, or a file cannot be written.
Result<CaseMarker> run_case(const CaseRunner& runner, const SweepCase& sweep_case, const std::filesystem::path& folder,
                            const Progress& progress);

}  // namespace myo::sweep
