#include "sweep/run_sweep.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>

#include "base/folder_lock.hpp"

namespace myo::sweep {
namespace {

namespace fs = std::filesystem;

/// Marker of a case if it belongs to it.
std::optional<CaseMarker> own_marker(const SweepCase& c, const fs::path& folder) {
    std::optional<CaseMarker> marker = read_marker(folder);
    if (marker && marker->fingerprint != fingerprint_text(c)) marker.reset();
    return marker;
}

/// Whether a case has not ended yet, or failed and is to be repeated.
bool to_be_run(const SweepCase& c, const fs::path& folder, const SweepRun& run) {
    const std::optional<CaseMarker> marker = own_marker(c, folder);
    return !marker || !has_ended(marker->state) || (run.retry && marker->state == CaseState::failed);
}

/// Cases of a share that are to be run.
std::vector<const SweepCase*> open_cases(const PreparedSweep& sweep, const fs::path& out, const SweepRun& run) {
    const int count = static_cast<int>(sweep.cases.size());
    std::vector<const SweepCase*> open;
    // Numbers of cases begin at 1.
    for (const int number : cases::numbers_of({.first = 1, .cases = count, .share = run.share})) {
        const SweepCase& c = sweep.cases[static_cast<std::size_t>(number) - 1];
        if (to_be_run(c, case_folder(out, number), run)) open.push_back(&c);
    }
    return open;
}

/// Threads that take one case after the other. They only wait for their children, so they are no threads of the
/// program's pool, which has no more than there are processors.
class CaseQueue {
public:
    using Ended = std::function<void(const SweepCase&, const CaseMarker&)>;

    CaseQueue(std::vector<const SweepCase*> open, const fs::path& out, const SweepRun& run, const CaseRunner& runner,
              const Progress& progress, const Ended& ended)
        : open_(std::move(open)), out_(out), run_(run), runner_(runner), progress_(progress), ended_(ended) {}

    /// Returns when all cases have ended, or after a cancellation.
    Result<void> work_off() {
        report();
        at_work_ = std::min(open_.size(), static_cast<std::size_t>(std::max(1, run_.jobs)));
        std::vector<std::thread> threads;
        for (std::size_t k = at_work_; k > 0; --k)
            threads.emplace_back([this] {
                take_cases();
                --at_work_;
            });
        // Only this thread, the caller's, asks for a cancellation; the others see `stop_`.
        while (at_work_ > 0) {
            if (progress_.cancelled()) stop_ = true;
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
        }
        for (std::thread& thread : threads) thread.join();
        return trouble_;
    }

private:
    void report() const {
        progress_.report({"sweep", static_cast<double>(ended_count_), static_cast<double>(open_.size()), "cases", {}});
    }

    void take_cases() {
        while (!stop_) {
            const std::size_t index = next_++;
            if (index >= open_.size()) return;
            take(*open_[index]);
        }
    }

    void take(const SweepCase& c) {
        const fs::path folder = case_folder(out_, c.number);
        // A lock next to the folder, not in it: the folder is cleared before a run, and its command takes the lock
        // within.
        const Result<std::optional<FolderLock>> lock = FolderLock::take_file_if_free(folder);
        if (!lock) return give_up(lock.error());
        // Another process may run the case, or have ended it since the list was made.
        if (!*lock || !to_be_run(c, folder, run_)) return;
        // With `stop_` as its flag: an error ends the cases at work, too.
        const Result<CaseMarker> marker = run_case(runner_, c, folder, Progress({}, &stop_));
        if (!marker) return give_up(marker.error());
        if (!has_ended(marker->state)) return;
        const std::lock_guard<std::mutex> guard(mutex_);
        ++ended_count_;
        report();
        if (ended_) ended_(c, *marker);
    }

    /// Ends the sweep after a case that cannot be written: the next one could not be written either.
    void give_up(const Error& error) {
        const std::lock_guard<std::mutex> guard(mutex_);
        trouble_ = error;
        stop_ = true;
    }

    const std::vector<const SweepCase*> open_;
    const fs::path& out_;
    const SweepRun& run_;
    const CaseRunner& runner_;
    const Progress& progress_;
    const Ended& ended_;
    std::atomic<std::size_t> next_{0}, at_work_{0};
    std::atomic<bool> stop_{false};  // the run is cancelled, or a case could not be written
    std::mutex mutex_;               // of what follows and of the callback
    std::size_t ended_count_ = 0;
    Result<void> trouble_;
};

}  // namespace

Result<void> check_kept_cases(const PreparedSweep& sweep, const fs::path& out) {
    for (const SweepCase& c : sweep.cases) {
        const fs::path folder = case_folder(out, c.number);
        const std::optional<CaseMarker> marker = read_marker(folder);
        if (marker && has_ended(marker->state) && marker->fingerprint != fingerprint_text(c))
            return Error{
                "was run with other values, options, data or another version of the program; choose another "
                "folder, or --replace to repeat such cases",
                folder.string()};
    }
    return {};
}

Result<void> run_sweep(const PreparedSweep& sweep, const fs::path& out, const SweepRun& run, const Progress& progress,
                       const std::function<void(const SweepCase&, const CaseMarker&)>& ended) {
    if (!run.replace)
        if (const Result<void> kept = check_kept_cases(sweep, out); !kept) return kept;
    std::error_code code;
    // The locks of the cases lie here, next to their folders.
    fs::create_directories(out / "cases", code);
    if (code) return Error{"folder cannot be made: " + code.message(), (out / "cases").string()};
    const CaseRunner runner{run.program, sweep.sweep.command, sweep.home, run.grace_s};
    return CaseQueue(open_cases(sweep, out, run), out, run, runner, progress, ended).work_off();
}

std::vector<CaseMarker> case_markers(const PreparedSweep& sweep, const fs::path& out) {
    std::vector<CaseMarker> markers;
    for (const SweepCase& c : sweep.cases) {
        const fs::path folder = case_folder(out, c.number);
        std::optional<CaseMarker> marker = own_marker(c, folder);
        // A marker "running" may be of a process that was killed; then nobody holds the lock.
        if (marker && marker->state == CaseState::running && FolderLock::take_file(folder))
            marker->state = CaseState::not_run;
        markers.push_back(marker.value_or(CaseMarker{.fingerprint = fingerprint_text(c)}));
    }
    return markers;
}

}  // namespace myo::sweep
