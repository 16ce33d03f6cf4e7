#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "commands/workbench_state.hpp"

// Requests of the user. Panels emit these values during a frame; Workbench executes them after the frame, so that all
// panels of a frame see the same state. A new command is a struct here, an alternative of Command and a function
// Workbench::on() in the file of its topic.

namespace myo::ui::commands {

/// Opens an experiment folder, a mesh file or a project.
struct Open {
    std::filesystem::path path;
    std::optional<double> metres_per_unit;  // length unit of a mesh file without unit; empty: ask
};
/// Files dropped on the window: opens the first body or project among them and imports the first recording.
struct Drop {
    std::vector<std::filesystem::path> files;
};
/// Answer to the question about the unit of a mesh file.
struct AnswerUnit {
    std::optional<double> metres_per_unit;  // empty: do not open the file
};
/// Replaces the settings. `goes_on` marks a further change of the same drag, which undo treats as one edit.
struct ChangeSettings {
    Settings settings;
    std::string what;  // name of the edit, for merging in undo
    bool goes_on = false;
};
/// Edits the experiment's declaration: all edits together, or none if the result is no experiment. Ignored for a plain
/// mesh.
struct EditDeclaration {
    std::vector<DeclarationEdit> edits;
    std::string what;  // name of the edit, for merging in undo
    bool goes_on = false;
};
/// Writes the edited declaration to the experiment's file.
struct SaveDeclaration {};
/// Makes an experiment of a plain mesh, in a new folder, and opens it.
struct MakeExperiment {
    std::filesystem::path folder;
};
/// Restores the settings before the last edit.
struct Undo {};
/// Repeats the edit that was undone last.
struct Redo {};
/// Builds the mesh of the open body for the present settings. Ignored if nothing is open.
struct BuildMesh {};
/// Simulates all trials; builds the mesh first if the settings require another one.
struct Run {};
/// Switches the live preview: a short run after every edit.
struct ChangePreview {
    bool on = false;
    std::optional<double> length_s;  // of the trial [s]; empty: chosen by the program
};
/// Starts or stops playing live: the shown model moves in real time under the mouse.
struct PlayLive {
    bool on = true;
};
/// Replaces the controls of the model that plays live: levels of actuators, pull of the mouse. Step, damping and
/// velocity force follow the settings.
struct SteerLive {
    LiveControls controls;
};
/// Puts the model that plays live back to the start of its trial.
struct RestartLive {};
/// Fits the unknown parameters to the measured trials. Like all jobs it starts at once, or waits in the queue while
/// another one runs.
struct Calibrate {};
/// Sets how the next search for muscle signals works.
struct ChangeOptimize {
    OptimizeRequest request;
};
/// Searches muscle signals with which the markers follow the shown trial.
struct Optimize {};
/// Finds out what the model lacks.
struct Diagnose {};
/// Selects a row of the diagnosis.
struct ChooseCandidate {
    std::string key;  // DiagnosisRow::key
};
/// Adds the effects of a fitted row to the settings, together with the parameters fitted with them.
struct AddEffect {
    std::string key;  // DiagnosisRow::key
};
/// Moves an effect from the settings, as a diagnosis added it, into the experiment's declaration. One undo entry.
struct DeclareEffect {
    std::size_t added = 0;  // index in Settings::effects
};
/// Selects the muscle that is edited.
struct ChooseMuscle {
    int muscle = 0;  // index in Settings::muscles; limited to the range
};
/// Replaces the paint of a muscle on the shown body. One undo entry.
struct Paint {
    int muscle = 0;  // index in Settings::muscles
    std::shared_ptr<const fibre::CellPaint> paint;
    std::string what;  // name of the edit, for undo
};
/// Says by paint where a part of the body is. One undo entry. The part behind the last one is declared by it.
struct PaintPart {
    std::size_t part = 0;                           // index in Scene::parts
    std::shared_ptr<const fibre::CellPaint> paint;  // on the shown body; null: what the part holds now
};
/// Reads the signal of a muscle from a CSV file.
struct ImportSignal {
    int muscle = 0;  // index in Settings::muscles
    std::filesystem::path path;
};
/// Writes a signal to a CSV file.
struct ExportSignal {
    std::string muscle;  // name of its column in the file
    fibre::Signal signal;
    std::filesystem::path path;
};
/// Replaces the settings of the brush. Not part of undo.
struct ChangeBrush {
    BrushSettings brush;
};
/// Cancels the running job.
struct Cancel {};
/// Pauses or continues the running job.
struct Pause {
    bool paused = true;
};
/// Removes a waiting job from the queue.
struct Unqueue {
    int id = 0;  // QueuedJob::id
};
/// Shows the settings and results of an ended job again.
struct RestoreRecord {
    int id = 0;  // JobRecord::id
};
/// Draws the markers of an ended job together with those of the shown run, or no longer.
struct CompareRecord {
    int id = 0;  // JobRecord::id
    bool compared = true;
};
/// Removes an ended job from the list.
struct ForgetRecord {
    int id = 0;  // JobRecord::id
};
/// Saves to the project's file. Asks for a name if there is none.
struct Save {};
/// Saves to this file, which becomes the project's file.
struct SaveAs {
    std::filesystem::path file;
    std::optional<bool> self_contained = {};  // with body and recordings inside; empty: as before
};
/// Names the place of an experiment or mesh that an opened project did not find, and opens it.
struct Locate {
    std::filesystem::path source;  // empty: do not open the project
};
/// Writes the shown body for other programs.
struct ExportBody {
    ShapeExport what;
};
/// Copies the experiment, as edited, into a new folder.
struct SaveExperimentAs {
    std::filesystem::path folder;
};
/// Opens or closes the dialog that asks for a file name.
struct AskWhereToSave {
    bool asks = true;  // false: the user cancelled the dialog
};
/// Answer to the question about unsaved changes.
enum class UnsavedAnswer { save, discard, cancel };
/// Decides about unsaved changes; the waiting action continues or is dropped.
struct AnswerUnsaved {
    UnsavedAnswer answer = UnsavedAnswer::cancel;
};
/// Offers the recovery files of sessions that ended unexpectedly, newest last. Until the user has recovered one or
/// discarded all, nothing else is opened.
struct OfferRecovery {
    std::vector<std::filesystem::path> files;
};
/// Opens a recovery file.
struct Recover {
    std::filesystem::path file;
};
/// Deletes the newest recovery file.
struct DiscardRecovery {};
/// Closes the window. While the question about a running job is open, a second Quit confirms it.
struct Quit {};
/// Answer to the question whether the running job may be cancelled to quit.
struct AnswerStop {
    bool stops = false;
};
/// Selects the trial that view, plots and timeline show.
struct ChooseTrial {
    int trial = 0;  // index in Scene::trials; limited to the range
};
/// Selects the marker that the plots show.
struct ChooseMarker {
    int marker = 0;  // index in Scene::markers; limited to the range
};
/// Sets the shown time; limited to time_span().
struct SetTime {
    double time_s = 0.0;
};
/// Starts or stops playing the shown motion.
struct Play {
    bool playing = true;
};
/// Playback speed relative to real time; limited to 0.01 … 10.
struct SetSpeed {
    double speed = 1.0;
};
/// Replaces the options of the 3D view. Not part of undo.
struct ChangeView {
    ViewOptions view;
};
/// Frequency at which the numerical damping of the time scheme is shown; limited to 0.01 … 1000 Hz.
struct SetDampingFrequency {
    double frequency_Hz = 5.0;
};
/// Sets colours and scale of the window.
struct SetTheme {
    platform::ThemeName theme = platform::ThemeName::dark;
    float scale = 1.0f;
};
/// Sizes of the window's parts, after the user dragged an edge.
struct SetLayout {
    LayoutSizes layout;
};
/// Adds or removes a folder in the list of the file browser.
struct Bookmark {
    std::filesystem::path folder;
    bool kept = true;
};
/// Replaces all preferences, when the program starts.
struct UsePreferences {
    Preferences preferences;
};
/// Removes all messages.
struct ClearLog {};
/// Appends a message of the window itself to the log.
struct LogMessage {
    LogLevel level = LogLevel::information;
    std::string text;
};
/// Reads a motion capture file, to be added as a trial. Choices made before for the same file are kept.
struct ReadRecording {
    std::filesystem::path path;
    ReadingOptions reading = {};  // what the file does not state
};
/// Replaces the import choices.
struct ChangeImport {
    ImportChoices choices;
};
/// Selects a label of the recording. With `placing`, clicks in the view assign or place it.
struct ChooseLabel {
    int label = 0;         // index in Recording::labels; limited to the range
    bool placing = false;  // ignored without a meshed body
};
/// Proposes an assignment of labels to markers.
struct ProposeMarkers {};
/// Finds the start of the recording by comparing it with the shown run.
struct AlignImport {};
/// Adds the imported recording as a trial.
struct AddRecording {};
/// Closes the import without adding a trial.
struct CancelImport {};
/// Writes pages and tables of the results into a folder.
struct WriteReport {
    std::filesystem::path folder;
    int others = 0;  // number of files that the window itself writes there
};

/// All commands.
using Command = std::variant<
    Open, Drop, AnswerUnit, ChangeSettings, EditDeclaration, SaveDeclaration, MakeExperiment, Undo, Redo, BuildMesh,
    Run, ChangePreview, Calibrate, ChangeOptimize, Optimize, Diagnose, ChooseCandidate, AddEffect, DeclareEffect,
    ChooseMuscle, Paint, PaintPart, ImportSignal, ExportSignal, ChangeBrush, Cancel, Pause, Unqueue, RestoreRecord,
    CompareRecord, ForgetRecord, Save, SaveAs, AskWhereToSave, AnswerUnsaved, OfferRecovery, Recover, DiscardRecovery,
    Quit, AnswerStop, ChooseTrial, ChooseMarker, SetTime, Play, SetSpeed, ChangeView, SetDampingFrequency, SetTheme,
    SetLayout, Bookmark, UsePreferences, ClearLog, LogMessage, WriteReport, ReadRecording, ChangeImport, ChooseLabel,
    ProposeMarkers, AlignImport, AddRecording, CancelImport, PlayLive, SteerLive, RestartLive, Locate, ExportBody,
    SaveExperimentAs>;

}  // namespace myo::ui::commands
