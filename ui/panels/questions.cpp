#include "panels/questions.hpp"

#include <imgui.h>

#include "panels/escape.hpp"
#include "panels/file_dialogs.hpp"
#include "panels/widgets.hpp"
#include "panels/wrapped_text.hpp"

namespace myo::ui::panels {
namespace {

/// Buttons of equal width next to each other.
class ButtonRow {
public:
    /// @param count  of the buttons that add() will draw
    ButtonRow(PanelContext& context, int count)
        : context_(context),
          width_((ImGui::GetContentRegionAvail().x - static_cast<float>(count - 1) * ImGui::GetStyle().ItemSpacing.x) /
                 static_cast<float>(count)) {}

    /// Draws the next button. Returns true if it was pressed.
    bool add(const char* label, const char* item, bool primary = false) {
        if (!first_) ImGui::SameLine();
        first_ = false;
        const bool pressed = primary ? primary_button(context_.theme, label, {width_, 0.0f})
                                     : ImGui::Button(label, {width_, 0.0f});
        context_.items.mark(item);
        return pressed;
    }

private:
    PanelContext& context_;
    float width_;
    bool first_ = true;
};

// Each question: a dialog whose answer is emitted as a command; the state then no longer asks. Escape cancels what
// asked.
void ask_unit(PanelContext& context) {
    if (!begin_dialog(context.theme, "Unit of the file", 400.0f)) return;
    wrapped_text(context.state.unit_question->filename().string() +
                 " does not state the unit of its numbers. Which unit is it?");
    ImGui::Spacing();
    // Empty until a button is pressed; an answer without a unit cancels the opening.
    std::optional<commands::AnswerUnit> answer;
    ButtonRow row(context, 3);
    if (row.add("Cancel", "unit/cancel") || escape_closes()) answer = commands::AnswerUnit{};
    if (row.add("Metres", "unit/m")) answer = commands::AnswerUnit{1.0};
    if (row.add("Millimetres", "unit/mm", true)) answer = commands::AnswerUnit{1e-3};
    if (answer) {
        context.emit(*answer);
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

/// The dialog for the file name takes its place while a project without a name is being saved.
void ask_unsaved(PanelContext& context) {
    if (!begin_dialog(context.theme, "Unsaved changes", 440.0f)) return;
    const std::string name = context.state.project.empty() ? context.state.scene->name
                                                           : context.state.project.filename().string();
    wrapped_text(name + " has changes that are not saved.");
    ImGui::Spacing();
    // Cancel drops what was wanted; the other answers continue with it.
    std::optional<commands::UnsavedAnswer> answer;
    ButtonRow row(context, 3);
    if (row.add("Cancel", "unsaved/cancel") || escape_closes()) answer = commands::UnsavedAnswer::cancel;
    if (row.add("Don't save", "unsaved/discard")) answer = commands::UnsavedAnswer::discard;
    if (row.add("Save", "unsaved/save", true)) answer = commands::UnsavedAnswer::save;
    if (answer) {
        context.emit(commands::AnswerUnsaved{*answer});
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

// Also used to find out whether the dialog is open.
constexpr const char* stop_title = "A job is still running";

/// The default is to keep the job running, as its results would be lost.
void ask_to_stop(PanelContext& context) {
    if (!begin_dialog(context.theme, stop_title, 440.0f)) return;
    const std::string name = context.state.job ? context.state.job->name : "A job";
    wrapped_text(name + " has not ended" + (context.state.queue.empty() ? "." : ", and others wait.") +
                 " Its results so far are lost when the window closes.");
    ImGui::Spacing();
    std::optional<bool> stops;
    ButtonRow row(context, 2);
    if (row.add("Stop and quit", "stop/quit")) stops = true;
    if (row.add("Keep running", "stop/keep", true) || escape_closes()) stops = false;
    if (stops) context.emit(commands::AnswerStop{*stops});
    // The job may have ended while the dialog was open.
    if (stops || !context.state.asks_to_stop) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

/// The file browser takes its place until something is found.
void ask_missing(PanelContext& context) {
    if (!begin_dialog(context.theme, "Experiment not found", 480.0f)) return;
    const commands::MissingSource& missing = *context.state.missing;
    wrapped_text(missing.project.filename().string() + " belongs to " + missing.source.string() +
                 ", which is not there. It may have been moved or renamed.");
    ImGui::Spacing();
    ButtonRow row(context, 2);
    if (row.add("Cancel", "missing/cancel") || escape_closes()) {
        // An empty answer drops the opening.
        context.emit(commands::Locate{});
        ImGui::CloseCurrentPopup();
    }
    if (row.add("Locate\xe2\x80\xa6", "missing/locate", true)) {
        // The state keeps the question; cancelling the file browser answers it.
        context.window.file = locate_dialog(missing);
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

/// One recovery file after the other, the newest first.
void ask_recovery(PanelContext& context) {
    if (!begin_dialog(context.theme, "Unsaved work found", 480.0f)) return;
    const std::size_t count = context.state.recovered.size();
    wrapped_text(
        "Myoloop ended unexpectedly. Unsaved work can be recovered: " + context.state.recovered_words.back() + "." +
        (count > 1
             ? " There are " + std::to_string(count) +
                   " unsaved projects; this is the newest. Those not discarded are offered again at the next start."
             : ""));
    ImGui::Spacing();
    // No way to postpone: until the work is recovered or discarded, nothing else may be opened.
    bool decided = false;
    ButtonRow row(context, 2);
    if (row.add("Discard", "recovery/discard")) {
        context.emit(commands::DiscardRecovery{});
        decided = true;
    }
    if (row.add("Recover", "recovery/recover", true)) {
        context.emit(commands::Recover{context.state.recovered.back()});
        decided = true;
    }
    if (decided) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

}  // namespace

void draw_questions(PanelContext& context) {
    // One question at a time. Recovered work comes first, as it decides whether anything else is opened.
    const commands::WorkbenchState& state = context.state;
    if (!state.recovered.empty())
        ask_recovery(context);
    else if (state.unit_question)
        ask_unit(context);
    else if (state.missing)
        ask_missing(context);
    else if (state.pending && !state.asks_where_to_save)
        ask_unsaved(context);
    else if (state.asks_to_stop || ImGui::IsPopupOpen(stop_title))
        ask_to_stop(context);
}

}  // namespace myo::ui::panels
