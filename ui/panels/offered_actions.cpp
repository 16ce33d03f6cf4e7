#include "panels/offered_actions.hpp"

#include <algorithm>

#include "commands/field_store.hpp"

namespace myo::ui::panels {
namespace {

using Perform = std::function<void(PanelContext&, viewport::ViewportState&)>;

/// Opens a file that is known now.
Perform opens(const std::filesystem::path& path) {
    return [path](PanelContext& context, viewport::ViewportState&) {
        context.emit(commands::Open{path, std::nullopt});
    };
}

/// Ids contain the path, so that they are unique in the palette.
void add_files(std::vector<Action>& all, const commands::WorkbenchState& state) {
    for (const commands::Example& example : state.examples)
        all.push_back(
            {"example/" + example.path.filename().string(), "Example", example.name, {}, opens(example.path)});
    for (const std::filesystem::path& path : state.preferences.recent)
        all.push_back({"recent/" + path.string(), "Open recent", path.string(), {}, opens(path)});
}

/// Selects a trial of the open scene.
void add_trials(std::vector<Action>& all, const commands::WorkbenchState& state) {
    if (!state.scene) return;
    for (std::size_t t = 0; t < state.scene->trials.size(); ++t) {
        const int trial = static_cast<int>(t);
        all.push_back(
            {"trial/" + state.scene->trials[t].name,
             "Trial",
             state.scene->trials[t].name,
             {},
             [trial](PanelContext& context, viewport::ViewportState&) { context.emit(commands::ChooseTrial{trial}); }});
    }
}

/// Titles begin with an icon, which the user cannot type.
std::string without_icon(const std::string& title) {
    const auto letter = std::find_if(title.begin(), title.end(),
                                     [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); });
    return {letter, title.end()};
}

/// Shows a panel below the view. Panels at the side are reached through their task.
void add_panels(std::vector<Action>& all, const commands::WorkbenchState& state,
                const std::vector<std::unique_ptr<Panel>>& panels) {
    if (!state.scene) return;
    for (const auto& panel : panels) {
        if (panel->place() != PanelPlace::strip || !panel->offered(state)) continue;
        all.push_back(
            {"panel/" + panel->name(),
             "Below the view",
             without_icon(panel->title()),
             {},
             [name = panel->name()](PanelContext& context, viewport::ViewportState&) { context.window.panel = name; }});
    }
}

/// Fields that need a run or a diagnosis are listed, but disabled until it exists.
void add_fields(std::vector<Action>& all, const commands::WorkbenchState& state, const commands::Backend& backend) {
    if (!state.scene) return;
    const auto colours = [](const std::string& field) {
        return [field](PanelContext& context, viewport::ViewportState&) {
            commands::ViewOptions view = context.state.view;
            view.field = field;
            context.emit(commands::ChangeView{view});
        };
    };
    for (const commands::FieldKind& kind : commands::field_kinds(backend)) {
        Action action{"field/" + kind.id, "Colour by", kind.label, {}, colours(kind.id)};
        action.enabled = [kind](const commands::WorkbenchState& s) { return commands::needed_for(kind, s).empty(); };
        all.push_back(std::move(action));
    }
    // Removes the colours.
    all.push_back({"field/none", "Colour by", "none", {}, colours("")});
}

}  // namespace

std::vector<Action> offered_actions(const commands::WorkbenchState& state, const commands::Backend& backend,
                                    const std::vector<std::unique_ptr<Panel>>& panels) {
    std::vector<Action> all;
    add_trials(all, state);
    add_panels(all, state, panels);
    add_fields(all, state, backend);
    add_files(all, state);
    return all;
}

}  // namespace myo::ui::panels
