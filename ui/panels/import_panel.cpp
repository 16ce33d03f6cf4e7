#include "panels/import_panel.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "panels/file_dialogs.hpp"
#include "panels/tables.hpp"
#include "platform/fonts.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {
namespace {

/// Units of length that a recording may have.
const std::vector<commands::Choice> units{{"mm", "mm", ""}, {"cm", "cm", ""}, {"dm", "dm", ""},
                                          {"m", "m", ""},   {"um", "um", ""}, {"inch", "inch", ""}};
constexpr std::array<double, 6> unit_lengths{1e-3, 1e-2, 1e-1, 1.0, 1e-6, 0.0254};  // metres, in the order of `units`

/// An axis with its sign: "+x". `axis` is 1, 2 or 3, negative for the opposite direction.
std::string axis_label(int axis) { return std::string(axis > 0 ? "+" : "\xe2\x88\x92") + "xyz"[std::abs(axis) - 1]; }

/// Millimetres with two decimals: markers are not placed more accurately than that.
std::string fixed_mm(double metres) {
    char text[40];
    std::snprintf(text, sizeof text, "%.2f", 1e3 * metres);
    return text;
}

/// Draws a row with two alternatives. Returns true if the other one was selected.
bool either_row(PanelContext& context, const char* label, const std::string& name, const char* tip, const char* first,
                const char* second, bool& is_first) {
    row_label(context.theme, label, tip);
    const bool before = is_first;
    if (tab(context.theme, (std::string(first) + "##" + name).c_str(), is_first)) is_first = true;
    context.items.mark(name + "/first");
    tooltip(context.theme, tip);
    ImGui::SameLine();
    if (tab(context.theme, (std::string(second) + "##" + name).c_str(), !is_first)) is_first = false;
    context.items.mark(name + "/second");
    tooltip(context.theme, tip);
    return is_first != before;
}

/// Dialog that chooses the folder of the new experiment.
///
/// @param scene  path of the open body: the folder is proposed next to it
FileDialog new_folder_dialog(const commands::ImportChoices& choices, const std::filesystem::path& scene) {
    FileDialog dialog;
    dialog.title = "A new folder for the experiment";
    dialog.button = "Choose";
    dialog.start = choices.folder.empty() ? scene.parent_path() : choices.folder;
    dialog.new_name = choices.folder.empty() ? choices.trial + "_experiment" : choices.folder.filename().string();
    dialog.chosen = [](PanelContext& context, const std::filesystem::path& path) {
        if (!context.state.import) return;  // the import was closed while the dialog was open
        commands::ImportChoices chosen = context.state.import->choices;
        chosen.folder = path;
        context.emit(commands::ChangeImport{chosen});
    };
    return dialog;
}

/// Unit of the lengths in the file.
void unit_row(PanelContext& context, commands::ReadingOptions& reading) {
    // No unit is chosen for the user; a wrong one would go unnoticed.
    std::string unit = "choose\xe2\x80\xa6";
    for (std::size_t u = 0; u < units.size(); ++u)
        if (reading.metres_per_unit == unit_lengths[u]) unit = units[u].id;
    if (choice_row(context, "Unit", "import/unit", "Unit of lengths; not stated in the file", units, unit))
        for (std::size_t u = 0; u < units.size(); ++u)
            if (units[u].id == unit) reading.metres_per_unit = unit_lengths[u];
}

/// The axis of the cameras along which the body's axis k points.
void axis_choice(PanelContext& context, std::size_t k, float width, commands::ImportChoices& choices) {
    if (k > 0) ImGui::SameLine();
    ImGui::SetNextItemWidth(width);
    const std::string item = std::string("import/axis_") + "xyz"[k];
    const bool open = ImGui::BeginCombo(("##" + item).c_str(), axis_label(choices.axes[k]).c_str(),
                                        ImGuiComboFlags_NoArrowButton);
    context.items.mark(item);
    tooltip(context.theme, std::string("The body's ") + "xyz"[k] + " points along this axis of the cameras.");
    if (!open) return;
    // Both signs of each axis.
    for (const int axis : {1, -1, 2, -2, 3, -3}) {
        if (ImGui::Selectable(axis_label(axis).c_str(), choices.axes[k] == axis) && choices.axes[k] != axis) {
            // The axis that was selected here moves to where the new one was, so that the three stay different.
            for (int& other : choices.axes)
                if (std::abs(other) == std::abs(axis)) other = std::abs(choices.axes[k]) * (other > 0 ? 1 : -1);
            choices.axes[k] = axis;
        }
        context.items.mark(item + "/" + std::to_string(axis));
    }
    ImGui::EndCombo();
}

/// Buttons that assign labels to markers: by a proposal, or by clicks on the body.
void draw_assigning(PanelContext& context) {
    const commands::RecordingImport& import = *context.state.import;
    const platform::Theme& theme = context.theme;
    const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    if (ImGui::Button("Propose", {width, 0.0f})) context.emit(commands::ProposeMarkers{});
    context.items.mark("import/propose");
    tooltip(
        theme,
        "Matches labels to markers by their names and by the distances between them. On a plain mesh: assigns labels "
        "that were not clicked to the nearest place on the body.");
    ImGui::SameLine();
    // The button is a toggle: its colour shows whether clicks place labels.
    ImGui::PushStyleColor(ImGuiCol_Button, import.placing ? theme.accent : theme.raised);
    ImGui::PushStyleColor(ImGuiCol_Text, import.placing ? theme.on_accent : theme.text);
    ImGui::BeginDisabled(!context.state.body);
    if (ImGui::Button("Click on the body", {width, 0.0f}))
        context.emit(commands::ChooseLabel{import.label, !import.placing});
    context.items.mark("import/place");
    ImGui::EndDisabled();
    ImGui::PopStyleColor(2);
    tooltip(theme, import.declared.empty()
                       ? "While on, a click on the body places the selected label and selects the next one."
                       : "While on, a click on one of the experiment's markers (rings in the view) assigns it to "
                         "the selected label and selects the next one.");
}

}  // namespace

