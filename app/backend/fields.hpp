#pragma once

#include <memory>

#include "commands/backend.hpp"
#include "model/model.hpp"

namespace myo::backend {

/// Models of the trials of a run, all on one mesh; fields are evaluated on them.
struct RunModels {
    // In the order of the run's trials; those that did not run may be without a body.
    std::vector<model::Model> trials;
};

/// Names, units and explanations of all fields, in the order of the window's list.
const std::vector<ui::commands::FieldKind>& field_catalogue();

/// Values of a field at the nodes of the displayed mesh in one frame.
///
/// @param id     of a field of the catalogue
/// @param trial  index of the trial in the run
/// @param frame  index of the stored frame
/// @return       one value per node [SI]; empty if the id is unknown or the run has no model on this mesh
Eigen::VectorXd field_values(const std::string& id, const ui::commands::MeshedBody& body,
                             const ui::commands::RunResult& run, std::size_t trial, std::size_t frame);

}  // namespace myo::backend
