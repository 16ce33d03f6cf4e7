#include "panels/limit_rows.hpp"

#include <imgui.h>

#include <algorithm>
#include <array>

#include "commands/units.hpp"
#include "panels/widgets.hpp"
#include "platform/fonts.hpp"
#include "toml/toml_text.hpp"

namespace myo::ui::panels {
namespace {

/// A limit of a kind of command.
struct LimitKind {
    const char* key;  // in [limits]
    const char* label;
    const char* tip;
    commands::Dimension dimension;
    const char* unit;
    double most;         // largest that can be typed [SI]
    double first;        // of a new limit, for the user to change [SI]
    double smallest_SI;  // least value, and least step of a drag
};
// Largest value, first value and smallest one, in SI units.
constexpr std::array limit_kinds{
    LimitKind{"pressure_Pa", "Pressure up to",
              "Largest pressure that Optimise may use [kPa]. The chamber is then only blown up, unless a trial of the "
              "experiment has a vacuum. Without a limit it may be evacuated as well.",
              commands::Dimension::pressure, "kPa", 1e7, 5e4, 100.0},
    LimitKind{"tension_N", "Tension up to", "Largest tension of a tendon that Optimise may use [N].",
              commands::Dimension::force, "N", 1e4, 10.0, 0.05},
    LimitKind{"shortening_m", "Shortening up to", "Largest shortening of a tendon that Optimise may use [mm].",
              commands::Dimension::length, "mm", 10.0, 0.02, 1e-4}};

/// Whether the experiment has a chamber, or a tendon with this drive, to which the limit applies.
bool has_kind(const commands::DeclaredParts& parts, const std::string& key) {
    if (key == "pressure_Pa") return !parts.chambers.empty();
    return std::any_of(parts.tendons.begin(), parts.tendons.end(), [&](const commands::DeclaredTendon& tendon) {
        return tendon.by_shortening == (key == "shortening_m");
    });
}

/// Row of one limit, with a button that removes it; without a limit the button that sets one.
void draw_limit(PanelContext& context, const LimitKind& kind, NumberEdits& edits) {
    const commands::DeclaredParts& parts = context.state.scene->declared;
    const auto declared = parts.limits.find(kind.key);
    const toml::TomlPath path{"limits", kind.key};
    const std::string item = std::string("fit/limit/") + kind.key;
    if (declared == parts.limits.end()) {
        row_label(context.theme, kind.label, kind.tip);
        if (ImGui::Button((std::string("No limit: set one##") + kind.key).c_str(), {-1.0f, 0.0f}))
            context.emit(commands::EditDeclaration{{commands::SetDeclared{path, toml::toml_number(kind.first)}}, item});
        context.items.mark(item + "/set");
        tooltip(context.theme, kind.tip);
        return;
    }
    // A declared limit is a number field; its button removes the key, so that no limit holds.
    double value = declared->second;
    bool goes_on = false;
    const NumberField field{kind.label,
                            item,
                            kind.dimension,
                            kind.unit,
                            kind.tip,
                            {kind.smallest_SI, kind.most},
                            kind.smallest_SI / commands::find_unit(kind.dimension, kind.unit)->si()};
    if (number_row(context, field, edits, value, goes_on))
        context.emit(commands::EditDeclaration{{commands::SetDeclared{path, toml::toml_number(value)}}, item, goes_on});
    row_label(context.theme, "");
    if (ImGui::Button((std::string("Without this limit##") + kind.key).c_str(), {-1.0f, 0.0f}))
        context.emit(commands::EditDeclaration{{commands::RemoveDeclared{path}}, item + "/remove"});
    context.items.mark(item + "/remove");
}

}  // namespace

void draw_limit_rows(PanelContext& context, NumberEdits& edits) {
    for (const LimitKind& kind : limit_kinds)
        if (has_kind(context.state.scene->declared, kind.key)) draw_limit(context, kind, edits);
}

}  // namespace myo::ui::panels
