#include "panels/support_panel.hpp"

#include <imgui.h>

#include <array>
#include <cmath>

#include "mesh/surface_mesh.hpp"
#include "panels/declared_rows.hpp"
#include "panels/file_dialogs.hpp"
#include "panels/support_rows.hpp"
#include "toml/toml_text.hpp"

namespace myo::ui::panels {
namespace {

/// Acceleration of free fall that the directions set, as experiments usually state it.
constexpr double standard_gravity_m_s2 = 9.81;

/// The six directions along the axes, and how they are called.
struct AxisDirection {
    const char* id;
    const char* end;        // of the body, that is held
    const char* direction;  // of gravity
    int axis;
    bool upper;
};
constexpr std::array<AxisDirection, 6> directions{{{"x_low", "Low end of x", "Along -x", 0, false},
                                                   {"x_high", "High end of x", "Along +x", 0, true},
                                                   {"y_low", "Low end of y", "Along -y", 1, false},
                                                   {"y_high", "High end of y", "Along +y", 1, true},
                                                   {"z_low", "Low end of z", "Along -z", 2, false},
                                                   {"z_high", "High end of z", "Along +z", 2, true}}};

// Ids of the entries that are no axis.
const char* const other = "other";
const char* const none = "none";

/// The direction along an axis that gravity has; "none" or "other".
std::string gravity_choice(const Eigen::Vector3d& gravity) {
    if (gravity.isZero()) return none;
    for (const AxisDirection& d : directions) {
        const Eigen::Vector3d along = (d.upper ? 1.0 : -1.0) * Eigen::Vector3d::Unit(d.axis);
        if ((gravity.normalized() - along).norm() < 1e-9) return d.id;
    }
    return other;
}

}  // namespace

void SupportPanel::draw(PanelContext& context) {
    if (!context.state.scene->is_experiment) {
        muted_text(context.theme,
                   "A mesh alone is held at the lower end of its longest axis. Make an experiment of it to choose "
                   "support, gravity, loads, chambers, tendons, markers and trials.");
        if (primary_button(context.theme, "Make an experiment\xe2\x80\xa6", {-1.0f, 0.0f}))
            context.window.file = experiment_dialog(context.state.scene->path);
        context.items.mark("support/make");
        return;
    }
    draw_support(context);
    draw_gravity(context);
    // Without edits there is nothing to write.
    if (!context.state.settings.declaration.text) return;
    if (ImGui::Button("Save to the experiment's file", {-1.0f, 0.0f})) context.emit(commands::SaveDeclaration{});
    context.items.mark("support/save");
    tooltip(context.theme, "Writes the changes to experiment.toml. Its comments and its order stay.");
}

void SupportPanel::draw_support(PanelContext& context) {
    const commands::Scene& scene = *context.state.scene;
    heading(context.theme, "Support");
    const Box body = mesh::bounding_box(scene.surface.vertices);
    std::vector<commands::Choice> choices;
    std::string chosen = other;
    // The declaration knows boxes only: the end is recognised by the text of its box.
    const std::string now = scene.clamp_m ? box_text(*scene.clamp_m) : "";
    for (const AxisDirection& d : directions) {
        choices.push_back({d.id, d.end, "Holds the end of the body, one hundredth of its length deep."});
        if (now == box_text(end_box(body, d.axis, d.upper))) chosen = d.id;
    }
    // A reversed box holds nothing.
    const bool clamped = scene.clamp_m && (scene.clamp_m->lowest.array() <= scene.clamp_m->highest.array()).all();
    if (!clamped) chosen = none;
    choices.push_back({none, "None", "Without a clamp the supports below hold the body, or obstacles bear it."});
    choices.push_back({other, "A box of its own", "Holds the material inside the box below."});
    const std::string before = chosen;
    if (choice_row(context, "Held part", "support/end",
                   "Material inside the box does not move; it is drawn in the view.", choices, chosen) &&
        chosen != before) {
        if (chosen == none)
            context.emit(commands::EditDeclaration{{commands::RemoveDeclared{{"clamp"}}}, "support/end"});
        for (const AxisDirection& d : directions)
            if (chosen == d.id)
                context.emit(commands::EditDeclaration{
                    {commands::SetDeclared{{"clamp", "box_m"}, box_text(end_box(body, d.axis, d.upper))}},
                    "support/end"});
    }
    if (clamped) box_rows(context, {{"clamp", "box_m"}, "support/box"}, edits_, *scene.clamp_m);
    pick_box_button(context, {{"clamp", "box_m"}, "support/box"}, "the face that is held");
    draw_supports(context, edits_);
}

void SupportPanel::draw_gravity(PanelContext& context) {
    const Eigen::Vector3d& gravity = context.state.scene->gravity_m_s2;
    heading(context.theme, "Gravity");
    std::vector<commands::Choice> choices;
    for (const AxisDirection& d : directions)
        choices.push_back({d.id, d.direction, "9.81 m/s\xc2\xb2 along the axis."});
    choices.push_back({none, "None", "The body has no weight."});
    choices.push_back({other, "A vector of its own", "The components below."});
    const toml::TomlPath path{"environment", "gravity_m_s2"};
    std::string chosen = gravity_choice(gravity);
    const std::string before = chosen;
    if (choice_row(context, "Direction", "support/gravity", "Direction of the weight in the frame of the mesh.",
                   choices, chosen) &&
        chosen != before && chosen != other) {
        // The entry for a vector of its own changes nothing: the components are typed below.
        Eigen::Vector3d value = Eigen::Vector3d::Zero();
        for (const AxisDirection& d : directions)
            if (chosen == d.id) value = (d.upper ? 1.0 : -1.0) * standard_gravity_m_s2 * Eigen::Vector3d::Unit(d.axis);
        // Adding zero turns negative zeros into zeros, so that the text has none.
        context.emit(commands::EditDeclaration{
            {commands::SetDeclared{path, toml::toml_vector(value + Eigen::Vector3d::Zero())}}, "support/gravity"});
    }
    const NumberField field{"",
                            "",
                            commands::Dimension::acceleration,
                            "m/s\xc2\xb2",
                            "Acceleration g [m/s\xc2\xb2] of the weight, f = M g.",
                            {-1000.0, 1000.0},
                            0.05};
    vector_rows(context, {path, "support/gravity"}, "g", field, edits_, gravity);
}

}  // namespace myo::ui::panels
