#pragma once

#include <memory>
#include <string>

#include "commands/backend.hpp"
#include "commands/check_view.hpp"
#include "commands/diagnosis_view.hpp"
#include "commands/paint_ground.hpp"
#include "commands/search_result.hpp"

namespace myo::ui::commands {

/// A job that waits for the running one to end.
struct QueuedJob {
    int id = 0;        // unique in the session
    std::string name;  // name of the job: "Simulate"
};

/// How a job ended. `stopped` is a cancelled job.
enum class JobOutcome { done, stopped, failed };

/// A mesh with the data derived from it and the settings that it was built with.
struct PlacedBody {
    std::shared_ptr<const MeshedBody> body;     // null: no mesh
    std::shared_ptr<const PaintGround> ground;  // data for painting on it
    Settings settings;
};

/// A job that has ended, with its results. It can be compared with others and shown again.
struct JobRecord {
    int id = 0;            // unique in the session
    std::string name;      // "Simulate"
    std::string clock;     // local time of its start, "14:05:09"
    double seconds = 0.0;  // wall time; 0: not measured
    JobOutcome outcome = JobOutcome::done;
    std::string summary;                             // shown in the list: "rms error 1.32 mm"
    Settings settings;                               // of the job; for a search with the values that it found
    PlacedBody on;                                   // mesh that it worked on
    std::shared_ptr<const RunResult> run;            // null: no run, or released to save memory
    std::shared_ptr<const SearchResult> found;       // null: not a search
    std::shared_ptr<const SearchView> search;        // history of the search; null: not a search
    std::shared_ptr<const DiagnosisView> diagnosis;  // null: not a diagnosis
    std::shared_ptr<const CheckReport> checks;       // null: no checks
    bool compared = false;                           // its markers are drawn together with those of the shown run

    /// Whether its mesh and settings still exist, so that it can be shown again.
    bool can_be_restored() const { return outcome != JobOutcome::failed && on.body; }
};

}  // namespace myo::ui::commands
