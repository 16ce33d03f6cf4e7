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

/// The workbench without its window: executes commands, runs jobs one at a time and holds the state.
///
/// All functions are called on the UI thread. A job uses the settings of the time of its request. Its result is shown
/// when it ends; the settings are changed by it only if the user has not changed them since.
class Workbench {
public:
    /// @param backend  shared with the jobs' threads
    /// @param wake  called on another thread when there is something new to show; may be empty
    explicit Workbench(std::shared_ptr<Backend> backend, std::function<void()> wake = {});

    /// The state; the reference is valid as long as the workbench.
    const WorkbenchState& state() const { return state_; }
    /// The backend, of which panels may call the quick functions.
    const Backend& backend() const { return *backend_; }
    /// Executes one command. Called after a frame, so that all panels of a frame see the same state.
    void execute(const Command& command);

    /// Takes results of jobs and moves the time of a playing trial. Called at the start of each frame.
    ///
    /// @param seconds  since the last call
    void advance(double seconds);

    /// Something changes without input, so the next frame has to be drawn.
    bool animating() const { return state_.playing || state_.live; }

    /// Saves unsaved work to a recovery file if it has changed since the last call; removes the file if everything is
    /// saved. Writes on a background thread, as painted bodies are large. A failure is logged once.
    void autosave(const std::filesystem::path& file);
    /// Waits until the background writing has ended. Called before the program ends.
    void finish_autosave();

private:
    /// A requested job, waiting or running.
    struct Request {
        int id = 0;  // unique in the session
        std::string name;
        std::string clock;                   // local time of its start
        Settings settings;                   // at the time of the request
        std::shared_ptr<const Scene> scene;  // at the time of the request
        std::function<void()> begin;         // starts the first part of the work, on the UI thread
        PlacedBody on;                       // mesh it works on, after meshing
    };

    // Handlers of the commands, each in the file of its topic.
    // workbench_scene.cpp
    void on(const Open& command);
    void on(const AnswerUnit& command);
    void on(const Locate& command);
    void on(const BuildMesh&);
    // workbench_export.cpp
    void on(const ExportBody& command);
    void on(const SaveExperimentAs& command);
    // workbench_drop.cpp
    void on(const Drop& command);
    // workbench_preview.cpp
    void on(const ChangePreview& asked);
    // workbench_live.cpp
    void on(const PlayLive& command);
    void on(const SteerLive& command);
    void on(const RestartLive&);
    // workbench_search.cpp
    void on(const Run&);
    void on(const Calibrate&);
    void on(const ChangeOptimize& command);
    void on(const Optimize&);
    // workbench_diagnosis.cpp
    void on(const Diagnose&);
    void on(const ChooseCandidate& command);
    /// Adds the effects of a fitted row to the settings.
    void on(const AddEffect& command);
    void on(const DeclareEffect& command);
    // workbench_muscles.cpp
    void on(const ChooseMuscle& command);
    void on(const Paint& asked);
    void on(const ImportSignal& asked);
    void on(const ExportSignal& asked);
    void on(const ChangeBrush& command);
    // workbench_parts.cpp
    void on(const PaintPart& command);
    // workbench_jobs.cpp
    void on(const Cancel&);
    void on(const Pause& command);
    void on(const Unqueue& command);
    /// Shows the results and settings of an ended job again.
    void on(const RestoreRecord& command);
    void on(const CompareRecord& command);
    /// Removes an ended job from the history.
    void on(const ForgetRecord& command);
    // workbench_project.cpp
    void on(const Save&);
    void on(const SaveAs& command);
    void on(const AskWhereToSave& command);
    void on(const AnswerUnsaved& command);
    void on(const OfferRecovery& command);
    /// Opens a recovery file. Its content counts as unsaved.
    void on(const Recover& command);
    void on(const DiscardRecovery&);
    void on(const Quit&);
    void on(const AnswerStop& command);
    void on(const WriteReport& command);
    // workbench_import.cpp
    void on(const ReadRecording& command);
    void on(const ChangeImport& command);
    void on(const ChooseLabel& command);
    void on(const ProposeMarkers&);
    void on(const AlignImport&);
    void on(const AddRecording&);
    void on(const CancelImport&);
    // workbench_settings.cpp
    void on(const ChangeSettings& command);
    // workbench_declaration.cpp
    void on(const EditDeclaration& command);
    void on(const SaveDeclaration&);
    void on(const MakeExperiment& command);
    void on(const Undo&);
    void on(const Redo&);
    void on(const SetDampingFrequency& command);
    // workbench_view.cpp
    void on(const ChooseTrial& command);
    void on(const ChooseMarker& command);
    void on(const SetTime& command);
    void on(const Play& command);
    void on(const SetSpeed& command);
    void on(const ChangeView& command);
    void on(const SetTheme& command);
    void on(const SetLayout& command);
    void on(const Bookmark& command);
    void on(const UsePreferences& command);
    void on(const ClearLog&);
    void on(const LogMessage& command);