/// All parts edit one copy of the choices. One command at the end replaces them, so that a frame never sees half of a
/// change.
void ImportPanel::draw(PanelContext& context) {
    const commands::RecordingImport& import = *context.state.import;
    commands::ImportChoices choices = import.choices;
    draw_file(context);
    heading(context.theme, "Frame");
    draw_placing(context, choices);
    heading(context.theme, "Markers");
    draw_markers(context, choices);
    heading(context.theme, "Start");
    draw_start(context, choices);
    heading(context.theme, "Trial");
    draw_trial(context, choices);
    if (!(choices == import.choices)) context.emit(commands::ChangeImport{choices});
}

/// Unit and rate are asked only if the file does not contain them.
void ImportPanel::draw_file(PanelContext& context) {
    const commands::RecordingFile& file = context.state.import->file;
    const measurement::Recording& recording = *file.recording;
    text_row(context.theme, "File", file.path.filename().string());
    // Facts that identify the recording: format, labels, samples, rate and duration.
    char text[160];
    std::snprintf(text, sizeof text, "%s, %zu labels, %lld samples, %.4g Hz, %.4g s", file.format.c_str(),
                  recording.labels.size(), static_cast<long long>(recording.sample_count()), recording.rate_Hz,
                  recording.time_s[recording.time_s.size() - 1] - recording.time_s[0]);
    text_row(context.theme, "Content", text);
    commands::ReadingOptions reading = file.reading;
    // The unit is a property of the file, so changing it reads the file again.
    if (file.asks_unit) {
        unit_row(context, reading);
    }
    bool goes_on = false;
    if (file.asks_rate)
        number_row(context,
                   {"Rate",
                    "import/rate",
                    commands::Dimension::frequency,
                    "Hz",
                    "Samples per second; not stated in the file",
                    {1.0, 1e5},
                    1.0,
                    "rate"},
                   edit_, reading.rate_Hz, goes_on);
    if (file.asks_rate) {
        // Files without a rate are plain tables, some of which write zeros where a marker was not seen.
        row_label(context.theme, "0, 0, 0");
        ImGui::Checkbox("is a gap##import", &reading.zero_is_occluded);
        context.items.mark("import/zero");
    }
    // Reading is a job: while another one runs, the change is offered again in the next frame.
    if (!(reading == file.reading) && !context.state.busy()) context.emit(commands::ReadRecording{file.path, reading});
}

