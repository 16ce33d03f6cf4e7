#include "panels/signal_panel.hpp"

#include <imgui.h>

#include <algorithm>

#include "panels/signal_series.hpp"
#include "panels/tables.hpp"
#include "platform/fonts.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {
namespace {

constexpr chart::Range min_range{0.9, 1.1};           // always visible, so that a constant signal is not magnified
constexpr commands::Limits stretch_knots{0.05, 5.0};  // of the target stretch, as in the generator

/// Whether the line of buttons has room for icons alone.
bool is_narrow(const PanelContext& context) { return ImGui::GetWindowWidth() < 560.0f * context.theme.scale; }

/// Folder of the experiment, as the start of the file dialogs.
std::filesystem::path folder_of(const commands::Scene& scene) {
    return scene.path.has_extension() ? scene.path.parent_path() : scene.path;
}

/// Dialog that reads a signal into the muscle that is selected now.
FileDialog import_dialog(const commands::WorkbenchState& state) {
    FileDialog dialog;
    dialog.title = "Import the signal of " + state.chosen_muscle()->name;
    dialog.button = "Import";
    dialog.endings = {".csv"};
    dialog.start = folder_of(*state.scene);
    dialog.chosen = [muscle = state.muscle](PanelContext& context, const std::filesystem::path& path) {
        context.emit(commands::ImportSignal{muscle, path});
    };
    return dialog;
}

/// Dialog that writes the signal which is shown now.
FileDialog export_dialog(const commands::WorkbenchState& state) {
    const commands::Muscle& muscle = *state.chosen_muscle();
    FileDialog dialog;
    dialog.title = "Export the signal of " + muscle.name;
    dialog.button = "Export";
    dialog.endings = {".csv"};
    dialog.start = folder_of(*state.scene);
    dialog.new_name = muscle.name + ".csv";
    // The signal is stored now: the muscle may change while the dialog is open.
    dialog.chosen = [name = muscle.name, signal = commands::signal_of(state, muscle)](
                        PanelContext& context, const std::filesystem::path& path) {
        context.emit(commands::ExportSignal{name, signal, path});
    };
    return dialog;
}

/// Signals of all muscles over the time of the trial and of the signal, at least a tenth of a second.
plot::Plot signals_plot(const PanelContext& context, const commands::Muscle& muscle, const fibre::Signal& signal) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    const std::array<double, 2> trial = commands::time_span(state);
    const chart::Range span{std::min(trial[0], signal.times_s.front()),
                            std::max({trial[1], signal.times_s.back(), signal.times_s.front() + 0.1})};
    plot::Plot plot;
    plot.id = "plot/signal";
    plot.panel.y = {.label = "target stretch a", .include = {min_range.lowest, min_range.highest}};
    plot.cursor = state.time_s;
    plot.legend = state.settings.muscles.size() > 1;
    plot.editable = muscle.follows.empty();
    // Signals of the other muscles, for comparison.
    for (const commands::Muscle& other : state.settings.muscles) {
        if (other.name == muscle.name) continue;
        // Faint, so that the edited curve stands out.
        ImVec4 faint = theme.muscle(other.color);
        faint.w = 0.45f;
        plot.panel.series.push_back(signal_series(other.name, commands::signal_of(state, other), span, faint));
    }
    plot.panel.series.push_back(signal_series(muscle.name, signal, span, theme.muscle(muscle.color)));
    return plot;
}

}  // namespace

std::string SignalPanel::title() const { return std::string(platform::icon::bolt) + "  Signals"; }

/// Controls in one line, the curves below.
void SignalPanel::draw(PanelContext& context) {
    const commands::Muscle* const muscle = context.state.chosen_muscle();
    const bool commands = has_commands(context.state);
    if (!muscle && !commands) {
        muted_text(context.theme, "Signals of muscles are drawn here. Add a muscle under Fibres to begin.");
        return;
    }
    const bool show_commands = commands && (!muscle || commands_chosen_);
    // Another muscle: zoom and grabbed knot belong to the previous one.
    if (const std::string shown = show_commands ? "" : muscle->name; followed_ != shown) {
        followed_ = shown;
        plot_ = {};
        knots_.forget();
    }
    if (muscle) {
        draw_list(context, show_commands);
        ImGui::SameLine();
    }
    if (show_commands) return draw_commands(context);
    draw_head(context);
    draw_curve(context);
}

/// List that selects what is edited: a muscle, or the commands of the trial.
void SignalPanel::draw_list(PanelContext& context, bool commands) {
    const commands::WorkbenchState& state = context.state;
    const char* const of_commands = "Chambers and tendons";
    const float s = context.theme.scale;
    ImGui::SetNextItemWidth(std::min(200.0f * s, 0.26f * ImGui::GetContentRegionAvail().x));
    const bool open = ImGui::BeginCombo("##muscle", commands ? of_commands : state.chosen_muscle()->name.c_str());
    context.items.mark("signals/muscle");
    if (!open) return;
    for (int m = 0; m < static_cast<int>(state.settings.muscles.size()); ++m) {
        const std::string& name = state.settings.muscles[static_cast<std::size_t>(m)].name;
        if (ImGui::Selectable((name + "##muscle").c_str(), !commands && m == state.muscle)) {
            commands_chosen_ = false;
            context.emit(commands::ChooseMuscle{m});
        }
        context.items.mark("signals/muscle/" + name);
    }
    if (has_commands(state)) {
        ImGui::Separator();
        if (ImGui::Selectable(of_commands, commands)) commands_chosen_ = true;
        context.items.mark("signals/commands");
    }
    ImGui::EndCombo();
}