    // Jobs: workbench_jobs.cpp. A request (Request) consists of one or more jobs, such as meshing and then simulating.
    /// Starts a request, or appends it to the queue while another one runs.
    void request(const std::string& name, std::function<void()> begin);
    /// Starts a request on the UI thread.
    void begin(Request request);
    /// Starts the next request in the queue, if any.
    void begin_next();
    /// Starts the next job of the current request on its own thread.
    void start(const std::string& name, Job::Work work, JobKind kind = {});
    /// Calls `then` once request_->on holds the body for the current request; meshes it first if the settings require
    /// another mesh.
    void with_body(std::function<void()> then);
    /// Whether anything is open; otherwise logs a hint.
    bool may_compute();
    /// Ends the current request and adds its record to the history.
    void end_task(JobOutcome outcome, const std::string& summary, JobRecord with = {});
    /// Copies the queue into the state.
    void update_queue();

    // Opening: workbench_scene.cpp.
    /// @param located  experiment or mesh of a project that is not where it was; empty: where the project says
    void open(const std::filesystem::path& path, std::optional<double> metres_per_unit,
              const std::filesystem::path& located = {});
    /// Shows an opened scene and resets everything that belonged to the previous one.
    void show_scene(Scene scene, std::optional<double> metres_per_unit);
    /// Removes what belongs to the previous scene: body, runs, results, import and history.
    void forget_scene();
    /// Logs what the new scene contains.
    void report_scene();
    /// What was read from a file to open: the scene and, from a project, the project.
    struct OpenedFile {
        std::optional<Project> project = {};
        Result<Scene> scene = Error{"not read", ""};
    };
    /// Reads a file to open. Runs on the job's thread, so it gets the backend and no state.
    static OpenedFile read_file(Backend& backend, const std::filesystem::path& path,
                                std::optional<double> metres_per_unit, const std::filesystem::path& located,
                                const Progress& progress);
    /// Shows what was read, on the UI thread: the scene, the question where the body of a project is, or the error.
    void show_opened(const std::filesystem::path& path, std::optional<double> metres_per_unit, OpenedFile& opened);
    /// Ends the task if there is no mesh; returns whether it did.
    bool end_without_mesh(const Result<MeshedBody>& body, bool cancelled);
    /// Shows a complete simulation with these settings, and ends the task.
    void show_simulated(RunResult result, const Settings& settings);
    /// Logs the errors before and after the search whose result is shown.
    void log_found(const std::string& verb);
    /// Record of a search whose result is shown, without what end_task() adds.
    JobRecord record_of(const SearchResult& found) const;
    /// Shows the result of a diagnosis, or logs why there is none, and ends the request.
    void end_diagnosis(Result<DiagnosisView> result, bool cancelled);
    /// Shows an opened scene with the settings of its project.
    void show_project(const std::filesystem::path& file, Project project, Scene scene);
    /// Meshes the body of the current request, shows it, and continues with `then` (may be empty).
    void build_mesh(std::function<void()> then);
    /// Shows a mesh. The run of another mesh cannot be shown on it and is removed.
    void show_body(const PlacedBody& on);

