#pragma once

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "commands/backend.hpp"
#include "commands/brush_settings.hpp"
#include "commands/job.hpp"
#include "commands/job_record.hpp"
#include "commands/live_preview.hpp"
#include "commands/preferences.hpp"
#include "commands/settings.hpp"

namespace myo::ui::commands {

enum class LogLevel { information, done, warning, failure };

/// How what is done, but doubtful or wrong by its checks, looks.
inline LogLevel log_level(CheckState state) {
    if (state == CheckState::green) return LogLevel::done;
    return state == CheckState::amber ? LogLevel::warning : LogLevel::failure;
}

struct LogLine {
    LogLevel level = LogLevel::information;
    std::string text;
};

inline constexpr std::size_t most_log_lines = 2000;

inline constexpr const char* diagnose_job = "Diagnose";

/// What waits until a person has said what is to become of unsaved changes.
struct PendingAction {
    bool quit = false;  // else to open this
    std::filesystem::path open;
    std::optional<double> metres_per_unit;
};

/// Everything the panels show. Panels read it and emit commands; only Workbench changes it.
struct WorkbenchState {
    std::shared_ptr<const Scene> scene;
    std::shared_ptr<const MeshedBody> body;
    std::shared_ptr<const PaintGround> ground;                   // of `body`
    std::vector<std::shared_ptr<const fibre::CellPaint>> paint;  // of the settings' muscles on `body`; null without one
    std::shared_ptr<const RunResult> run;
    std::shared_ptr<const SearchResult> found;       // by the last search, while its run is shown
    std::shared_ptr<const SearchView> search;        // the running search, or the last one
    std::shared_ptr<const MeshedBody> search_body;   // that it works on
    std::shared_ptr<const DiagnosisView> diagnosis;  // the last one, or what is known of the running one
    std::string candidate;                           // key of its chosen row; empty = that of the verdict
    std::shared_ptr<const CheckReport> checks;      // of the newest job that made some, or the restored one; null: none
    std::shared_ptr<const RecordingImport> import;  // a recording that is being made a trial; null: none
    Settings settings;
    Settings saved_settings;                // as they are in the file
    std::filesystem::path project;          // its file; empty: never saved
    std::optional<double> metres_per_unit;  // of the mesh file that was opened
    Settings diagnosis_settings;            // with which `diagnosis` was started
    Settings body_settings;                 // with which `body` was meshed
    Settings run_settings;                  // with which `run` was made
    MeshPrediction prediction;
    std::vector<Choice> materials;
    std::vector<Choice> integrators;
    std::vector<Example> examples;
    OptimizeRequest optimize;  // of the next search for signals; its trial is the shown one

    int trial = 0;
    int marker = 0;
    int muscle = 0;  // of the settings' muscles, the one that is edited
    BrushSettings brush;
    double time_s = 0.0;
    bool playing = false;
    double speed = 1.0;                                 // of playing, against real time
    double damping_frequency_Hz = 5.0;                  // at which the numerical damping is shown
    std::optional<double> critical_velocity_force_1_s;  // at that frequency; empty where the scheme has none

    LivePreview preview;
    ViewOptions view;
    Preferences preferences;

    std::vector<LogLine> log;  // the newest last; the oldest are given up beyond most_log_lines
    std::size_t logged = 0;    // lines since the start
    std::optional<JobView> job;
    std::vector<QueuedJob> queue;                        // in the order in which they will run
    std::vector<JobRecord> history;                      // the newest last
    std::optional<std::filesystem::path> unit_question;  // a mesh file waits for its unit
    std::optional<PendingAction> pending;                // waits for an answer about unsaved changes
    bool asks_to_stop = false;                           // the window shall close, but a job runs
    bool asks_where_to_save = false;
    std::vector<std::filesystem::path>
        recovered;      // projects of a session that did not end well, to be taken up or thrown away
    bool quit = false;  // the window shall close
    bool can_undo = false;
    bool can_redo = false;

    bool busy() const { return job.has_value(); }
    /// Something goes on in the background whose result will be seen.
    bool works() const { return busy() || preview.working; }
    bool unsaved() const { return scene && !(settings == saved_settings); }
    float scale() const { return preferences.scale > 0.0f ? preferences.scale : 1.0f; }
    bool mesh_is_current() const { return body && same_mesh(settings, body_settings); }
    bool run_is_current() const { return run && settings == run_settings; }
    /// What was checked is what is set.
    bool checks_are_current() const { return checks && settings == checks->settings; }
    bool is_unstable() const {
        return settings.velocity_force_1_s > 0.0 && critical_velocity_force_1_s &&
               settings.velocity_force_1_s > *critical_velocity_force_1_s;
    }
    bool diagnosing() const { return job && job->name == diagnose_job; }
    /// Row of the diagnosis that is shown: the chosen one, or the verdict's, or the best so far; null without any.
    const DiagnosisRow* diagnosis_row() const;
    /// The chosen integrator, or null.
    const Choice* integrator() const {
        const auto chosen = std::find_if(integrators.begin(), integrators.end(),
                                         [&](const Choice& c) { return c.id == settings.integrator; });
        return chosen != integrators.end() ? &*chosen : nullptr;
    }
    const SceneTrial* scene_trial() const {
        return scene && trial >= 0 && trial < static_cast<int>(scene->trials.size())
                   ? &scene->trials[static_cast<std::size_t>(trial)]
                   : nullptr;
    }
    /// The muscle that is edited, or null.
    const Muscle* chosen_muscle() const {
        return muscle >= 0 && muscle < static_cast<int>(settings.muscles.size())
                   ? &settings.muscles[static_cast<std::size_t>(muscle)]
                   : nullptr;
    }
    /// Its paint; null without body or muscle.
    const fibre::CellPaint* chosen_paint() const {
        return chosen_muscle() && static_cast<std::size_t>(muscle) < paint.size()
                   ? paint[static_cast<std::size_t>(muscle)].get()
                   : nullptr;
    }
    /// What is shown of the body's motion: the best iterate of a running search on it, else the live preview, else the
    /// last run; null without any.
    std::shared_ptr<const RunResult> shown_run() const {
        return searching() && search && search->best && search_body == body ? search->best
               : preview.run                                                ? preview.run
                                                                            : run;
    }
    bool previewing() const { return preview.run && shown_run() == preview.run; }
    bool searching() const { return job && job->searches; }
    const SimulatedTrial* simulated_trial() const { return trial_of(shown_run().get()); }
    /// The shown trial in a run of the same scene, or null.
    const SimulatedTrial* trial_of(const RunResult* result) const {
        return result && trial >= 0 && trial < static_cast<int>(result->trials.size())
                   ? &result->trials[static_cast<std::size_t>(trial)]
                   : nullptr;
    }
    const JobRecord* record(int id) const {
        const auto entry = std::find_if(history.begin(), history.end(), [&](const JobRecord& r) { return r.id == id; });
        return entry != history.end() ? &*entry : nullptr;
    }
};

/// First and last time that can be shown, of measurement and simulation together; {0, 0} when there is neither.
std::array<double, 2> time_span(const WorkbenchState& state);

}  // namespace myo::ui::commands
