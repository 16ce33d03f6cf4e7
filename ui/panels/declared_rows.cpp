#include "panels/declared_rows.hpp"

#include <imgui.h>

#include <utility>

#include "commands/place_text.hpp"
#include "mesh/surface_mesh.hpp"
#include "toml/toml_text.hpp"

namespace myo::ui::panels {
namespace {

/// Size of a box around an end of the body, relative to the body.
struct EndBoxPolicy {
    double depth = 0.01;   // of an end, over the length of the body: the layer of cells that a support holds
    double margin = 0.01;  // around the body, over its length, so that rounding leaves nothing outside
};
constexpr EndBoxPolicy end_box_policy;

/// Emits a value of the declaration. `item`: name of the edit; `text`: TOML.
void emit_value(PanelContext& context, const DeclaredPlace& place, const std::string& item, std::string text,
                bool goes_on) {
    context.emit(commands::EditDeclaration{{commands::SetDeclared{place.path, std::move(text)}}, item, goes_on});
}

}  // namespace

void vector_rows(PanelContext& context, const DeclaredPlace& place, const std::string& label, const NumberField& field,
                 NumberEdits& edits, const Eigen::Vector3d& value) {
    for (Eigen::Index k = 0; k < 3; ++k) {
        NumberField row = field;
        const std::string axis = axis_names[static_cast<std::size_t>(k)];
        row.label = label + " " + axis;
        row.name = place.name + "/" + axis;
        Eigen::Vector3d changed = value;
        bool goes_on = false;
        if (number_row(context, row, edits, changed(k), goes_on))
            emit_value(context, place, row.name, toml::toml_vector(changed), goes_on);
    }
}

void box_rows(PanelContext& context, const DeclaredPlace& place, NumberEdits& edits, const Box& value) {
    // Offers the box to the view, where BoxTool draws its handles in the next frame.
    context.window.boxes.push_back({place.path, place.name, value});
    for (Eigen::Index k = 0; k < 3; ++k)
        for (const bool upper : {false, true}) {
            const std::string axis = axis_names[static_cast<std::size_t>(k)];
            const NumberField row{axis + (upper ? " to" : " from"),
                                  place.name + "/" + axis + (upper ? "_to" : "_from"),
                                  commands::Dimension::length,
                                  "mm",
                                  "Side of the box in the frame of the mesh [m].",
                                  {-10.0, 10.0},
                                  0.05};
            Box changed = value;
            bool goes_on = false;
            if (number_row(context, row, edits, (upper ? changed.highest : changed.lowest)(k), goes_on))
                emit_value(context, place, row.name, box_text(changed), goes_on);
        }
}

void pick_box_button(PanelContext& context, const DeclaredPlace& place, const std::string& what) {
    const bool picks = context.placing.sets_box(place.path);
    ImGui::BeginDisabled(!context.state.body);
    if (toggle_button(context.theme, "Pick in the view##" + place.name, picks)) {
        // A second press ends the picking; a press during another tool takes its place.
        context.placing = {};
        if (!picks) {
            context.placing.kind = Placing::Kind::box;
            context.placing.box = place.path;
            context.placing.item = place.name;
            context.placing.what = what;
        }
    }
    ImGui::EndDisabled();
    context.items.mark(place.name + "/pick");
    tooltip(context.theme, context.state.body ? "Click " + what +
                                                    ": a thin box around this face of the body is declared. The part "
                                                    "it holds is shown before the click."
                                              : "Build the mesh first.");
}

std::string box_text(const Box& box) {
    return "[" + commands::place_text(box.lowest) + ", " + commands::place_text(box.highest) + "]";
}

Box end_box(const Box& body, int axis, bool upper) {
    // The layer is thin along the axis and reaches beyond the body across it.
    const double length = body.size()(axis), margin = end_box_policy.margin * body.size().maxCoeff();
    Box box{body.lowest.array() - margin, body.highest.array() + margin};
    (upper ? box.lowest : box.highest)(axis) = upper ? body.highest(axis) - end_box_policy.depth * length
                                                     : body.lowest(axis) + end_box_policy.depth * length;
    return box;
}

BodyEnd free_end(const commands::Scene& scene) {
    const Box body = mesh::bounding_box(scene.surface.vertices);
    BodyEnd end;
    body.size().maxCoeff(&end.axis);
    // A clamp whose sides are reversed holds nothing, so that the longest axis decides.
    if (!scene.clamp_m || (scene.clamp_m->lowest.array() > scene.clamp_m->highest.array()).any()) return end;
    const Eigen::Vector3d middle = 0.5 * (body.lowest + body.highest);
    // The support lies off the middle most along one axis; the free end is the opposite one.
    const Eigen::Vector3d held = 0.5 * (scene.clamp_m->lowest + scene.clamp_m->highest) - middle;
    held.cwiseAbs().maxCoeff(&end.axis);
    end.upper = held(end.axis) < 0.0;
    return end;
}

}  // namespace myo::ui::panels
