#pragma once

#include <Eigen/Core>

#include <utility>
#include <vector>

#include "model/block_pattern.hpp"
#include "model/force_columns.hpp"
#include "model/mass_matrix.hpp"

namespace myo::sensitivity {

/// Free unknowns of nodal fields, unknowns x fields.
Eigen::MatrixXd gather_columns(const model::BlockPattern& pattern, const model::NodalColumns& fields);
/// Inverse of gather_columns(); clamped nodes are zero.
model::NodalColumns scatter_columns(const model::BlockPattern& pattern, const Eigen::MatrixXd& unknowns);

/// M times each field; empty if `fields` is empty.
model::NodalColumns mass_times(const model::NodalColumns& fields, const model::MassMatrix& mass);

/// Terms of a linear combination: (factor, field).
using FieldTerms = std::vector<std::pair<double, const Eigen::MatrixXd*>>;
/// Sum of factor times field. Empty fields count as zero; empty result if all are.
Eigen::MatrixXd sum_of(const FieldTerms& terms);

}  // namespace myo::sensitivity