void SignalPanel::give_signal(PanelContext& context, std::optional<fibre::Signal> signal, const std::string& what,
                              bool goes_on) {
    commands::Settings settings = context.state.settings;
    settings.muscles[static_cast<std::size_t>(context.state.muscle)].signal = std::move(signal);
    context.emit(commands::ChangeSettings{std::move(settings), what, goes_on});
}

void SignalPanel::draw_zoom(PanelContext& context) {
    if (ImGui::Button(is_narrow(context) ? platform::icon::expand : "Zoom to data")) {
        time_.range.reset();
        plot_ = {};
        command_plots_.clear();
    }
    context.items.mark("signals/fit");
    tooltip(
        context.theme,
        "Show all of the signals.\n\nIn the curve, a double click adds a knot and a drag moves it. The wheel zooms in "
        "time, with Shift in the value; a drag off the knots moves the view, one with the right button zooms to a "
        "box.");
}

/// Restores the recorded signal, or states that it is the recorded one.
void SignalPanel::draw_recorded(PanelContext& context) {
    if (context.state.chosen_muscle()->signal) {
        if (ImGui::Button(is_narrow(context) ? platform::icon::undo : "As recorded"))
            give_signal(context, std::nullopt, "signal as recorded", false);
        context.items.mark("signals/recorded");
        tooltip(context.theme, "Restore each trial's recorded signal");
    } else {
        ImGui::AlignTextToFramePadding();
        const std::string words = "as the trial recorded it; an edit replaces it in all trials";
        ImGui::TextColored(context.theme.muted, "%s", elided(words, ImGui::GetContentRegionAvail().x).c_str());
        tooltip(context.theme, words);
    }
}

/// A muscle that follows another one shows the relation instead of controls. A declared muscle can return to its
/// recorded signals.
void SignalPanel::draw_head(PanelContext& context) {
    const commands::Muscle& muscle = *context.state.chosen_muscle();
    // A muscle that follows another one has no signal to edit.
    if (!muscle.follows.empty()) {
        ImGui::AlignTextToFramePadding();
        ImGui::TextColored(context.theme.muted, "follows %s: its a \xe2\x88\x92 1 times %s", muscle.follows.c_str(),
                           plot::plain_label(muscle.ratio, 3).c_str());
        return;
    }
    draw_generator(context);
    ImGui::SameLine();
    draw_file(context);
    ImGui::SameLine();
    draw_zoom(context);
    ImGui::SameLine();
    knots_.snap_button(context);
    if (muscle.declared.empty()) return;
    ImGui::SameLine();
    draw_recorded(context);
}

/// The file format is a table time_s,<muscle>, linear between rows and constant outside.
void SignalPanel::draw_file(PanelContext& context) {
    const std::string& name = context.state.chosen_muscle()->name;
    if (ImGui::Button("CSV")) ImGui::OpenPopup("signal file");
    context.items.mark("signals/file");
    tooltip(context.theme, "Read or write a table time_s," + name + ": linear between its rows, constant outside them");
    if (!begin_popup_above(context.theme, "signal file", 200.0f)) return;
    // Both entries open a dialog of the window and close the popup.
    const auto choice = [&](const char* label, const char* item,
                            FileDialog (*dialog)(const commands::WorkbenchState&)) {
        const bool pressed = ImGui::Button(label, {-1.0f, 0.0f});
        context.items.mark(item);
        if (!pressed) return;
        context.window.file = dialog(context.state);
        ImGui::CloseCurrentPopup();
    };
    choice("Import\xe2\x80\xa6", "signals/import", import_dialog);
    choice("Export\xe2\x80\xa6", "signals/export", export_dialog);
    ImGui::EndPopup();
}

/// The selected muscle's signal over the signals of the others, which are drawn faintly. An editable plot leaves the
/// left button to the knots.
void SignalPanel::draw_curve(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    const commands::Muscle& muscle = *state.chosen_muscle();
    const fibre::Signal signal = commands::signal_of(state, muscle);
    plot::Plot plot = signals_plot(context, muscle, signal);
    // While a knot is dragged, the plot must not pan.
    plot.held = knots_.held();
    const plot::PlotResult drawn = plot::draw_plot(plot, ImGui::GetContentRegionAvail(), theme, context.items, time_,
                                                   plot_, hidden_);
    // A muscle that follows another one has no knots: a drag in its plot moves the time, as in other plots.
    if (!plot.editable) {
        if (drawn.cursor) context.emit(commands::SetTime{*drawn.cursor});
        return;
    }
    const KnotCurve curve{muscle.name, "signals/knot", signal,    "Target stretch a", commands::Dimension::ratio, "",
                          1.0,         stretch_knots,  theme.text};
    if (const auto edit = knots_.edit(context, {drawn, time_, plot_}, {curve}))
        give_signal(context, edit->signal, "knot of a signal", edit->goes_on);
}

}  // namespace myo::ui::panels
