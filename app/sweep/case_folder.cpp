#include "sweep/case_folder.hpp"

#include <cstdio>
#include <cstring>
#include <sstream>
#include <system_error>
#include <vector>

#include "base/child_process.hpp"
#include "base/files.hpp"
#include "base/folder_lock.hpp"
#include "base/stopwatch.hpp"
#include "experiment/experiment_text.hpp"
#include "report/json.hpp"
#include "sweep/case_numbers.hpp"

namespace myo::sweep {
namespace {

namespace fs = std::filesystem;

const char* const marker_file = "case.json";
const char* const experiment_file = "experiment.toml";
const char* const output_file = "output.txt";
const char* const messages_file = "messages.txt";
/// Fits that a stopped diagnosis keeps; diagnose uses those of the same data, settings and version only.
const char* const fits_file = "diagnose_fits.json";

/// Exit status of a command that was interrupted, see app::ExitStatus.
enum : int { status_of_interrupt = 130 };

// For the search by name in read_marker().
constexpr CaseState all_states[] = {CaseState::not_run,     CaseState::running, CaseState::done,
                                    CaseState::unconverged, CaseState::failed,  CaseState::stopped};

/// Writes case.json (schema sweep_case/1). Errors: it cannot be written.
Result<void> write_marker(const fs::path& folder, int number, const CaseMarker& marker) {
    report::Json json{{"schema", "sweep_case/1"},
                      {"case", number},
                      {"fingerprint", marker.fingerprint},
                      {"state", to_string(marker.state)},
                      {"seconds", marker.seconds}};
    if (!marker.message.empty()) json["message"] = marker.message;
    return report::write_json(folder / marker_file, json);
}

/// Removes what an earlier run left, except kept fits. Only folders of sweeps are cleared.
Result<void> clear(const fs::path& folder) {
    std::error_code code;
    if (!fs::exists(folder, code)) return {};
    if (!fs::is_directory(folder, code)) return Error{"is no folder", folder.string()};
    if (!fs::is_empty(folder, code) && !fs::exists(folder / marker_file, code))
        return Error{"holds files that no sweep wrote; choose another folder", folder.string()};
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, code)) {
        // The marker goes last: a folder that is cleared half remains one of a sweep.
        const fs::path name = entry.path().filename();
        if (name != fits_file && name != marker_file) fs::remove_all(entry.path(), code);
        if (code) return Error{"cannot be removed: " + code.message(), entry.path().string()};
    }
    return {};
}

/// After an interrupt: a folder without fits to continue from disappears.
void remove_stopped(const fs::path& folder) {
    std::error_code ignored;
    if (const Result<void> cleared = clear(folder); cleared && !fs::exists(folder / fits_file, ignored))
        fs::remove_all(folder, ignored);
}

/// Last complaint of the program on standard error, without its name; warnings are none.
std::string last_complaint(const fs::path& messages) {
    const Result<std::string> text = read_file(messages);
    if (!text) return {};
    const std::string prefix = "myoloop: ", warning = prefix + "warning: ";
    std::string found;
    std::istringstream lines(*text);
    for (std::string line; std::getline(lines, line);)
        // The last one: a command complains when it ends.
        if (line.starts_with(prefix) && !line.starts_with(warning)) found = line.substr(prefix.size());
    return found;
}

/// Whether the report says that a fit or search did not converge.
bool says_unconverged(const fs::path& report_file) {
    const Result<report::Json> json = report::read_json(report_file);
    return json && json->is_object() && json->value("converged", report::Json()) == report::Json(false);
}

/// State and message of a command that has ended.
CaseMarker ended_case(const ChildEnd& end, CaseCommand command, const fs::path& folder, CaseMarker marker) {
    switch (end.how) {
        // A stopped case has no message: nothing went wrong.
        case ChildEnd::How::cancelled: marker.state = CaseState::stopped; return marker;
        case ChildEnd::How::not_started:
            marker.message = std::string("the program could not be started: ") + std::strerror(end.code);
            break;
        case ChildEnd::How::timed_out: marker.message = "it took too long"; break;
        case ChildEnd::How::signalled:
            marker.message = "it was ended by signal " + std::to_string(end.code) + " (" + ::strsignal(end.code) + ")";
            break;
        case ChildEnd::How::exited:
            if (end.code == 0) {
                marker.state = CaseState::done;
                return marker;
            }
            if (end.code == status_of_interrupt) {
                marker.state = CaseState::stopped;
                return marker;
            }
            marker.message = last_complaint(folder / messages_file);
            if (marker.message.empty()) marker.message = "exit status " + std::to_string(end.code);
            // A fit that did not converge has the exit status of a failure, but its report is complete.
            if (says_unconverged(report_of(command, folder))) {
                marker.state = CaseState::unconverged;
                return marker;
            }
    }
    marker.state = CaseState::failed;
    return marker;
}

