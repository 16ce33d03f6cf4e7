#include <gtest/gtest.h>

#include "base/decompositions.hpp"
#include "material/catalogue.hpp"
#include "model/internal_forces.hpp"
#include "support/figures.hpp"
#include "support/meshes.hpp"

namespace myo::model {
namespace {

using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

Model one_cell(double nu) {
    Model model;
    model.body = make_body(test::box_mesh(fem::ElementKind::hex8, {Vector3d::Zero(), Vector3d::Ones()}, {1, 1, 1}),
                           fem::ElementKind::hex8, {});
    model.material = material::neo_hookean();
    model.moduli = uniform_moduli(1, 1.0, nu);
    return model;
}

MatrixXd stiffness_at(const Model& model, const Vector3d& stretch) {
    const Stiffness s = stiffness(model);
    InternalInput input;
    input.stiffness = &s;
    return MatrixXd(
               internal_energy(model, stretch.asDiagonal() * model.body->mesh.nodes, input, HessianKind::exact).hessian)
        .selfadjointView<Eigen::Lower>();
}

/// Motions that the mean deformation gradient does not see, 24 x 12.
MatrixXd within_cell(const Model& model) {
    const auto& cell = std::get<PackedCells<PackAssumedStrain>>(model.body->cells).geometry(0);
    const auto& nodes = model.body->mesh.cells;
    MatrixXd motions = MatrixXd::Zero(24, 12);
    for (int a = 0; a < 8; ++a)
        for (int s = 0; s < 4; ++s)
            for (int r = 0; r < 3; ++r)
                motions(3 * nodes(a, 0) + r, 3 * s + r) = static_cast<double>(cell.gamma(a, s)[0]);
    return motions;
}

/// Six rigid motions and 18 that cost energy, none of them without bound as nu goes to 1/2 but the change of volume.
TEST(OneCell, HasSixRigidMotionsAndOneStiffOneAtRest) {
    for (const double nu : {0.0, 0.3, 0.49, 0.4995}) {
        const VectorXd values = symmetric_eigenvalues(stiffness_at(one_cell(nu), Vector3d::Ones()));
        test::record("rest_nu" + std::to_string(static_cast<int>(1e4 * nu)),
                     std::vector<double>(values.begin() + 6, values.end()));
        EXPECT_LT(values.head(6).cwiseAbs().maxCoeff(), 1e-12 * values(23)) << nu;
        EXPECT_GT(values(6), 1e-2) << nu;
        EXPECT_LT(values(22), 3.0) << nu;
        if (nu > 0.4) {
            EXPECT_GT(values(23), 0.1 / (1.0 - 2.0 * nu));
        }
    }
}

/// Bending modes of a free cell carry the law: E of a bar, E / (1 - nu^2) where the cell cannot curve across, mu in
/// torsion, each times the integral of the squared strain.
TEST(OneCell, BendsWithYoungsModulus) {
    const double nu = 0.3;
    const MatrixXd K = stiffness_at(one_cell(nu), Vector3d::Ones()), motions = within_cell(one_cell(nu));
    // u_x = xi zeta / 2 (strain zeta of half edges 1/2), u_y = eta zeta / 2 times ratio.
    const auto energy = [&](double ratio) {
        const Matrix3Xd X = one_cell(nu).body->mesh.nodes;
        VectorXd u = VectorXd::Zero(24);
        for (int i = 0; i < 8; ++i) {
            const Vector3d xi = 2.0 * X.col(i) - Vector3d::Ones();
            u(3 * i) = 0.5 * xi.x() * xi.z();
            u(3 * i + 1) = 0.5 * ratio * xi.y() * xi.z();
        }
        return u.dot(K * u);
    };
    EXPECT_NEAR(energy(0.0), 1.0 / (1.0 - nu * nu) / 3.0, 1e-12);
    EXPECT_NEAR(energy(-nu), 1.0 / 3.0, 1e-12);  // free to contract across: E
    const MatrixXd within = motions.transpose() * K * motions;
    EXPECT_GT(symmetric_eigenvalues(within).minCoeff(), 0.0);
}

/// Pressed to half its height, with its volume kept: nothing within the cell buckles, unlike cells with enhanced modes
/// (Wriggers & Reese 1996).
TEST(OneCell, StaysStableWhenPressedToHalf) {
    for (const double nu : {0.3, 0.49, 0.4995})
        for (const Vector3d& stretch : {Vector3d(0.5, std::sqrt(2.0), std::sqrt(2.0)), Vector3d(0.5, 1.0, 1.0),
                                        Vector3d(2.0, std::sqrt(0.5), std::sqrt(0.5))}) {
            const Model model = one_cell(nu);
            const MatrixXd motions = within_cell(model);
            const VectorXd values = symmetric_eigenvalues(motions.transpose() * stiffness_at(model, stretch) * motions);
            test::record("within_nu" + std::to_string(static_cast<int>(1e4 * nu)) + "_" +
                             std::to_string(static_cast<int>(10 * stretch(1))),
                         std::vector<double>(values.begin(), values.end()));
            EXPECT_GT(values.minCoeff(), 0.0) << nu << " " << stretch.transpose();
        }
}

}  // namespace
}  // namespace myo::model