    // Projects, quitting and recovery: workbench_project.cpp.
    /// The project as it would be saved now. Requires an open scene.
    Project project() const;
    /// Saves to the project's file, or asks for a name.
    void save();
    /// Writes the results into the folder of a self-contained project.
    void save_results(const std::filesystem::path& file);
    /// Saves to this file. Errors are logged. Returns whether it is saved.
    bool save_as(std::filesystem::path file);
    /// Claims a project's file for this window. Returns false if another window has it; then claim_.refusal says so.
    bool claim(const std::filesystem::path& file);
    /// Executes the action that waited for the decision about unsaved changes.
    void go_on_with_pending();
    /// Closes the window, after the questions that are necessary.
    void quit();
    /// Puts a path at the front of the recent files.
    void remember_recent(const std::filesystem::path& path);
    /// Deletes the recovery file of the shown project.
    void forget_recovered();
    /// Takes the result of the background writing, if it has ended.
    void take_autosaved();

    // Simulation and searches: workbench_search.cpp.
    /// Work of a search, on the job's thread.
    using Search = std::function<Result<SearchResult>(const Progress&, const Backend::LiveSearch&)>;
    /// Starts a search as a job of the current request. `verb` appears in messages: "Calibrated".
    void search(const std::string& verb, Search search);
    /// Shows a run, made with these settings.
    void show_run(std::shared_ptr<const RunResult> run, const Settings& settings);
    /// Shows the result of a search and takes over its settings, unless the user has changed them.
    void show_found(const std::string& verb, SearchResult result);

    // Live preview: workbench_preview.cpp.
    /// Call it after any change that the preview depends on: cancels the running preview and starts a new one as soon
    /// as possible.
    void want_preview();
    /// Cancels the running preview; its result will be ignored.
    void cancel_preview();
    /// Cancels the preview and removes its run from the view.
    void stop_preview();
    /// Starts a preview if one is wanted and nothing else is running.
    void begin_preview();
    /// Shows a preview that ends at `end_s` [s] of the trial, or why it failed.
    void show_preview(double end_s, Result<RunResult> result);
    /// Takes the result of a preview and starts the next one. Called once per frame.
    void advance_preview();

    // Playing live: workbench_live.cpp.
    /// Makes the model of the present settings.
    LivePlay::Make live_model() const;
    /// Stops playing live and waits for its thread.
    void stop_live();
    /// Passes changed settings to the model that plays live.
    void follow_settings_live();
    /// Takes what it shows now. Called once per frame.
    void take_live_frame();

    // Diagnosis: workbench_diagnosis.cpp.
    /// Shows the result of a diagnosis and ends its request.
    void show_diagnosis(DiagnosisView diagnosis);
    /// Moves the time to where the forces of the selected row are visible, unless the motion plays.
    void look_at_forces();

    // Muscles: workbench_muscles.cpp.
    /// Computes the paint of all muscles, and of the part that the brush paints, on the shown body.
    void place_muscles();

    // Parts: workbench_parts.cpp.
    /// Computes what the parts hold of the shown body.
    void place_parts();
    /// Puts the brush away if the part that it paints is no longer the same one.
    ///
    /// @param before  parts before an edit of the declaration
    void follow_parts(const std::vector<ScenePart>& before);

    // Import of recordings: workbench_import.cpp.
    /// Requests a job that reads a recording and then starts its import.
    void read_recording(const std::filesystem::path& path, const ReadingOptions& reading);
    /// Starts the import of a recording that was read.
    void begin_import(RecordingFile file);
    /// Replaces the choices of the import and what follows from them, without an undo entry.
    void change_import(const ImportChoices& choices);
    /// Assigns labels to markers as the backend proposes, with an undo entry.
    void propose_markers();
    /// Undoes or repeats a choice of the import. Returns false if none is open: then the settings are meant.
    bool step_import(bool back);

