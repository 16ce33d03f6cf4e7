#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "fem/isoparametric.hpp"
#include "material/catalogue.hpp"
#include "model/cell_kernel.hpp"
#include "model/pack_cells.hpp"
#include "support/differences.hpp"
#include "support/hex20.hpp"
#include "support/meshes.hpp"

// A cell outside of the program, defined in one file, goes through volume, mass, geometry and the kernel of the law.

namespace myo::model {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using test::Hex20;

const Vector3d cell_size(1.0, 0.8, 0.6);  // [m]

/// One cell whose edges along y are parabolas: sheared by bend * y^2, so that its volume is that of the box.
mesh::VolumeMesh parabolic_cell(double bend) {
    mesh::VolumeMesh mesh;
    mesh.nodes = (0.5 * cell_size).asDiagonal() * Hex20::places().transpose();
    mesh.nodes.row(0) += bend * mesh.nodes.row(1).cwiseAbs2();
    mesh.cells = Eigen::VectorXi::LinSpaced(Hex20::nodes, 0, Hex20::nodes - 1);
    return mesh;
}

fem::ElementBlock<20, 8> block_of(const mesh::VolumeMesh& mesh, bool mean_volume = false) {
    return fem::gauss_block<Hex20, 8>(mesh, Hex20::strain_rule(), mean_volume);
}

TEST(FurtherCell, HasTheVolumeAndTheMassOfItsBody) {
    const mesh::VolumeMesh mesh = parabolic_cell(0.3);
    const double volume = cell_size.x() * cell_size.y() * cell_size.z();
    EXPECT_NEAR(mesh::volumes_of<Hex20>(mesh)(0), volume, 1e-15);
    MatrixXd mass = MatrixXd::Zero(20, 20);
    for (const fem::MassEntry& entry : fem::consistent_mass_of<Hex20>(mesh))
        mass(entry.row, entry.column) += entry.value;
    EXPECT_NEAR(mass.sum(), volume, 1e-15);
    // Moments of linear fields: y about the centre, z about an edge.
    const VectorXd y = mesh.nodes.row(1), z = mesh.nodes.row(2).array() + 0.5 * cell_size.z();
    EXPECT_NEAR(y.dot(mass * y), volume * cell_size.y() * cell_size.y() / 12.0, 1e-15);
    EXPECT_NEAR(z.dot(mass * z), volume * cell_size.z() * cell_size.z() / 3.0, 1e-15);
}

TEST(FurtherCell, ReproducesLinearFieldsWithCurvedEdges) {
    Matrix3d A;
    A << 0.9, 0.3, -0.2, 0.1, 1.2, 0.4, -0.5, 0.2, 0.8;
    const mesh::VolumeMesh mesh = parabolic_cell(0.3);
    const fem::ElementBlock<20, 8> block = block_of(mesh);
    for (const auto& gradient : block.geometry.front().gradient)
        EXPECT_LT((test::mapped(mesh, A, {3.0, -1.0, 2.0}) * gradient - A).norm(), 1e-13);
}

/// The kernel at one cell with nearly incompressible moduli.
class FurtherCellKernel : public testing::TestWithParam<bool> {
protected:
    template <bool WithHessian>
    PackOutput<20> at(const Matrix3Xd& x) const {
        PackInput in;
        in.elastic = true;
        in.elasticity.law = law_.get();
        in.elasticity.mu = 1.0;
        in.elasticity.kappa = 50.0;
        PackNodes<20> nodes;
        for (int k = 0; k < 60; ++k) nodes(k % 3, k / 3) = x(k % 3, k / 3);
        PackOutput<20> out;
        evaluate_pack<WithHessian>(cells_, 0, nodes, in, out);
        return out;
    }
    double energy(const VectorXd& x) const { return static_cast<double>(at<false>(x.reshaped(3, 20)).energy[0]); }
    VectorXd gradient(const VectorXd& x) const {
        const PackOutput<20> out = at<false>(x.reshaped(3, 20));
        VectorXd g(60);
        for (int k = 0; k < 60; ++k) g(k) = out.gradient(k % 3, k / 3)[0];
        return g;
    }
    MatrixXd hessian(const VectorXd& x) const {
        const PackOutput<20> out = at<true>(x.reshaped(3, 20));
        MatrixXd H(60, 60);
        for (int b = 0; b < 20; ++b)
            for (int a = b; a < 20; ++a)
                for (int k = 0; k < 9; ++k)
                    H(3 * a + k % 3, 3 * b + k / 3) = H(
                        3 * b + k / 3,
                        3 * a + k % 3) = out.hessian[static_cast<std::size_t>(lower_block<20>(a, b))](k % 3, k / 3)[0];
        return H;
    }

    mesh::VolumeMesh mesh_ = parabolic_cell(0.3);
    material::MaterialPointer law_ = material::neo_hookean();
    PackedCells<PackGeometry<20, 8>> cells_ = pack_cells<PackGeometry<20, 8>>(block_of(mesh_, GetParam()));
};

TEST_P(FurtherCellKernel, ForceAndStiffnessAreDerivativesOfTheEnergy) {
    const VectorXd x = (mesh_.nodes + 0.03 * test::rough_field(20, 0.4)).reshaped();
    const auto value = [&](const VectorXd& y) { return VectorXd::Constant(1, energy(y)); };
    const auto slope = [&](const VectorXd& y) { return gradient(y); };
    test::expect_derivative(gradient(x).transpose(), test::central_differences(value, x, 1e-5), 1e-7, "force");
    test::expect_derivative(hessian(x), test::central_differences(slope, x, 1e-5), 1e-7, "stiffness");
}

TEST_P(FurtherCellKernel, RigidMotionGivesNoForceAndThePointsSeeAllTheirStrains) {
    const Matrix3d Q = Eigen::AngleAxisd(2.1, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
    const VectorXd x = test::mapped(mesh_, Q, {3.0, -2.0, 5.0}).reshaped();
    EXPECT_NEAR(energy(x), 0.0, 1e-12);
    EXPECT_LT(gradient(x).cwiseAbs().maxCoeff(), 1e-12);
    const VectorXd values = Eigen::SelfAdjointEigenSolver<MatrixXd>(hessian(x), Eigen::EigenvaluesOnly).eigenvalues();
    // Eight points see at most eight times six strains, with one volume per cell eight times five and one.
    const int seen = GetParam() ? 41 : 48;
    EXPECT_LT(values.head(60 - seen).cwiseAbs().maxCoeff(), 1e-12 * values(59));
    EXPECT_GT(values(60 - seen), 1e-4);
}

INSTANTIATE_TEST_SUITE_P(Volume, FurtherCellKernel, testing::Bool(), [](const testing::TestParamInfo<bool>& volume) {
    return volume.param ? "AveragedOverTheCell" : "AtThePoints";
});

}  // namespace
}  // namespace myo::model
