#include "panels/signal_panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "panels/signal_series.hpp"
#include "panels/tables.hpp"
#include "platform/fonts.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {
namespace {

/// Distance to a knot within which the mouse takes it [pixels at scale 1].
constexpr float knot_reach = 9.0f;
constexpr chart::Range min_range{0.9, 1.1};  // always visible, so that a constant signal is not magnified

/// Pixel of a knot in the window.
ImVec2 pixel_of(const plot::PlotArea& area, double time_s, double value) {
    return {static_cast<float>(area.x(time_s)), static_cast<float>(area.y(value))};
}

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

/// List that selects the edited muscle.
void draw_muscle_list(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const commands::Muscle& muscle = *state.chosen_muscle();
    const float s = context.theme.scale;
    ImGui::SetNextItemWidth(std::min(200.0f * s, 0.26f * ImGui::GetContentRegionAvail().x));
    const bool open = ImGui::BeginCombo("##muscle", muscle.name.c_str());
    context.items.mark("signals/muscle");
    if (open) {
        for (int m = 0; m < static_cast<int>(state.settings.muscles.size()); ++m) {
            const std::string& name = state.settings.muscles[static_cast<std::size_t>(m)].name;
            if (ImGui::Selectable(name.c_str(), m == state.muscle)) context.emit(commands::ChooseMuscle{m});
            context.items.mark("signals/muscle/" + name);
        }
        ImGui::EndCombo();
    }
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

/// The knot nearest to the mouse, within reach.
std::optional<std::size_t> knot_at(const plot::PlotArea& area, const fibre::Signal& signal, const ImVec2& mouse,
                                   float within) {
    std::optional<std::size_t> near;
    for (std::size_t k = 0; k < signal.times_s.size(); ++k) {
        const ImVec2 p = pixel_of(area, signal.times_s[k], signal.values[k]);
        const float distance = std::hypot(p.x - mouse.x, p.y - mouse.y);
        if (distance < within) within = distance, near = k;
    }
    return near;
}

/// Time [s] and value a at the mouse. Values are limited to 0.05 … 5, as in the generator.
std::array<double, 2> knot_place(const plot::PlotArea& area, const ImVec2& mouse) {
    return {area.x.value(static_cast<double>(mouse.x)),
            std::clamp(area.y.value(static_cast<double>(mouse.y)), 0.05, 5.0)};
}

/// @param grabbed  the dragged knot, which is larger
/// Draws the knots over the plot, and records them for tests.
///
void draw_knots(PanelContext& context, const plot::PlotArea& area, const fibre::Signal& signal,
                std::optional<std::size_t> grabbed) {
    const platform::Theme& theme = context.theme;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    // Slightly larger than the drawing area, so that knots at its edge are complete.
    ImGui::PushClipRect({area.pixels.lowest.x - 6.0f, area.pixels.lowest.y - 6.0f},
                        {area.pixels.highest.x + 6.0f, area.pixels.highest.y + 6.0f}, true);
    for (std::size_t k = 0; k < signal.times_s.size(); ++k) {
        const ImVec2 p = pixel_of(area, signal.times_s[k], signal.values[k]);
        const float radius = (grabbed && *grabbed == k ? 6.0f : 4.5f) * theme.scale;
        list.AddCircleFilled(p, radius, platform::packed(theme.background), 20);
        list.AddCircle(p, radius, platform::packed(theme.text), 20, 1.6f * theme.scale);
        context.items.add("signals/knot/" + std::to_string(k), {{p.x - 4.0f, p.y - 4.0f}, {p.x + 4.0f, p.y + 4.0f}});
    }
    ImGui::PopClipRect();
}

}  // namespace

std::string SignalPanel::title() const { return std::string(platform::icon::bolt) + "  Signals"; }

/// Controls in one line, the curve below.
void SignalPanel::draw(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    if (!state.chosen_muscle()) {
        if (draw_commands(context)) return;
        muted_text(context.theme, "Signals of muscles are drawn here. Add a muscle under Fibres to begin.");
        return;
    }
    // Another muscle: zoom and grabbed knot belong to the previous one.
    if (followed_ != state.chosen_muscle()->name) {
        followed_ = state.chosen_muscle()->name;
        plot_ = {};
        grabbed_.reset();
    }
    draw_head(context);
    draw_curve(context);
}

void SignalPanel::give_signal(PanelContext& context, std::optional<fibre::Signal> signal, const std::string& what,
                              bool goes_on) {
    commands::Settings settings = context.state.settings;
    settings.muscles[static_cast<std::size_t>(context.state.muscle)].signal = std::move(signal);
    context.emit(commands::ChangeSettings{std::move(settings), what, goes_on});
}

/// Restores the recorded signal, or states that it is the recorded one.
void SignalPanel::draw_recorded(PanelContext& context) {
    if (context.state.chosen_muscle()->signal) {
        if (ImGui::Button("As recorded")) give_signal(context, std::nullopt, "signal as recorded", false);
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
    draw_muscle_list(context);
    ImGui::SameLine();
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
    // The line also has room for the button of the recorded signal.
    const bool narrow = ImGui::GetWindowWidth() < 560.0f * context.theme.scale;
    if (ImGui::Button(narrow ? platform::icon::expand : "Zoom to data")) {
        time_.range.reset();
        plot_ = {};
    }
    context.items.mark("signals/fit");
    tooltip(context.theme,
            "Show the whole signal.\n\nIn the curve, a double click adds a knot, a drag moves it and a right click "
            "removes it. The wheel zooms in time, with Shift in a; a drag off the "
            "knots moves the view, one with the right button zooms to a box.");
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
    plot.held = grabbed_.has_value();
    const plot::PlotResult drawn = plot::draw_plot(plot, ImGui::GetContentRegionAvail(), theme, context.items, time_,
                                                   plot_, hidden_);
    // A muscle that follows another one has no knots: a drag in its plot moves the time, as in other plots.
    if (!plot.editable) {
        if (drawn.cursor) context.emit(commands::SetTime{*drawn.cursor});
        return;
    }
    edit_knots(context, signal, drawn);
}

/// Draws the knots and edits the signal with the mouse.
void SignalPanel::edit_knots(PanelContext& context, const fibre::Signal& signal, const plot::PlotResult& drawn) {
    const plot::PlotArea& area = drawn.area;
    if (area.pixels.width() < 20.0f || area.pixels.height() < 10.0f) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    draw_knots(context, area, signal, grabbed_);
    const std::optional<std::size_t> near = drawn.hovered
                                                ? knot_at(area, signal, mouse, knot_reach * context.theme.scale)
                                                : std::nullopt;
    const auto [time, value] = knot_place(area, mouse);
    // Released, or the plot lost the mouse.
    if (!drawn.active) grabbed_.reset();
    if (drawn.hovered && near && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) {
        grabbed_ = near;
        moved_ = false;
    }
    const ImVec2 by = ImGui::GetIO().MouseDelta;
    // While a knot is dragged, all changes form one undo entry; moved_ marks the first of them.
    if (grabbed_ && *grabbed_ < signal.times_s.size() && (by.x != 0.0f || by.y != 0.0f)) {
        give_signal(context, commands::with_knot_moved(signal, *grabbed_, time, value), "knot of a signal", moved_);
        moved_ = true;
    } else if (drawn.hovered && !near && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
        give_signal(context, commands::with_knot_added(signal, time, value), "knot of a signal", false);
    } else if (drawn.hovered && near && ImGui::IsMouseReleased(ImGuiMouseButton_Right) &&
               ImGui::GetIO().MouseDragMaxDistanceSqr[ImGuiMouseButton_Right] < 16.0f) {
        // A click; a drag with the right button is a zoom to a box.
        give_signal(context, commands::with_knot_removed(signal, *near), "knot of a signal", false);
    }
}

}  // namespace myo::ui::panels
