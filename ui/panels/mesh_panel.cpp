#include "panels/mesh_panel.hpp"

#include <imgui.h>

#include <algorithm>

#include "commands/body_size.hpp"
#include "mesh/cell_traits.hpp"
#include "platform/fonts.hpp"
#include "plot/number_text.hpp"

namespace myo::ui::panels {
namespace {

// Explanations say when to use an element, not how it is built.
const std::vector<commands::Choice>& element_choices() {
    static const std::vector<commands::Choice> choices{
        {"hex8", "Hexahedra (hex8)",
         "Bricks of 8 nodes on a regular grid. Robust for any closed surface; curved sides become steps."},
        {"tet4", "Tetrahedra (tet4)",
         "Linear tetrahedra that follow the surface. Far too stiff for nearly incompressible material: "
         "for comparison only."},
        {"tet10", "Tetrahedra (tet10)", "Quadratic tetrahedra that follow the surface; accurate on coarse meshes."}};
    return choices;
}

}  // namespace

void MeshPanel::draw(PanelContext& context) {
    if (!context.state.scene)
        return muted_text(context.theme, "A body is divided into finite elements here. Open one first.");
    draw_mesh_settings(context);
    draw_report(context);
}

/// Edge length as a number and as a logarithmic slider: its range spans a factor of 40.
void MeshPanel::draw_resolution(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    // A floor, as a scene without a surface has no size until it is meshed.
    const double longest = std::max(commands::body_size(state).maxCoeff(), 1e-3);
    const commands::Limits range{longest / 120.0, longest / 3.0};
    const NumberField field{
        "Edge length",
        "body/edge_length",
        commands::Dimension::length,
        "mm",
        "Target edge length of the elements. Along a side of length L there are about L / edge elements, "
        "adapted so that the body's size is met exactly: half the edge, eight times the elements.",
        range,
        0.05,
        "edge length"};
    commands::Settings settings = state.settings;
    bool goes_on = false;
    if (number_row(context, field, edit_, settings.resolution_m, goes_on))
        context.emit(commands::ChangeSettings{settings, "resolution", goes_on});
    // Both controls edit the same number, so an edit has the same name for undo whichever is used.
    double shown = 1e3 * state.settings.resolution_m;
    if (slider_row(context, "body/resolution", {1e3 * range.lowest, 1e3 * range.highest}, true, slide_, shown,
                   goes_on)) {
        settings.resolution_m = 1e-3 * shown;
        context.emit(commands::ChangeSettings{settings, "resolution", goes_on});
    }
}

/// Numbers of elements and unknowns, counted if the mesh exists, otherwise estimated.
void MeshPanel::draw_mesh_size(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    const bool built = state.mesh_is_current();
    const double elements = built ? static_cast<double>(state.body->mesh.cell_count()) : state.prediction.elements;
    const double dofs = built ? state.body->dofs : state.prediction.dofs;
    const std::string about = built || state.prediction.exact ? "" : "\xe2\x89\x88 ";
    const ImVec4* color = dofs > 3e5 ? &theme.warning : nullptr;  // a step takes seconds beyond this size
    text_row(theme, "Elements, DOF", about + with_separators(elements) + ", " + about + with_separators(dofs), color);
    tooltip(theme,
            "Degrees of freedom: three displacements for each node. Orange above 300,000, where a step takes seconds.");
    draw_step_cost(context, dofs);
}

/// Element type first, as the size of the mesh and its cost follow from it and from the edge length.
void MeshPanel::draw_mesh_settings(PanelContext& context) {
    const commands::WorkbenchState& state = context.state;
    const platform::Theme& theme = context.theme;
    std::string element = to_string(state.settings.element);
    if (choice_row(context, "Elements", "body/element", "Shape of the finite elements.", element_choices(), element)) {
        commands::Settings settings = state.settings;
        settings.element = mesh::find_cell_type(element).value_or(settings.element);
        context.emit(commands::ChangeSettings{settings, "element", false});
    }
    draw_resolution(context);
    draw_mesh_size(context);
    // The button disappears when the mesh is up to date.
    if (!state.mesh_is_current()) {
        if (primary_button(theme, "Build this mesh", {-1.0f, 0.0f})) context.emit(commands::BuildMesh{});
        context.items.mark("body/build");
    }
}

/// The prediction states where it comes from, as it may be wrong by a factor of two.
void MeshPanel::draw_step_cost(PanelContext& context, double dofs) {
    const commands::WorkbenchState& state = context.state;
    if (!(dofs > 0.0)) return;
    const auto milliseconds = [](double seconds) { return plot::value_label(1e3 * seconds, 3) + " ms"; };
    const commands::StepPrediction predicted = commands::predict_step(state.preferences.step_costs,
                                                                      state.settings.element, dofs);
    // A run of exactly this mesh needs no extrapolation.
    const bool same = predicted.measured && predicted.from.dofs == dofs &&
                      predicted.from.element == state.settings.element;
    // The row names the measurement that the number is derived from.
    const std::string source = predicted.measured ? milliseconds(predicted.from.seconds) + " measured at " +
                                                        with_separators(predicted.from.dofs) + " DOF"
                                                  : "from the benchmark";
    text_row(context.theme, "Per time step",
             same ? milliseconds(predicted.from.seconds) + " measured"
                  : "\xe2\x89\x88 " + milliseconds(predicted.seconds) + "; " + source);
    context.items.mark("body/step_cost");
    const std::string carried = " scaled to another size by\nt \xe2\x88\xbc DOF^p, p = " +
                                plot::value_label(predicted.exponent, 3) +
                                (predicted.fitted ? ", fitted to this machine's runs with these elements."
                                                  : ", as measured with hexahedra of small and large bodies.");
    tooltip(context.theme,
            (predicted.measured
                 ? "Wall time of the newest run on this machine over the steps of all its trials," + carried
                 : "No run on this machine yet. README's benchmark, " + milliseconds(predicted.from.seconds) + " at " +
                       with_separators(predicted.from.dofs) + " DOF," + carried + "\nThe first run measures it.") +
                "\nOther elements, steps, materials or a busy machine change it: expect a factor of two.");
}

void MeshPanel::draw_report(PanelContext& context) {
    if (!context.state.body) return;
    const commands::MeshedBody& body = *context.state.body;
    heading(context.theme, "Mesh report");
    context.items.mark("body/report");
    text_row(context.theme, "Elements",
             with_separators(static_cast<double>(body.mesh.cell_count())) + " " + to_string(body.mesh.type));
    text_row(context.theme, "Nodes", with_separators(static_cast<double>(body.mesh.node_count())));
    text_row(context.theme, "DOF", with_separators(body.dofs));
    tooltip(context.theme, "Degrees of freedom: three displacements for each node, those of held nodes included.");
    for (const commands::ReportLine& line : body.report) {
        text_row(context.theme, line.label, line.value, line.warning ? &context.theme.warning : nullptr);
        tooltip(context.theme, line.explanation);
    }
}

}  // namespace myo::ui::panels
