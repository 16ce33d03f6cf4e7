#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "commands/workbench_state.hpp"

// What a person can ask for. Panels emit these; Workbench carries them out at the end of the frame.

namespace myo::command {

struct Open { std::filesystem::path path; std::optional<double> metres_per_unit; };
struct AnswerUnit { std::optional<double> metres_per_unit; };    // empty = do not open
/// `goes_on`: the same drag as in the last frame, one step for undo.
struct ChangeSettings { Settings settings; std::string what; bool goes_on = false; };
struct Undo {};
struct Redo {};
struct BuildMesh {};
struct Run {};
struct Calibrate {};
struct Diagnose {};
/// A row of the diagnosis, by its key.
struct ChooseCandidate { std::string key; };
/// Takes the effects of a fitted row, and the values that were fitted with them, into the settings.
struct AddEffect { std::string key; };
struct ChooseMuscle { int muscle = 0; };
/// New paint of a muscle on the body that is shown; one step for undo.
struct Paint { int muscle = 0; std::shared_ptr<const CellPaint> paint; std::string what; };
struct ImportSignal { int muscle = 0; std::filesystem::path path; };
struct ExportSignal { std::string muscle; Signal signal; std::filesystem::path path; };
struct ChangeBrush { BrushSettings brush; };
struct Cancel {};
struct ChooseTrial { int trial = 0; };
struct ChooseMarker { int marker = 0; };
struct SetTime { double time_s = 0.0; };
struct Play { bool playing = true; };
struct SetSpeed { double speed = 1.0; };
struct ChangeView { ViewOptions view; };
struct SetDampingFrequency { double frequency_Hz = 5.0; };
struct SetTheme { ThemeName theme = ThemeName::dark; float scale = 1.0f; };
struct ClearLog {};

}  // namespace myo::command

namespace myo {

using Command = std::variant<command::Open, command::AnswerUnit, command::ChangeSettings, command::Undo, command::Redo,
                             command::BuildMesh, command::Run, command::Calibrate, command::Diagnose,
                             command::ChooseCandidate, command::AddEffect, command::ChooseMuscle,
                             command::Paint, command::ImportSignal, command::ExportSignal, command::ChangeBrush, command::Cancel, command::ChooseTrial,
                             command::ChooseMarker, command::SetTime, command::Play, command::SetSpeed, command::ChangeView,
                             command::SetDampingFrequency, command::SetTheme, command::ClearLog>;

}  // namespace myo
