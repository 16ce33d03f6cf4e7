#pragma once

#include <memory>
#include <string>

#include "commands/backend.hpp"
#include "commands/check_view.hpp"
#include "commands/diagnosis_view.hpp"
#include "commands/paint_ground.hpp"
#include "commands/search_result.hpp"

namespace myo::ui::commands {

/// A job that waits for the running one.
struct QueuedJob {
    int id = 0;
    std::string name;
};

enum class JobOutcome { done, stopped, failed };

/// A body with what was worked out of it, and the settings of its mesh.
struct PlacedBody {
    std::shared_ptr<const MeshedBody> body;
    std::shared_ptr<const PaintGround> ground;
    Settings settings;
};

/// A job that has ended, with what it brought: to be compared, and to be taken up again.
struct JobRecord {
    int id = 0;
    std::string name;   // "Simulate"
    std::string clock;  // when it began, "14:05:09"
    double seconds = 0.0;
    JobOutcome outcome = JobOutcome::done;
    std::string summary;  // "rms 1.32 mm"
    Settings settings;    // after it: with what a search found
    PlacedBody on;
    std::shared_ptr<const RunResult> run;  // null: none, or given up to save memory
    std::shared_ptr<const SearchResult> found;
    std::shared_ptr<const SearchView> search;
    std::shared_ptr<const DiagnosisView> diagnosis;
    std::shared_ptr<const CheckReport> checks;  // null: none were made
    bool compared = false;                      // its markers are drawn beside those of the shown run

    bool can_be_restored() const { return outcome != JobOutcome::failed && on.body; }
};

}  // namespace myo::ui::commands
