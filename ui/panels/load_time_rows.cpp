#include "panels/load_time_rows.hpp"

#include <imgui.h>

#include <cmath>

#include "commands/curve_text.hpp"
#include "panels/curve_rows.hpp"
#include "toml/toml_text.hpp"

namespace myo::ui::panels {
namespace {

/// Ids of the ways in which a force acts over time.
const char* const constant_id = "constant";
const char* const window_id = "window";
const char* const curve_id = "curve";

/// Values of a new window, for the user to change.
struct NewWindowPolicy {
    double from_s = 0.0;
    double until_s = 0.5;
    double longest_s = 3600.0;  // largest time of a field
};
constexpr NewWindowPolicy new_window_policy;

/// Key within a table of the declaration.
toml::TomlPath inside(toml::TomlPath table, const char* key) {
    table.emplace_back(key);
    return table;
}

/// Id of the way that is declared. An open end of a window is infinite.
const char* id_of(const commands::SceneLoad& load) {
    if (load.curve) return curve_id;
    return std::isfinite(load.from_s) || std::isfinite(load.until_s) ? window_id : constant_id;
}

/// Replaces what says when the force acts.
void set_kind(PanelContext& context, const std::string& kind, const toml::TomlPath& path, const std::string& item) {
    std::vector<commands::DeclarationEdit> edits;
    // A window and a curve exclude each other, so the keys of both are removed first.
    for (const char* key : {"from_s", "until_s", "curve"}) edits.push_back(commands::RemoveDeclared{inside(path, key)});
    if (kind == window_id) {
        edits.push_back(commands::SetDeclared{inside(path, "from_s"), toml::toml_number(new_window_policy.from_s)});
        edits.push_back(commands::SetDeclared{inside(path, "until_s"), toml::toml_number(new_window_policy.until_s)});
    } else if (kind == curve_id) {
        edits.push_back(commands::SetDeclared{inside(path, "curve"), commands::curve_text(new_curve(1.0))});
    }
    context.emit(commands::EditDeclaration{std::move(edits), item + "/when"});
}

/// One end of the window; without it a button that adds it.
void end_row(PanelContext& context, const commands::SceneLoad& load, const toml::TomlPath& path,
             const std::string& item, bool starts, NumberEdits& edits) {
    double time_s = starts ? load.from_s : load.until_s;
    const toml::TomlPath place = inside(path, starts ? "from_s" : "until_s");
    const std::string name = item + (starts ? "/from" : "/until");
    // An end that is not declared is open: the force acts all along on that side.
    if (!std::isfinite(time_s)) {
        if (ImGui::Button(((starts ? "Let it start at a time##" : "Let it end at a time##") + item).c_str(),
                          {-1.0f, 0.0f}))
            context.emit(commands::EditDeclaration{
                {commands::SetDeclared{
                    place, toml::toml_number(starts ? new_window_policy.from_s : new_window_policy.until_s)}},
                name});
        context.items.mark(name);
        return;
    }
    const double longest = new_window_policy.longest_s;
    bool goes_on = false;
    const NumberField field{
        starts ? "From" : "Until",
        name,
        commands::Dimension::time,
        "s",
        starts ? "Time of the trial at which the force starts [s]." : "Time of the trial at which the force ends [s].",
        {-longest, longest},
        0.005};
    if (number_row(context, field, edits, time_s, goes_on))
        context.emit(
            commands::EditDeclaration{{commands::SetDeclared{place, toml::toml_number(time_s)}}, name, goes_on});
}

}  // namespace

void load_time_rows(PanelContext& context, const commands::SceneLoad& load, const toml::TomlPath& path,
                    const std::string& item, NumberEdits& edits) {
    const std::vector<commands::Choice> choices{
        {constant_id, "Constant", "All along, also before the start."},
        {window_id, "Within a window", "From one time to another."},
        {curve_id, "By a curve", "The force is multiplied by a factor that changes over time."}};
    std::string chosen = id_of(load);
    const std::string before = chosen;
    if (choice_row(context, "Acts", item + "/when", "When the force acts.", choices, chosen) && chosen != before)
        set_kind(context, chosen, path, item);
    // The rows follow the state: those of a new way appear in the next frame.
    if (before == window_id)
        for (const bool starts : {true, false}) end_row(context, load, path, item, starts, edits);
    if (before != curve_id) return;
    const NumberField factor{"Factor",
                             item + "/curve",
                             commands::Dimension::ratio,
                             "",
                             "Factor on the components of the force.",
                             {-1000.0, 1000.0},
                             0.005};
    if (const auto edit = curve_rows(context, factor, edits, *load.curve, item))
        context.emit(
            commands::EditDeclaration{{commands::SetDeclared{inside(path, "curve"), commands::curve_text(edit->curve)}},
                                      item + "/curve",
                                      edit->goes_on});
}

}  // namespace myo::ui::panels
