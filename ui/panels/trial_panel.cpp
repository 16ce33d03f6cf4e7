#include "panels/trial_panel.hpp"

#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "mesh/surface_mesh.hpp"
#include "panels/declared_list.hpp"
#include "panels/declared_rows.hpp"
#include "panels/load_time_rows.hpp"
#include "toml/toml_text.hpp"

namespace myo::ui::panels {
namespace {

/// Values of what is added, for the user to change: small enough for soft bodies of centimetres.
struct NewTrialPolicy {
    double duration_s = 1.0;
    double shortest_s = 0.01;  // of a trial
    double force_N = 0.1;
    double mass_kg = 0.01;
};
constexpr NewTrialPolicy new_trial_policy;

/// Index of the shown trial in the declaration.
std::size_t index_of(const commands::WorkbenchState& state) { return static_cast<std::size_t>(state.trial); }

/// Key within a table of the declaration.
toml::TomlPath inside(toml::TomlPath table, const char* key) {
    table.emplace_back(key);
    return table;
}

/// A name that no trial has.
std::string free_name(const commands::Scene& scene, const std::string& wanted) {
    const auto taken = [&](const std::string& name) {
        return std::any_of(scene.trials.begin(), scene.trials.end(),
                           [&](const commands::SceneTrial& trial) { return trial.name == name; });
    };
    std::string name = wanted;
    for (int k = 2; taken(name); ++k) name = wanted + "_" + std::to_string(k);
    return name;
}

/// The end of the body that is farther from its support, where loads usually act.
Box far_end(const commands::Scene& scene) {
    const BodyEnd end = free_end(scene);
    return end_box(mesh::bounding_box(scene.surface.vertices), end.axis, end.upper);
}

}  // namespace

void TrialPanel::draw(PanelContext& context) {
    draw_list(context);
    draw_trial(context);
    draw_loads(context);
}

void TrialPanel::draw_list(PanelContext& context) {
    const commands::Scene& scene = *context.state.scene;
    std::vector<commands::Choice> choices;
    for (const commands::SceneTrial& trial : scene.trials)
        choices.push_back({trial.name, trial.name, "Role: " + trial.role + "."});
    std::string chosen = scene.trials[index_of(context.state)].name;
    // Trials are listed by name, and chosen by index.
    if (choice_row(context, "Trial", "trial/shown", "The trial that is shown, and edited below.", choices, chosen))
        for (std::size_t t = 0; t < scene.trials.size(); ++t)
            if (scene.trials[t].name == chosen) context.emit(commands::ChooseTrial{static_cast<int>(t)});
    const float third = (ImGui::GetContentRegionAvail().x - 2.0f * ImGui::GetStyle().ItemSpacing.x) / 3.0f;
    if (ImGui::Button("Add", {third, 0.0f})) {
        context.emit(commands::EditDeclaration{
            {commands::AppendDeclared{{"trial"},
                                      "name = " + toml::toml_text(free_name(scene, "planned")) +
                                          "\nrole = \"simulate\"\nduration_s = " +
                                          toml::toml_number(new_trial_policy.duration_s) + "\nstart = \"straight\"\n"}},
            "trial/add"});
        // Executed after the edit, when the new trial is the last one.
        context.emit(commands::ChooseTrial{static_cast<int>(scene.trials.size())});
    }
    context.items.mark("trial/add");
    tooltip(context.theme, "Adds a trial without a recording, which is only simulated.");
    ImGui::SameLine();
    // The copy has the recording and the loads of the shown trial, but another name.
    if (ImGui::Button("Duplicate", {third, 0.0f}))
        context.emit(commands::EditDeclaration{
            {commands::DuplicateDeclared{{"trial", index_of(context.state)}, free_name(scene, chosen)}},
            "trial/duplicate"});
    context.items.mark("trial/duplicate");
    ImGui::SameLine();
    // An experiment has at least one trial.
    ImGui::BeginDisabled(scene.trials.size() < 2);
    if (ImGui::Button("Remove", {third, 0.0f}))
        context.emit(
            commands::EditDeclaration{{commands::RemoveDeclared{{"trial", index_of(context.state)}}}, "trial/remove"});
    ImGui::EndDisabled();
    context.items.mark("trial/remove");
    tooltip(context.theme, "Removes the shown trial from the experiment. Its recording stays on the disk.");
}

void TrialPanel::draw_trial(PanelContext& context) {
    const commands::SceneTrial& trial = context.state.scene->trials[index_of(context.state)];
    const toml::TomlPath path{"trial", index_of(context.state)};
    row_label(context.theme, "Name", "Names the trial's results.");
    const bool mine = named_trial_ == context.state.trial;
    std::string name = mine ? typed_name_ : trial.name;
    if (ImGui::InputText("##trial_name", &name)) typed_name_ = name, named_trial_ = context.state.trial;
    context.items.mark("trial/name");
    if (ImGui::IsItemDeactivatedAfterEdit() && name != trial.name)
        context.emit(commands::EditDeclaration{{commands::SetDeclared{inside(path, "name"), toml::toml_text(name)}},
                                               "trial/name"});
    // Once the field is left, it shows the name of the state again: the edit may have been refused.
    if (!ImGui::IsItemActive()) named_trial_ = -1;
    // A trial without a recording has no role to choose, and no recording to cut.
    if (trial.role != "simulate") draw_role(context);
    if (trial.repairs.possible) draw_recording_end(context);
    // A recording has its own duration.
    if (!(trial.duration_s > 0.0)) return;
    double duration_s = trial.duration_s;
    bool goes_on = false;
    const NumberField field{"Duration",
                            "trial/duration",
                            commands::Dimension::time,
                            "s",
                            "Simulated time of a trial without a recording [s].",
                            {new_trial_policy.shortest_s, 3600.0},
                            0.01};
    if (number_row(context, field, edits_, duration_s, goes_on))
        context.emit(commands::EditDeclaration{
            {commands::SetDeclared{inside(path, "duration_s"), toml::toml_number(duration_s)}}, field.name, goes_on});
}

/// What a recording is for.
void TrialPanel::draw_role(PanelContext& context) {
    const commands::SceneTrial& trial = context.state.scene->trials[index_of(context.state)];
    std::string chosen = trial.role;
    const std::vector<commands::Choice> roles{
        {"fit", "Fit", "Its recording is fitted by Calibrate and Diagnose."},
        {"validate", "Validate", "Its recording is predicted only: it tests what was fitted to the others."}};
    if (choice_row(context, "Role", "trial/role", "What the recording is used for.", roles, chosen) &&
        chosen != trial.role)
        context.emit(commands::EditDeclaration{
            {commands::SetDeclared{{"trial", index_of(context.state), "role"}, toml::toml_text(chosen)}},
            "trial/role"});
}

/// The declared end is a time of the recording, the shown one is of the trial.
void TrialPanel::draw_recording_end(PanelContext& context) {
    const commands::SceneTrial& trial = context.state.scene->trials[index_of(context.state)];
    if (trial.time_s.size() == 0) return;
    double end_s = trial.time_s(trial.time_s.size() - 1);
    bool goes_on = false;
    const NumberField field{"Used until",
                            "trial/end",
                            commands::Dimension::time,
                            "s",
                            "Time of the trial [s] after which the recording is not used: runs, fits and diagnoses end "
                            "there. A time behind its last sample takes all of it.",
                            {new_trial_policy.shortest_s, 3600.0},
                            0.01};
    if (number_row(context, field, edits_, end_s, goes_on, trial.name))
        context.emit(
            // The field shows times of the trial; the declaration counts from the beginning of the recording.
            commands::EditDeclaration{{commands::SetDeclared{inside({"trial", index_of(context.state)}, "end_s"),
                                                             toml::toml_number(end_s + trial.repairs.start_s)}},
                                      field.name,
                                      goes_on});
}

void TrialPanel::draw_loads(PanelContext& context) {
    const commands::Scene& scene = *context.state.scene;
    const commands::SceneTrial& trial = scene.trials[index_of(context.state)];
    heading(context.theme, "Loads");
    if (trial.loads.empty()) muted_text(context.theme, "The weight of the body alone acts in this trial.");
    // Loads have no names; their place in the list identifies them, also for the highlight in the view.
    for (std::size_t l = 0; l < trial.loads.size(); ++l) {
        const commands::SceneLoad& load = trial.loads[l];
        const std::string item = "trial/load/" + std::to_string(l);
        const toml::TomlPath path{"trial", index_of(context.state), "load", l};
        const std::string title = (load.is_mass ? "Mass " : "Force ") + std::to_string(l + 1);
        const char* const tip = load.is_mass ? "A mass glued to the surface: weight and inertia."
                                             : "A force of fixed direction.";
        if (item_heading(context, {item, title, tip, "Remove the load"}) == ItemPress::removed)
            context.emit(commands::EditDeclaration{{commands::RemoveDeclared{path}}, item + "/remove"});
        if (!is_open(context, item)) continue;
        // A mass acts all along, as weight and as inertia; only a force has a course over time.
        if (load.is_mass) {
            double mass_kg = load.mass_kg;
            bool goes_on = false;
            const NumberField field{
                "Amount", item + "/mass", commands::Dimension::mass, "g", "Mass [kg].", {0.0, 100.0}, 0.1};
            if (number_row(context, field, edits_, mass_kg, goes_on))
                context.emit(commands::EditDeclaration{
                    {commands::SetDeclared{inside(path, "mass_kg"), toml::toml_number(mass_kg)}}, field.name, goes_on});
        } else {
            const NumberField field{"",          "",   commands::Dimension::force, "N", "Component of the force [N].",
                                    {-1e4, 1e4}, 0.005};
            vector_rows(context, {inside(path, "force_N"), item + "/force"}, "F", field, edits_, load.force_N);
            load_time_rows(context, load, path, item, edits_);
        }
        // Both act on the surface in a box, which can be dragged in the view or picked.
        box_rows(context, {inside(path, "box_m"), item + "/box"}, edits_, load.box_m);
        pick_box_button(context, {inside(path, "box_m"), item + "/box"}, "the face that carries the load");
    }
    const float half = (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x) / 2.0f;
    const toml::TomlPath array{"trial", index_of(context.state), "load"};
    // A new load is declared at the free end; its box is then moved or picked.
    const std::string box = "box_m = " + box_text(far_end(scene)) + "\n";
    const std::string added = "trial/load/" + std::to_string(trial.loads.size());
    if (ImGui::Button("Add a force", {half, 0.0f})) {
        context.emit(commands::EditDeclaration{
            {commands::AppendDeclared{array, "kind = \"force\"\n" + box + "force_N = " +
                                                 toml::toml_vector({0.0, 0.0, -new_trial_policy.force_N}) + "\n"}},
            "trial/add_force"});
        open_item(context, added);
    }
    context.items.mark("trial/add_force");
    tooltip(context.theme, "Spread by area over the surface in a box, at first the free end of the body.");
    ImGui::SameLine();
    if (ImGui::Button("Add a mass", {half, 0.0f})) {
        context.emit(commands::EditDeclaration{
            {commands::AppendDeclared{
                array, "kind = \"mass\"\n" + box + "mass_kg = " + toml::toml_number(new_trial_policy.mass_kg) + "\n"}},
            "trial/add_mass"});
        open_item(context, added);
    }
    context.items.mark("trial/add_mass");
}

}  // namespace myo::ui::panels
