#pragma once

#include <deque>
#include <functional>
#include <future>
#include <memory>

#include "commands/backend.hpp"
#include "commands/command.hpp"
#include "commands/live_value.hpp"
#include "commands/placed_paint.hpp"
#include "commands/undo.hpp"
#include "commands/workbench_state.hpp"

namespace myo::ui::commands {

/// The workbench without its looks: carries out commands, runs jobs one after the other, holds the state.
///
/// A job works on the settings as they were when it was asked for. What it brings is shown when it ends, but the
/// settings are changed by it only where nobody has changed them meanwhile.
class Workbench {
public:
    /// @param wake  called from another thread when there is something new to show; may be empty
    explicit Workbench(std::shared_ptr<Backend> backend, std::function<void()> wake = {});

    const WorkbenchState& state() const { return state_; }
    const Backend& backend() const { return *backend_; }
    void execute(const Command& command);

    /// To be called at the start of each frame: takes results of jobs and moves the time of a playing trial.
    /// @param seconds  since the last call
    void advance(double seconds);

    /// Something changes by itself, so frames must go on.
    bool animating() const { return state_.playing; }

    /// Writes unsaved work into a file from which it can be recovered, where it has changed since the last call;
    /// removes the file where all is saved. Writes on a thread beside the drawing: painted bodies are large. A failure
    /// is logged once.
    void autosave(const std::filesystem::path& file);
    /// Waits until nothing is being written any more.
    void finish_autosave();

private:
    /// A job that was asked for.
    struct Task {
        int id = 0;
        std::string name;
        std::string clock;
        Settings settings;
        std::shared_ptr<const Scene> scene;
        std::function<void()> begin;
        PlacedBody on;  // what it works on, once that is meshed
    };

    // workbench_jobs.cpp
    void request(const std::string& name, std::function<void()> begin);
    void begin(Task task);
    void begin_next();
    /// The work of the task that has begun.
    void start(const std::string& name, Job::Work work, JobKind kind = {});
    /// Meshes the body for the task, unless it is, and goes on.
    void with_body(std::function<void()> then);
    bool may_compute();
    void end_task(JobOutcome outcome, const std::string& summary, JobRecord with = {});
    void restore(int id);
    void forget(int id);
    void update_queue();

    // workbench_scene.cpp
    void open(const std::filesystem::path& path, std::optional<double> metres_per_unit);
    void drop(const std::vector<std::filesystem::path>& files);  // workbench_drop.cpp
    void show_scene(Scene scene, std::optional<double> metres_per_unit);
    void show_project(const std::filesystem::path& file, Project project, Scene scene);
    void build_mesh(std::function<void()> then);
    /// Frames on another body cannot be shown on it: they go.
    void show_body(const PlacedBody& on);

    // workbench_project.cpp
    Project project() const;
    void save();
    void save_as(std::filesystem::path file);
    void answer_unsaved(UnsavedAnswer answer);
    void go_on_with_pending();
    void quit();
    void write_report(const std::filesystem::path& folder);
    void remember_recent(const std::filesystem::path& path);
    void recover(const std::filesystem::path& file);
    void discard_recovery();
    void forget_recovered();
    void take_autosaved();

    // workbench_search.cpp
    void run();
    void calibrate();
    void optimize();
    using Search = std::function<Result<SearchResult>(const Progress&, const Backend::LiveSearch&)>;
    void search(const std::string& verb, Search search);
    void show_run(std::shared_ptr<const RunResult> run, const Settings& settings);
    void show_found(const std::string& verb, SearchResult result);

    // workbench_preview.cpp
    void change_preview(const ChangePreview& asked);
    /// Something it shows has changed: the running one is given up, another begins as soon as it can.
    void want_preview();
    void give_up_preview();
    /// Nothing of it is shown any more.
    void stop_preview();
    void begin_preview();
    void show_preview(double end_s, Result<RunResult> result);
    void advance_preview();

    // workbench_diagnosis.cpp
    void diagnose();
    void show_diagnosis(DiagnosisView diagnosis);
    /// Moves the time to where the chosen row's force can be seen, unless the motion plays.
    void look_at_forces();
    void add_effect(const std::string& key);

    // workbench_muscles.cpp
    void paint(const Paint& asked);
    void import_signal(const ImportSignal& asked);
    void export_signal(const ExportSignal& asked);
    /// Puts the settings' muscles on the body.
    void place_muscles();

    // workbench_import.cpp
    void read_recording(const std::filesystem::path& path, const ReadingOptions& reading);
    void begin_import(RecordingFile file);
    void change_import(const ImportChoices& choices);
    void choose_label(int label, bool placing);
    void propose_markers();
    void align_import();
    void add_recording();
    void give_up_import();

    void change_settings(const ChangeSettings& change);
    void set_settings(const Settings& settings);
    void check_stability();
    void choose_trial(int trial);
    void take_live();
    void log(LogLevel level, const std::string& text);
    void log_failure(const Error& error, const std::string& what);

    // workbench_checks.cpp
    /// Shows what the task's checks found and tells what is not fine, but for what was told before.
    void show_checks(const CheckRows& rows, const Settings& settings);
    /// That the task is done: with the doubts of its checks, where there are some.
    void log_done(const std::string& text, const CheckRows& rows);
    /// The step that a run chose takes the place of one that nobody set.
    void take_step(double time_step_s);

    std::shared_ptr<Backend> backend_;
    std::function<void()> wake_;
    WorkbenchState state_;
    UndoStack<Settings> undo_;
    PlacedPaint placed_;
    std::deque<Task> queue_;
    std::optional<Task> task_;  // that runs
    int next_id_ = 1;
    std::shared_ptr<LiveValue<DiagnosisView>> live_diagnosis_;
    std::shared_ptr<LiveValue<SearchView>> live_search_;
    std::optional<std::filesystem::path>
        dropped_with_body_;                        // recording that is read once the body it was dropped with is open
    std::optional<PendingAction> after_recovery_;  // what is opened once all that could be recovered was thrown away
    Settings autosaved_;                           // as they are in the file of recovery
    bool autosave_failed_ = false;
    std::filesystem::path
        recovered_;                  // file from which the shown project was recovered; to be removed once it is saved
    bool preview_given_up_ = false;  // what the running preview brings is not wanted any more
    // Last members: their threads end before anything they use.
    std::future<Result<void>> autosave_job_;
    std::unique_ptr<Job> preview_job_;
    std::unique_ptr<Job> job_;
};

}  // namespace myo::ui::commands