    // Settings: workbench_settings.cpp.
    /// Applies an edit of the user, with an undo entry.
    void change_settings(const ChangeSettings& change);
    /// Sets the settings and everything that depends on them, without an undo entry. Returns false, with a message, and
    /// changes nothing if their declaration cannot be shown.
    bool set_settings(const Settings& settings);
    /// Says why an edit of the declaration was refused.
    void refuse(const Error& error);  // workbench_declaration.cpp
    /// Shows the scene with another declaration. Returns false, with a message, if that is not possible.
    ///
    /// @param body  that is shown with it; null: none
    bool redeclare(const Declaration& declaration, const MeshedBody* body);  // workbench_declaration.cpp
    /// As redeclare(), and takes the declaration into the settings. Does nothing if they have it.
    bool take_declaration(const Declaration& declaration, const MeshedBody* body);
    /// Computes the critical velocity force for the present settings.
    void check_stability();
    /// Shows a trial from its start. An index out of range is limited.
    void choose_trial(int trial);  // workbench_view.cpp
    /// Takes intermediate results of the running search or diagnosis.
    void take_live();
    /// Appends a message; the oldest are dropped beyond max_log_lines.
    void log(LogLevel level, const std::string& text);
    /// Appends a failure: "Cannot open: <error>".
    void log_failure(const Error& error, const std::string& what);

    // Checks: workbench_checks.cpp.
    /// Shows the checks of the current request and logs findings that are not green, unless they were reported before.
    void show_checks(const CheckRows& rows, const Settings& settings);
    /// Logs that the request is done, with the findings of its checks.
    void log_done(const std::string& text, const CheckRows& rows);
    /// Takes over the time step that a run chose, unless the user has set one.
    void take_step(double time_step_s);

    std::shared_ptr<Backend> backend_;  // shared with the jobs' threads; never null
    std::function<void()> wake_;        // may be empty
    WorkbenchState state_;
    UndoStack<Settings> undo_;
    PlacedPaint placed_;                                        // paint of the muscles on the last meshes
    std::deque<Request> queue_;                                 // waiting requests in order
    std::optional<Request> request_;                            // the running request
    int next_id_ = 1;                                           // id of the next request
    std::shared_ptr<LiveValue<DiagnosisView>> live_diagnosis_;  // from the running diagnosis; null: none runs
    std::shared_ptr<LiveValue<SearchView>> live_search_;        // from the running search; null: none runs
    // Recording to import after the body it was dropped with is open.
    std::optional<std::filesystem::path> dropped_with_body_;
    std::optional<PendingAction> after_recovery_;  // to open after all recovery files were discarded
    /// The project's file and whether it is this window's.
    struct Claim {
        std::filesystem::path file;
        std::shared_ptr<const void> held;  // releases the claim when it is destroyed; null: not claimed
        std::optional<Error> refusal;      // another window has the file
    };
    Claim claim_;
    UndoStack<ImportChoices> import_undo_;  // of the import that is open
    Settings autosaved_;                    // settings in the recovery file
    bool autosave_failed_ = false;          // the last attempt failed and was logged
    // Recovery file of the shown project; removed after it is saved.
    std::filesystem::path recovered_;
    bool preview_given_up_ = false;  // the result of the running preview is not wanted
    Settings live_settings_;         // of the model that plays live
    // Last members: their destructors wait for threads that use the members above.
    std::future<Result<void>> autosave_job_;
    std::unique_ptr<LivePlay> live_;  // null: nothing plays live
    std::unique_ptr<Job> preview_job_;
    std::unique_ptr<Job> job_;
};

}  // namespace myo::ui::commands