/// Call of the command; a stopped diagnosis continues from the fits that it kept.
std::vector<std::string> arguments_of(const CaseRunner& runner, const SweepCase& c, const fs::path& folder) {
    std::vector<std::string> words{to_string(runner.command), folder.string()};
    words.insert(words.end(), c.options.begin(), c.options.end());
    words.insert(words.end(), {"--threads", "1", "--out", folder.string()});
    std::error_code code;
    if (fs::exists(folder / fits_file, code)) words.emplace_back("--resume");
    return words;
}

}  // namespace

std::string to_string(CaseState state) {
    switch (state) {
        case CaseState::not_run: return "not run";
        case CaseState::running: return "running";
        case CaseState::done: return "done";
        case CaseState::unconverged: return "not converged";
        case CaseState::failed: return "failed";
        case CaseState::stopped: return "stopped";
    }
    return {};
}

bool has_ended(CaseState state) {
    return state == CaseState::done || state == CaseState::unconverged || state == CaseState::failed;
}

fs::path case_folder(const fs::path& out, int number) {
    char name[16];
    std::snprintf(name, sizeof name, "%04d", number);
    return out / "cases" / name;
}

std::string fingerprint_text(const SweepCase& sweep_case) {
    char text[24];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(sweep_case.fingerprint));
    return text;
}

std::optional<CaseMarker> read_marker(const fs::path& folder) {
    const Result<report::Json> json = report::read_json(folder / marker_file);
    if (!json || !json->is_object()) return std::nullopt;
    const auto text = [&](const char* key) {
        return json->contains(key) && json->at(key).is_string() ? json->at(key).get<std::string>() : "";
    };
    CaseMarker marker{.fingerprint = text("fingerprint"), .message = text("message")};
    for (const CaseState state : all_states)
        if (text("state") == to_string(state)) marker.state = state;
    if (json->contains("seconds") && json->at("seconds").is_number()) marker.seconds = json->at("seconds");
    return marker;
}

Result<CaseMarker> run_case(const CaseRunner& runner, const SweepCase& sweep_case, const fs::path& folder,
                            const Progress& progress) {
    CaseMarker marker{.fingerprint = fingerprint_text(sweep_case), .state = CaseState::running};
    std::error_code code;
    // A command whose sweep was killed may still work here; it holds the lock of its folder.
    const Result<bool> used = fs::is_directory(folder, code) ? FolderLock::is_taken(folder) : Result<bool>(false);
    if (!used) return used.error();
    if (*used) return marker;
    if (const Result<void> cleared = clear(folder); !cleared) return cleared.error();
    // Before anything else is written: the folder is then known as one of a sweep.
    if (const Result<void> begun = write_marker(folder, sweep_case.number, marker); !begun) return begun.error();
    // The text names files against the experiment's folder; in the folder of the case they have other relative paths.
    const std::string text = experiment::experiment_text_for(folder, sweep_case.text, runner.home);
    if (const Result<void> written = write_file(folder / experiment_file, text); !written) return written.error();

    const Stopwatch watch;
    const ChildEnd end = run_child({.program = runner.program,
                                    .arguments = arguments_of(runner, sweep_case, folder),
                                    .output = folder / output_file,
                                    .messages = folder / messages_file,
                                    .grace_s = runner.grace_s},
                                   [&] { return progress.cancelled(); });
    marker = ended_case(end, runner.command, folder, marker);
    marker.seconds = watch.seconds();
    if (marker.state == CaseState::stopped) {
        remove_stopped(folder);
        return marker;
    }
    if (const Result<void> written = write_marker(folder, sweep_case.number, marker); !written) return written.error();
    return marker;
}

}  // namespace myo::sweep