/// Without rotation by markers, the three axis lists alone determine the rotation.
void ImportPanel::draw_placing(PanelContext& context, commands::ImportChoices& choices) {
    const commands::ImportView& view = context.state.import->view;
    row_label(context.theme, "Axes x, y, z", "Which axis of the cameras the body's x, y and z point along");
    const float width = (ImGui::GetContentRegionAvail().x - 2.0f * ImGui::GetStyle().ItemSpacing.x) / 3.0f;
    for (std::size_t k = 0; k < 3; ++k) {
        axis_choice(context, k, width, choices);
    }
    row_label(context.theme, "Turn",
              "Three or more markers that are not collinear determine the cameras' frame (Kabsch 1976)");
    ImGui::Checkbox("by the markers##import", &choices.turns);
    context.items.mark("import/turns");
    tooltip(context.theme,
            "Three or more markers that are not collinear determine the cameras' frame relative to the body: the rigid "
            "motion with the least squares of their distances (Kabsch 1976). Otherwise the axes above determine it.");
    muted_text(context.theme, view.placed_by + (std::isfinite(view.rms_m)
                                                    ? " They are " + fixed_mm(view.rms_m) + " mm rms from their places."
                                                    : ""));
}

void ImportPanel::draw_name(PanelContext& context, std::size_t label, commands::ImportChoices& choices) {
    commands::ImportedMarker& marker = choices.markers[label];
    const std::vector<commands::SceneMarker>& declared = context.state.import->declared;
    const std::string item = "import/marker/" + context.state.import->file.recording->labels[label];
    ImGui::SetNextItemWidth(-1.0f);
    // A plain mesh has no declared markers, so their names are free.
    if (declared.empty()) {
        if (ImGui::InputTextWithHint("##name", "left out", &marker.name))
            marker.name = commands::marker_name(marker.name);
        context.items.mark(item);
        return;
    }
    const bool open = ImGui::BeginCombo("##name", marker.name.empty() ? "left out" : marker.name.c_str(),
                                        ImGuiComboFlags_NoArrowButton);
    context.items.mark(item);
    if (!open) return;
    // Labels without a marker are not imported: reflections, or markers on other objects.
    if (ImGui::Selectable("left out", marker.name.empty())) marker = {};
    context.items.mark(item + "/none");
    for (const commands::SceneMarker& own : declared) {
        if (ImGui::Selectable(own.name.c_str(), own.name == marker.name))
            commands::assign_marker(choices, label, own.name);
        context.items.mark(item + "/" + own.name);
    }
    ImGui::EndCombo();
}

void ImportPanel::draw_label_row(PanelContext& context, std::size_t i, commands::ImportChoices& choices) {
    const commands::RecordingImport& import = *context.state.import;
    const platform::Theme& theme = context.theme;
    const std::string& label = import.file.recording->labels[i];
    ImGui::PushID(static_cast<int>(i));
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    // The selected label is also the one that clicks in the view assign.
    const bool chosen = static_cast<int>(i) == import.label;
    const float own_width = ImGui::GetContentRegionAvail().x;
    if (ImGui::Selectable(elided(label, ImGui::GetContentRegionAvail().x).c_str(), chosen,
                          ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap)) {
        context.emit(commands::ChooseLabel{static_cast<int>(i), import.placing});
        // The plots of the selected label are below the view.
        context.window.panel = "recording";
    }
    // Another column may cover the middle of the row, so tests get only its first cell.
    context.items.add("import/label/" + label,
                      {ImGui::GetItemRectMin(), {ImGui::GetItemRectMin().x + own_width, ImGui::GetItemRectMax().y}});
    tooltip(theme, label);
    ImGui::TableNextColumn();
    draw_name(context, i, choices);
    const double seen = 100.0 * import.file.seen[i], off = import.view.residual_m[static_cast<Eigen::Index>(i)];
    // below 80 % the marker is occluded often
    number_cell(theme, plot::value_label(seen, 3), seen < 80.0 ? &theme.warning : nullptr);
    number_cell(theme, std::isfinite(off) ? fixed_mm(off) : dash);
    ImGui::PopID();
}

/// A row per label with its marker, the share of samples in which it was seen, and its distance from the marker before
/// the start.
void ImportPanel::draw_markers(PanelContext& context, commands::ImportChoices& choices) {
    const platform::Theme& theme = context.theme;
    const std::vector<Heading> headings{{"Label", ""},
                                        {"Marker", ""},
                                        {"seen [%]", "Share of the samples in which the cameras saw it", true},
                                        {"off [mm]", "Distance from the place of the marker before the start", true}};
    if (begin_side_table("labels", 4)) {
        ImGui::TableSetupColumn("label", ImGuiTableColumnFlags_WidthStretch);
        ImGui::TableSetupColumn("marker", ImGuiTableColumnFlags_WidthStretch);
        number_column(theme, headings[2]);
        number_column(theme, headings[3]);
        heading_row(theme, headings);
        for (std::size_t i = 0; i < choices.markers.size(); ++i) {
            draw_label_row(context, i, choices);
        }
        ImGui::EndTable();
    }
    draw_assigning(context);
}

