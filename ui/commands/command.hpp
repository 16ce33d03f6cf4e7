#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "commands/workbench_state.hpp"

// What a person can ask for. Panels emit these; Workbench carries them out at the end of the frame.

namespace myo::ui::commands {

struct Open {
    std::filesystem::path path;
    std::optional<double> metres_per_unit;
};
/// Files from elsewhere: the first body or project among them is opened, the first recording imported.
struct Drop {
    std::vector<std::filesystem::path> files;
};
struct AnswerUnit {
    std::optional<double> metres_per_unit;
};  // empty = do not open
/// `goes_on`: the same drag as in the last frame, one step for undo.
struct ChangeSettings {
    Settings settings;
    std::string what;
    bool goes_on = false;
};
struct Undo {};
struct Redo {};
struct BuildMesh {};
struct Run {};
/// Whether every edit is followed by a short run, and how long that is [s]; empty: chosen for the trial.
struct ChangePreview {
    bool on = false;
    std::optional<double> length_s;
};
struct Calibrate {};
struct ChangeOptimize {
    OptimizeRequest request;
};
struct Optimize {};
struct Diagnose {};
/// A row of the diagnosis, by its key.
struct ChooseCandidate {
    std::string key;
};
/// Takes the effects of a fitted row, and the values that were fitted with them, into the settings.
struct AddEffect {
    std::string key;
};
struct ChooseMuscle {
    int muscle = 0;
};
/// New paint of a muscle on the body that is shown; one step for undo.
struct Paint {
    int muscle = 0;
    std::shared_ptr<const fibre::CellPaint> paint;
    std::string what;
};
struct ImportSignal {
    int muscle = 0;
    std::filesystem::path path;
};
struct ExportSignal {
    std::string muscle;
    fibre::Signal signal;
    std::filesystem::path path;
};
struct ChangeBrush {
    BrushSettings brush;
};
/// Of the running job.
struct Cancel {};
struct Pause {
    bool paused = true;
};
/// A job that waits, by its id.
struct Unqueue {
    int id = 0;
};
/// An ended job, by its id: its settings and what it brought are shown again; its markers are drawn beside the shown
/// run's; it is forgotten.
struct RestoreRecord {
    int id = 0;
};
struct CompareRecord {
    int id = 0;
    bool compared = true;
};
struct ForgetRecord {
    int id = 0;
};
/// Into the project's file; asks where when there is none.
struct Save {};
struct SaveAs {
    std::filesystem::path file;
};
struct AskWhereToSave {
    bool asks = true;
};  // false: the person gave it up
enum class UnsavedAnswer { save, discard, cancel };
struct AnswerUnsaved {
    UnsavedAnswer answer = UnsavedAnswer::cancel;
};
/// Projects of sessions that did not end well, the newest last. Until the person has taken that up, or has thrown away
/// one after the other, nothing else is opened.
struct OfferRecovery {
    std::vector<std::filesystem::path> files;
};
struct Recover {
    std::filesystem::path file;
};
struct DiscardRecovery {};
/// Asked for again while the question about a running job is open, it is the answer.
struct Quit {};
/// Whether the running job shall be stopped to quit.
struct AnswerStop {
    bool stops = false;
};
struct ChooseTrial {
    int trial = 0;
};
struct ChooseMarker {
    int marker = 0;
};
struct SetTime {
    double time_s = 0.0;
};
struct Play {
    bool playing = true;
};
struct SetSpeed {
    double speed = 1.0;
};
struct ChangeView {
    ViewOptions view;
};
struct SetDampingFrequency {
    double frequency_Hz = 5.0;
};
struct SetTheme {
    platform::ThemeName theme = platform::ThemeName::dark;
    float scale = 1.0f;
};
struct SetLayout {
    LayoutSizes layout;
};
struct Bookmark {
    std::filesystem::path folder;
    bool kept = true;
};
struct UsePreferences {
    Preferences preferences;
};
struct ClearLog {};
struct Tell {
    LogLevel level = LogLevel::information;
    std::string text;
};
/// A file of motion capture, to become a trial. What was chosen for the same file is kept.
struct ReadRecording {
    std::filesystem::path path;
    ReadingOptions reading = {};
};
struct ChangeImport {
    ImportChoices choices;
};
/// The label that is looked at; with `placing`, clicks on the body say where it sits.
struct ChooseLabel {
    int label = 0;
    bool placing = false;
};
struct ProposeMarkers {};
/// Start of the recording by its likeness to the shown run.
struct AlignImport {};
struct AddRecording {};
struct GiveUpImport {};
/// Pages and tables of what was found, into a folder.
struct WriteReport {
    std::filesystem::path folder;
};

using Command = std::variant<
    Open, Drop, AnswerUnit, ChangeSettings, Undo, Redo, BuildMesh, Run, ChangePreview, Calibrate, ChangeOptimize,
    Optimize, Diagnose, ChooseCandidate, AddEffect, ChooseMuscle, Paint, ImportSignal, ExportSignal, ChangeBrush,
    Cancel, Pause, Unqueue, RestoreRecord, CompareRecord, ForgetRecord, Save, SaveAs, AskWhereToSave, AnswerUnsaved,
    OfferRecovery, Recover, DiscardRecovery, Quit, AnswerStop, ChooseTrial, ChooseMarker, SetTime, Play, SetSpeed,
    ChangeView, SetDampingFrequency, SetTheme, SetLayout, Bookmark, UsePreferences, ClearLog, Tell, WriteReport,
    ReadRecording, ChangeImport, ChooseLabel, ProposeMarkers, AlignImport, AddRecording, GiveUpImport>;

}  // namespace myo::ui::commands
