#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/decompositions.hpp"
#include "material/catalogue.hpp"
#include "model/internal_forces.hpp"
#include "support/figures.hpp"
#include "support/meshes.hpp"

namespace myo::model {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

MatrixXd matrix_for(const Model& model, const material::Moduli& moduli) {
    Stiffness s;
    s.elastic.assign(model.moduli.size(), moduli);
    InternalInput input;
    input.stiffness = &s;
    return MatrixXd(internal_energy(model, model.body->mesh.nodes, input, HessianKind::exact).hessian)
        .selfadjointView<Eigen::Lower>();
}

/// The smallest value beta > 0 with which every pressure of the cells is balanced by a motion of unit shear energy, on
/// a cube held at one side. K of the bulk modulus is B' V^-1 B, that of the shear modulus the norm of motions: beta^2
/// are the eigenvalues of the one in the other that are not zero. Source: Chapelle & Bathe 1993, "The inf-sup test".
double inf_sup(fem::ElementKind kind, int n) {
    Model model;
    const mesh::VolumeMesh mesh = test::box_mesh(kind, {Vector3d::Zero(), Vector3d::Ones()}, {n, n, n});
    std::vector<int> held;
    for (int i = 0; i < mesh.node_count(); ++i)
        if (mesh.nodes(0, i) < 1e-9) held.push_back(i);
    model.body = make_body(mesh, kind, held);
    model.material = material::neo_hookean();
    model.moduli = uniform_moduli(model.body->cell_count(), 1.0,
                                  0.4999);  // nearly incompressible: what stays at the points goes with mu
    const MatrixXd shear = matrix_for(model, {1.0, 0.0}), bulk = matrix_for(model, {0.0, 1.0});
    const SymmetricEigen S = symmetric_eigen(shear);
    EXPECT_GT(S.values.minCoeff(), 0.0);
    const MatrixXd root = S.vectors * S.values.cwiseSqrt().cwiseInverse().asDiagonal();
    const VectorXd values = symmetric_eigenvalues(root.transpose() * bulk * root);
    return std::sqrt(std::max(0.0, values(values.size() - model.body->cell_count())));
}

/// Bounded away from zero under refinement: the mean volume of quadratic tetrahedra has no spurious pressures.
TEST(InfSup, OfQuadraticTetrahedraWithOnePressurePerCellHasALowerBound) {
    std::vector<double> beta;
    for (const int n : {1, 2, 3}) beta.push_back(inf_sup(fem::ElementKind::tet10, n));
    test::record("beta_tet10", beta);
    for (const double b : beta) EXPECT_GT(b, 0.1);
    EXPECT_GT(beta[2], 0.75 * beta[1]);
}

}  // namespace
}  // namespace myo::model