/// The start can be typed, dragged in the plot, set to the first large motion, or found by comparison with a run.
void ImportPanel::draw_start(PanelContext& context, commands::ImportChoices& choices) {
    const commands::RecordingImport& import = *context.state.import;
    const Eigen::VectorXd& time = import.file.recording->time_s;
    bool goes_on = false;
    number_row(context,
               {"t = 0 is at",
                "import/start",
                commands::Dimension::time,
                "s",
                "Time in the file at which the trial begins. The line in the plot below can be dragged, too.",
                {time[0], time[time.size() - 1]},
                1e-3,
                "start"},
               edit_, choices.start_s, goes_on);
    const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    // Disabled if the recording shows no motion that stands out.
    ImGui::BeginDisabled(!import.file.start_s);
    if (ImGui::Button("First motion", {width, 0.0f})) choices.start_s = *import.file.start_s;
    ImGui::EndDisabled();
    context.items.mark("import/first_motion");
    tooltip(context.theme, import.file.start_message);
    ImGui::SameLine();
    ImGui::BeginDisabled(!context.state.run);
    if (ImGui::Button("Align to the run", {width, 0.0f})) context.emit(commands::AlignImport{});
    ImGui::EndDisabled();
    context.items.mark("import/align");
    tooltip(context.theme, context.state.run
                               ? "Sets the start at which displacements agree best with the shown run: the "
                                 "greatest cross-correlation over all markers"
                               : "Run first, then align the recording with the simulation.");
}

/// A plain mesh has no experiment that the trial could be added to, so a folder for a new one has to be chosen.
void ImportPanel::draw_trial(PanelContext& context, commands::ImportChoices& choices) {
    const bool new_one = !context.state.scene->is_experiment;
    row_label(context.theme, "Name");
    ImGui::InputText("##trial", &choices.trial);
    context.items.mark("import/name");
    either_row(context, "Role", "import/role",
               "Trials of role fit are used in fits; trials of role validate are predicted only.", "fit", "validate",
               choices.fit);
    either_row(
        context, "Begins", "import/begins",
        "Straight: held in the rest shape and released at t = 0. At rest: in equilibrium under gravity, loads and "
        "muscles.",
        "straight", "at rest", choices.straight);
    row_label(context.theme, "Target",
              new_one ? "A plain mesh becomes an experiment in its own folder."
                      : "The trial is added to the open experiment or to a copy of it.");
    // The button shows the present target.
    const std::string place = !choices.folder.empty() ? choices.folder.filename().string()
                              : new_one               ? "New folder\xe2\x80\xa6"
                                                      : "This experiment";
    if (ImGui::Button(
            (elided(place, ImGui::GetContentRegionAvail().x - 2.0f * ImGui::GetStyle().FramePadding.x) + "##folder")
                .c_str(),
            {ImGui::GetContentRegionAvail().x, 0.0f}))
        context.window.file = new_folder_dialog(choices, context.state.scene->path);
    context.items.mark("import/folder");
    tooltip(context.theme, choices.folder.empty() ? "Choose a new folder" : choices.folder.string());
}

/// The reason why the trial cannot be added yet is shown above the buttons.
void draw_import_controls(PanelContext& context) {
    const commands::RecordingImport& import = *context.state.import;
    const std::string& problem = import.view.problem;
    muted_text(context.theme,
               elided_lines(problem.empty() ? "Ready to add." : problem, ImGui::GetContentRegionAvail().x, 2));
    tooltip(context.theme, problem);
    const float width = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    ImGui::BeginDisabled(!problem.empty() || context.state.busy());
    if (primary_button(context.theme, "Add the trial", {width, 0.0f})) context.emit(commands::AddRecording{});
    ImGui::EndDisabled();
    context.items.mark("import/add");
    ImGui::SameLine();
    if (ImGui::Button("Cancel", {width, 0.0f})) context.emit(commands::CancelImport{});
    context.items.mark("import/cancel");
}

}  // namespace myo::ui::panels
