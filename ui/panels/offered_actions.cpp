#include "panels/offered_actions.hpp"

#include <algorithm>

#include "commands/field_store.hpp"
#include "help/manual_pages.hpp"

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

/// Shows a panel below the view, or one at the side with its task.
void add_panels(std::vector<Action>& all, const commands::WorkbenchState& state,
                const std::vector<std::unique_ptr<Panel>>& panels) {
    if (!state.scene) return;
    for (const auto& panel : panels) {
        if (!panel->offered(state)) continue;
        const bool below = panel->place() == PanelPlace::strip;
        all.push_back(
            {"panel/" + panel->name(),
             below ? "Below the view" : std::string("Panel of ") + commands::task_title(*panel->task()),
             without_icon(panel->title()),
             {},
             [name = panel->name()](PanelContext& context, viewport::ViewportState&) { context.window.panel = name; }});
    }
}

/// A tool of the view whose clicks declare something, with the task that has its panel.
struct PlacingTool {
    const char* id;
    const char* label;
    commands::Task task;
    Placing::Kind kind;
};
// Tools that have no menu entry; their panels switch them on, too.
constexpr PlacingTool placing_tools[] = {
    {"tool/markers", "Place markers and probes", commands::Task::measure, Placing::Kind::markers},
    {"tool/tendon", "Draw a tendon", commands::Task::fibres, Placing::Kind::guides},
    {"tool/chamber", "Pick the wall of a chamber", commands::Task::fibres, Placing::Kind::cavity}};

/// Tools of the view: those of the menus, and those that panels switch on.
void add_tools(std::vector<Action>& all, const commands::WorkbenchState& state) {
    if (!state.scene) return;
    // Tools that have a menu entry, under the word by which they are sought.
    for (const Action& action : all_actions())
        for (const char* id : {"view.distance", "edit.paint", "edit.erase"})
            if (action.id == id) {
                all.push_back(action);
                all.back().id = std::string("tool/") + id;
                all.back().menu = "Tool";
            }
    for (const PlacingTool& tool : placing_tools) {
        Action action{tool.id, "Tool", tool.label, {}, [tool](PanelContext& context, viewport::ViewportState&) {
                          context.placing = {};
                          context.placing.kind = tool.kind;
                          context.window.task = tool.task;
                      }};
        // Places are declared in an experiment, on a mesh.
        action.enabled = [](const commands::WorkbenchState& s) { return s.body && s.scene->is_experiment; };
        all.push_back(std::move(action));
    }
}

/// Pages of the manual.
void add_pages(std::vector<Action>& all) {
    for (const help::ManualPage& page : help::manual_pages)
        all.push_back({std::string("page/") + page.name,
                       "Help",
                       std::string("Manual: ") + page.title,
                       {},
                       [name = page.name](PanelContext& context, viewport::ViewportState&) {
                           context.window.help = HelpRequest{HelpRequest::Part::manual, name, ""};
                       }});
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
    add_tools(all, state);
    add_fields(all, state, backend);
    add_pages(all);
    add_files(all, state);
    return all;
}

}  // namespace myo::ui::panels
