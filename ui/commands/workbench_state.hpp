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
#include "commands/live_play.hpp"
#include "commands/live_preview.hpp"
#include "commands/preferences.hpp"
#include "commands/settings.hpp"

namespace myo::ui::commands {

/// Severity of a log message; sets its icon and colour.
enum class LogLevel { information, done, warning, failure };

/// Severity of a message about a finished job, from the result of its checks.
inline LogLevel log_level(CheckState state) {
    if (state == CheckState::green) return LogLevel::done;
    return state == CheckState::amber ? LogLevel::warning : LogLevel::failure;
}

/// One message of the log.
struct LogLine {
    LogLevel level = LogLevel::information;
    std::string text;
};

// Number of messages that are kept.
inline constexpr std::size_t max_log_lines = 2000;

// Name of the job by which WorkbenchState::diagnosing() recognises it.
inline constexpr const char* diagnose_job = "Diagnose";

/// An action that waits until the user has decided about unsaved changes.
struct PendingAction {
    bool quit = false;  // close the window; otherwise open the file below
    std::filesystem::path open;
    std::optional<double> metres_per_unit;  // of the file to open
};

/// A project whose experiment or mesh is not where it was.
struct MissingSource {
    std::filesystem::path project, source;
};

/// Everything that the panels show. Panels read it and emit commands; only Workbench changes it, on the UI thread.
/// Large parts are shared pointers to constant data, so that a copy of the state is cheap.
struct WorkbenchState {
    std::shared_ptr<const Scene> scene;         // null: nothing is open
    std::shared_ptr<const MeshedBody> body;     // null: not meshed
    BodyActuators actuators;                    // declared chambers and tendons on `body`
    Eigen::MatrixXd part_shares;                // Backend::part_shares() of `body`
    std::shared_ptr<const PaintGround> ground;  // data for painting on `body`
    // of the settings' muscles on `body`; empty without a body
    std::vector<std::shared_ptr<const fibre::CellPaint>> paint;
    std::shared_ptr<const fibre::CellPaint> part_paint;  // of the part that the brush paints; null: none
    std::shared_ptr<const RunResult> run;                // the shown run; null: none
    std::shared_ptr<const SearchResult> found;           // result of the last search, while its run is shown
    std::shared_ptr<const SearchView> search;            // history of the running or last search
    std::shared_ptr<const MeshedBody> search_body;       // body that `search` works on
    std::shared_ptr<const DiagnosisView> diagnosis;      // of the last diagnosis, or of the running one so far
    std::string candidate;                      // key of the selected row of the diagnosis; empty = the verdict's row
    std::shared_ptr<const CheckReport> checks;  // of the newest job that has checks, or of the restored one; null: none
    std::shared_ptr<const RecordingImport> import;  // recording that is being imported; null: none
    Settings settings;                              // as edited now
    Settings saved_settings;                        // as in the project's file
    std::filesystem::path project;                  // the project's file; empty: never saved
    bool self_contained = false;                    // the project's folder holds body and recordings
    std::optional<double> metres_per_unit;          // of the mesh file that is open
    Settings diagnosis_settings;                    // settings of `diagnosis`
    Settings body_settings;                         // settings of `body`
    Settings run_settings;                          // settings of `run`
    MeshPrediction prediction;                      // size of the mesh for the present settings
    std::vector<Choice> materials;                  // to choose from
    std::vector<Choice> integrators;                // to choose from
    std::vector<Example> examples;
    OptimizeRequest optimize;  // for the next search for signals; its trial is the shown one

    int trial = 0;   // index of the shown trial
    int marker = 0;  // index of the shown marker
    int muscle = 0;  // index of the edited muscle in the settings
    BrushSettings brush;
    double time_s = 0.0;  // shown time of the trial
    bool playing = false;
    double speed = 1.0;                                 // of playing, relative to real time
    double damping_frequency_Hz = 5.0;                  // frequency at which the numerical damping is shown
    std::optional<double> critical_velocity_force_1_s;  // at that frequency [1/s]; empty: the scheme has none

    LivePreview preview;
    std::optional<LiveView> live;  // the model that plays live; empty: none
    ViewOptions view;
    Preferences preferences;

    std::vector<LogLine> log;                            // newest last; at most max_log_lines
    std::size_t logged = 0;                              // number of messages since the start
    std::string refused;                                 // why the last edit of the declaration was refused
    std::optional<JobView> job;                          // the running job; empty: none
    std::vector<QueuedJob> queue;                        // waiting jobs in order
    std::vector<JobRecord> history;                      // ended jobs, newest last
    std::optional<std::filesystem::path> unit_question;  // mesh file whose unit the user has to choose
    std::optional<MissingSource> missing;                // project whose experiment or mesh the user has to find
    std::optional<PendingAction> pending;                // waits for the answer about unsaved changes
    bool asks_to_stop = false;                           // quitting waits for the answer about a running job
    bool asks_where_to_save = false;                     // the dialog for the project's file name is open
    // Recovery files of sessions that ended unexpectedly, newest last.
    std::vector<std::filesystem::path> recovered;
    std::vector<std::string> recovered_words;  // name and time of each
    bool quit = false;                         // the window has to close
    bool can_undo = false;
    bool can_redo = false;

