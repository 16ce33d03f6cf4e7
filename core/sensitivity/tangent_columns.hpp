#pragma once

#include <Eigen/Core>

#include <utility>
#include <vector>

#include "model/block_pattern.hpp"
#include "model/force_columns.hpp"
#include "model/mass_matrix.hpp"

namespace myo::sensitivity {

/// The free unknowns of nodal fields, unknowns x fields, and back; clamped nodes are zero.
Eigen::MatrixXd gather_columns(const model::BlockPattern& pattern, const model::NodalColumns& fields);
model::NodalColumns scatter_columns(const model::BlockPattern& pattern, const Eigen::MatrixXd& unknowns);

/// times_mass() of all fields.
model::NodalColumns mass_times(const model::NodalColumns& fields, const model::MassMatrix& mass);

/// The sum of factor times field; empty fields are zero.
using FieldTerms = std::vector<std::pair<double, const Eigen::MatrixXd*>>;
Eigen::MatrixXd sum_of(const FieldTerms& terms);

}  // namespace myo::sensitivity
