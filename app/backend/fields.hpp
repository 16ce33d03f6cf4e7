#pragma once

#include <memory>

#include "commands/backend.hpp"
#include "model/model.hpp"

namespace myo::backend {

/// What the fields of a run are made from: the models of its trials, on one mesh.
struct RunModels {
    std::vector<model::Model> trials;
};

const std::vector<ui::commands::FieldKind>& field_catalogue();

/// Values at the nodes [SI]; empty for a run without models or a field that is not in the catalogue.
Eigen::VectorXd field_values(const std::string& id, const ui::commands::MeshedBody& body,
                             const ui::commands::RunResult& run, std::size_t trial, std::size_t frame);

}  // namespace myo::backend
