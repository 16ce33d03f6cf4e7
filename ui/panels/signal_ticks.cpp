#include "panels/signal_ticks.hpp"

#include <imgui.h>

#include <algorithm>

#include "commands/sought_signals.hpp"
#include "panels/widgets.hpp"

namespace myo::ui::panels {
namespace {

/// Emits the edit; nothing is declared of an actuator that is sought.
void set_sought(PanelContext& context, const commands::SignalChoice& choice, bool sought) {
    const std::string item = "fit/seek/" + choice.name;
    if (!choice.declared.empty()) {
        toml::TomlPath path = choice.declared;
        path.emplace_back("sought");
        if (sought)
            context.emit(commands::EditDeclaration{{commands::RemoveDeclared{path}}, item});
        else
            context.emit(commands::EditDeclaration{{commands::SetDeclared{path, "false"}}, item});
        return;
    }
    commands::Settings settings = context.state.settings;
    const auto muscle = std::find_if(settings.muscles.begin(), settings.muscles.end(),
                                     [&](const commands::Muscle& each) { return each.name == choice.name; });
    muscle->sought = sought;
    context.emit(commands::ChangeSettings{std::move(settings), item});
}

}  // namespace

void draw_signal_ticks(PanelContext& context) {
    ImGui::Indent();
    for (const commands::SignalChoice& choice :
         commands::signal_choices(*context.state.scene, context.state.settings)) {
        bool sought = choice.sought;
        if (ImGui::Checkbox((choice.name + "##seek/signal").c_str(), &sought)) set_sought(context, choice, sought);
        context.items.mark("fit/seek/signal/" + choice.name);
        tooltip(context.theme, "Without the tick, its signal stays as it is in the trial.");
    }
    ImGui::Unindent();
}

}  // namespace myo::ui::panels
