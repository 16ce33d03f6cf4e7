#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace myo::model {

struct Model;

/// Mass matrix: an isotropic part per coordinate, and a part that acts in some directions only.
struct MassMatrix {
    Eigen::SparseMatrix<double> isotropic;    // n x n [kg]; also defines the weight
    Eigen::SparseMatrix<double> directional;  // 3n x 3n [kg], row 3 i + r, symmetric, without weight; 0 x 0: none

    Eigen::VectorXd nodal_kg;  // row sums of the isotropic part: weight per node

    bool has_directional() const { return directional.size() > 0; }
};
/// Mass matrix from its parts; computes nodal_kg.
MassMatrix mass_matrix(const Eigen::SparseMatrix<double>& isotropic, const Eigen::SparseMatrix<double>& directional);

/// Mass matrix of a model at a time.
///
/// @return  body by its mass model, attached masses lumped on the diagonal, directional masses that are active at
///          `at_s`
MassMatrix mass_matrix(const Model& model, double at_s = 0.0);

/// Mass matrix valid until a time; starts at the end of the previous span.
struct MassSpan {
    double until_s = 0.0;  // [s]; infinite for the last span
    MassMatrix mass;
};
/// Mass matrices of a run from t = 0, in order of time. More than one span if directional masses start or stop later.
std::vector<MassSpan> mass_spans(const Model& model);
/// Span that contains a time.
///
/// @param spans  from mass_spans()
/// @param at_s   [s]; a time at which a span ends belongs to the next one
std::size_t span_at(const std::vector<MassSpan>& spans, double at_s);

/// Product M X for nodal vectors X of 3 x n.
Eigen::Matrix3Xd times_mass(const Eigen::Matrix3Xd& X, const MassMatrix& mass);

/// result += D X for a matrix D like MassMatrix::directional.
/// @param X  nodal fields, 3 P x n; rows 3 p ... 3 p + 2 are field p
void add_directional(const Eigen::SparseMatrix<double>& directional, const Eigen::Ref<const Eigen::MatrixXd>& X,
                     Eigen::Ref<Eigen::MatrixXd> result);

}  // namespace myo::model