    /// A job is running.
    bool busy() const { return job.has_value(); }
    /// A job or a preview is running whose result will be shown.
    bool works() const { return busy() || preview.working; }
    /// The settings differ from the project's file.
    bool unsaved() const { return scene && !(settings == saved_settings); }
    /// Scale of text and controls; 1 until the preferences are known.
    float scale() const { return preferences.scale > 0.0f ? preferences.scale : 1.0f; }
    /// The mesh has the element type and edge length of the settings.
    bool mesh_is_current() const { return body && same_mesh(settings, body_settings); }
    /// The shown run was made with the present settings.
    bool run_is_current() const { return run && settings == run_settings; }
    /// The shown checks belong to the present settings.
    bool checks_are_current() const { return checks && settings == checks->settings; }
    /// The velocity force exceeds the critical value of the time scheme.
    bool is_unstable() const {
        return settings.velocity_force_1_s > 0.0 && critical_velocity_force_1_s &&
               settings.velocity_force_1_s > *critical_velocity_force_1_s;
    }
    /// A diagnosis is running.
    bool diagnosing() const { return job && job->name == diagnose_job; }
    /// Shown row of the diagnosis: the selected one, otherwise the verdict's, otherwise the best so far. Null if there
    /// is none.
    const DiagnosisRow* diagnosis_row() const;
    /// The selected time scheme; null if its id is unknown.
    const Choice* integrator() const {
        const auto chosen = std::find_if(integrators.begin(), integrators.end(),
                                         [&](const Choice& c) { return c.id == settings.integrator; });
        return chosen != integrators.end() ? &*chosen : nullptr;
    }
    /// The shown trial; null if there is none.
    const SceneTrial* scene_trial() const {
        return scene && trial >= 0 && trial < static_cast<int>(scene->trials.size())
                   ? &scene->trials[static_cast<std::size_t>(trial)]
                   : nullptr;
    }
    /// The edited muscle; null if there is none.
    const Muscle* chosen_muscle() const {
        return muscle >= 0 && muscle < static_cast<int>(settings.muscles.size())
                   ? &settings.muscles[static_cast<std::size_t>(muscle)]
                   : nullptr;
    }
    /// Paint of the edited muscle; null without a body or a muscle.
    const fibre::CellPaint* chosen_paint() const {
        return chosen_muscle() && static_cast<std::size_t>(muscle) < paint.size()
                   ? paint[static_cast<std::size_t>(muscle)].get()
                   : nullptr;
    }
    /// Paint that the brush changes, of a part or of the edited muscle; null without one.
    const fibre::CellPaint* brush_paint() const { return brush.part >= 0 ? part_paint.get() : chosen_paint(); }
    /// Run that the view and the plots show: the best iterate of a running search on this body, otherwise the live
    /// preview, otherwise the last run. Null if there is none.
    std::shared_ptr<const RunResult> shown_run() const {
        return searching() && search && search->best && search_body == body ? search->best
               : preview.run                                                ? preview.run
                                                                            : run;
    }
    /// Run that the view draws: the model that plays live, otherwise the shown run. Null if there is none.
    std::shared_ptr<const RunResult> drawn_run() const { return live && live->frame ? live->frame->run : shown_run(); }
    /// The shown trial in the drawn run; null if it has none.
    const SimulatedTrial* drawn_trial() const { return trial_of(drawn_run().get()); }
    /// The shown run is a preview.
    bool previewing() const { return preview.run && shown_run() == preview.run; }
    /// A search is running.
    bool searching() const { return job && job->searches; }
    /// The shown trial in the shown run; null if it has none.
    const SimulatedTrial* simulated_trial() const { return trial_of(shown_run().get()); }
    /// The shown trial in a run of the same scene; null if it is not there.
    const SimulatedTrial* trial_of(const RunResult* result) const {
        return result && trial >= 0 && trial < static_cast<int>(result->trials.size())
                   ? &result->trials[static_cast<std::size_t>(trial)]
                   : nullptr;
    }
    /// Record of an ended job by its id; null if it was removed. Valid until the history changes.
    const JobRecord* record(int id) const {
        const auto entry = std::find_if(history.begin(), history.end(), [&](const JobRecord& r) { return r.id == id; });
        return entry != history.end() ? &*entry : nullptr;
    }
};

/// Whether the model has exactly the effects of a row of the diagnosis.
inline bool is_in_model(const WorkbenchState& state, const DiagnosisRow& row) {
    return !row.settings.effects.empty() && row.settings.effects == state.settings.effects;
}

/// First and last time that can be shown [s], of measurement and simulation together; of the recording during an
/// import. {0, 0} if there is nothing.
std::array<double, 2> time_span(const WorkbenchState& state);

}  // namespace myo::ui::commands
