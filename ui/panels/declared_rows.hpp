#pragma once

#include <Eigen/Core>

#include <string>

#include "base/box.hpp"
#include "panels/number_field.hpp"

// Rows that edit the experiment's declaration. An edit is emitted as EditDeclaration; the row's name is that of the
// edit, for undo.

namespace myo::ui::panels {

/// A place where a number or vector of the declaration stands.
struct DeclaredPlace {
    toml::TomlPath path;  // keys and indices: {"trial", 0, "load", 1, "box_m"}
    std::string name;     // item name for tests, without the coordinate
};

/// Three rows for a vector in SI units. `label`: "Force"; `field`: unit and limits of a component, its label and name
/// are ignored.
void vector_rows(PanelContext& context, const DeclaredPlace& place, const std::string& label, const NumberField& field,
                 NumberEdits& edits, const Eigen::Vector3d& value);

/// Six rows for the corners of a box [m], in mm. While they are shown, its sides can be dragged in the view.
void box_rows(PanelContext& context, const DeclaredPlace& place, NumberEdits& edits, const Box& value);

/// Button that lets the user click a face of the body, around which the box is then declared. Needs a meshed body.
///
/// @param what  "the face that is held"
void pick_box_button(PanelContext& context, const DeclaredPlace& place, const std::string& what);

/// TOML text of a box.
std::string box_text(const Box& box);

/// Thin box at the end of the body along an axis, for a support or a load.
///
/// @param body   box around the body at rest [m]
/// @param axis   0 to 2
/// @param upper  the end with the larger coordinate
Box end_box(const Box& body, int axis, bool upper);

/// An end of the body along an axis.
struct BodyEnd {
    int axis = 0;
    bool upper = true;  // the one with the larger coordinate
};
/// The end that is farther from the support; without support the upper end of the longest axis.
BodyEnd free_end(const commands::Scene& scene);

}  // namespace myo::ui::panels
