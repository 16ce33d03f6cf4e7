#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace myo::model {

struct Model;

/// Inertia of all nodes: of one coordinate where it is the same along every direction, and what acts along some only.
struct MassMatrix {
    Eigen::SparseMatrix<double> isotropic;    // n x n [kg]; it also weighs
    Eigen::SparseMatrix<double> directional;  // 3n x 3n [kg], row 3 i + r, symmetric, without weight; 0 x 0: none

    Eigen::VectorXd nodal_kg;  // sums of the isotropic rows: what weighs at each node

    bool has_directional() const { return directional.size() > 0; }
};
MassMatrix mass_matrix(Eigen::SparseMatrix<double> isotropic, Eigen::SparseMatrix<double> directional);

/// The body's mass by its mass model, attached masses on the diagonal, and the directional masses active at a time.
MassMatrix mass_matrix(const Model& model, double at_s = 0.0);

/// A mass until a time, from where the span before it ends.
struct MassSpan {
    double until_s = 0.0;
    MassMatrix mass;
};
/// The masses of a model's runs, which begin at t = 0, one after the other, the last for ever: more than one where
/// directional masses begin or end later on.
std::vector<MassSpan> mass_spans(const Model& model);
/// The number of the span in which a time lies.
std::size_t span_at(const std::vector<MassSpan>& spans, double at_s);

/// M X for nodal vectors X (3 x n).
Eigen::Matrix3Xd times_mass(const Eigen::Matrix3Xd& X, const MassMatrix& mass);

/// result += D X for nodal fields X, rows 3 p ... 3 p + 2 of which are field p (3 P x n), and a matrix D like
/// MassMatrix::directional.
void add_directional(const Eigen::SparseMatrix<double>& directional, const Eigen::Ref<const Eigen::MatrixXd>& X,
                     Eigen::Ref<Eigen::MatrixXd> result);

}  // namespace myo::model
