#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>

#include "material/catalogue.hpp"
#include "model/cell_means.hpp"
#include "support/beam.hpp"

namespace myo::model {
namespace {

using Eigen::Matrix3d;

constexpr double E_Pa = 2e5, poisson = 0.4;

class CellMeansOf : public ::testing::TestWithParam<fem::ElementKind> {
protected:
    CellMeansOf() {
        test::BeamSpec spec;
        spec.kind = GetParam();
        model = test::make_beam(spec);
        model.material = material::neo_hookean();
        model.moduli = uniform_moduli(model.body->cell_count(), E_Pa, poisson);
    }
    CellMeans deformed(const Matrix3d& F, const std::vector<double>& activation = {}) const {
        return cell_means(model, F * model.body->mesh.nodes, activation);
    }

    Model model;
};

TEST_P(CellMeansOf, AgreeWithDifferencesOfTheEnergy) {
    Matrix3d F;
    F << 1.2, 0.1, -0.05, 0.3, 0.9, 0.02, 0.04, -0.1, 1.1;
    const material::Moduli m = model.moduli.front();
    const auto W = [&](const Matrix3d& at) {
        return model.material->distortion(at, m.mu, m.kappa, false).value +
               model.material->bulk(model.material->volume_measure(at, false).value, m.kappa).value;
    };
    Matrix3d P;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const double d = 1e-6;
            Matrix3d up = F, down = F;
            up(i, j) += d, down(i, j) -= d;
            P(i, j) = (W(up) - W(down)) / (2.0 * d);
        }
    const Matrix3d sigma = P * F.transpose() / F.determinant();
    const double pressure = -sigma.trace() / 3.0,
                 von_mises = std::sqrt(1.5) * (sigma + pressure * Matrix3d::Identity()).norm();
    const double stretch = F.jacobiSvd().singularValues()(0);
    const CellMeans means = deformed(F);
    for (int cell = 0; cell < model.body->cell_count(); ++cell) {
        EXPECT_NEAR(means.pressure_Pa(cell), pressure, 1e-5 * E_Pa);
        EXPECT_NEAR(means.von_mises_Pa(cell), von_mises, 1e-5 * E_Pa);
        EXPECT_NEAR(means.stretch(cell), stretch, 1e-9);
    }
}

TEST_P(CellMeansOf, PulledSlightlyTheStressIsYoungsModulusTimesTheStrain) {
    const double strain = 1e-5;
    const CellMeans means = deformed(
        Eigen::Vector3d(1.0 + strain, 1.0 - poisson * strain, 1.0 - poisson * strain).asDiagonal().toDenseMatrix());
    EXPECT_NEAR(means.von_mises_Pa.maxCoeff(), E_Pa * strain, 1e-3 * E_Pa * strain);
    EXPECT_NEAR(means.pressure_Pa.minCoeff(), -E_Pa * strain / 3.0, 1e-3 * E_Pa * strain);
}

TEST_P(CellMeansOf, TurnedItFeelsNothingAndPressedEvenlyNoShear) {
    const Matrix3d turn = Eigen::AngleAxisd(1.1, Eigen::Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
    const CellMeans turned = deformed(turn);
    EXPECT_LT(turned.von_mises_Pa.maxCoeff(), 1e-8 * E_Pa);
    EXPECT_LT(turned.pressure_Pa.cwiseAbs().maxCoeff(), 1e-8 * E_Pa);
    EXPECT_NEAR(turned.stretch.maxCoeff(), 1.0, 1e-9);
    const CellMeans pressed = deformed(0.99 * turn);
    EXPECT_LT(pressed.von_mises_Pa.maxCoeff(), 1e-8 * E_Pa);
    EXPECT_NEAR(pressed.pressure_Pa.minCoeff(), 0.03 * model.moduli.front().kappa,
                0.05 * 0.03 * model.moduli.front().kappa);
}

/// A contracted muscle in the rest shape pulls with w (1 - a) along its fibres.
TEST_P(CellMeansOf, AMuscleAddsItsTension) {
    const double w = 1.5e5, a = 0.8;
    const Box all{{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}};
    model.fibres = std::make_shared<const std::vector<fibre::FibreGroup>>(std::vector<fibre::FibreGroup>{
        fibre::fibres_in_box(model.body->mesh, all, Eigen::Vector3d::UnitX(), w, "all")});
    const CellMeans means = deformed(Matrix3d::Identity(), {a});
    EXPECT_NEAR(means.von_mises_Pa.minCoeff(), w * (1.0 - a), 1e-6 * w);
    EXPECT_NEAR(means.von_mises_Pa.maxCoeff(), w * (1.0 - a), 1e-6 * w);
    EXPECT_NEAR(means.pressure_Pa.mean(), -w * (1.0 - a) / 3.0, 1e-6 * w);
}

INSTANTIATE_TEST_SUITE_P(Elements, CellMeansOf,
                         ::testing::Values(fem::ElementKind::hex8, fem::ElementKind::hex8_mean_dilatation,
                                           fem::ElementKind::hex8_full, fem::ElementKind::tet10,
                                           fem::ElementKind::tet10_fine, fem::ElementKind::tet10_full,
                                           fem::ElementKind::tet4),
                         [](const auto& each) { return to_string(each.param); });

TEST(AtNodes, IsTheMeanOfTheCellsAround) {
    test::BeamSpec spec;
    const Model model = test::make_beam(spec);
    const mesh::VolumeMesh& mesh = model.body->mesh;
    const Eigen::VectorXd volumes = mesh::cell_volumes(mesh);
    const Eigen::VectorXd even = at_nodes(mesh, Eigen::VectorXd::Constant(mesh.cell_count(), 3.5), volumes);
    EXPECT_NEAR(even.minCoeff(), 3.5, 1e-12);
    EXPECT_NEAR(even.maxCoeff(), 3.5, 1e-12);
    Eigen::VectorXd one = Eigen::VectorXd::Zero(mesh.cell_count());
    one(0) = 1.0;
    const Eigen::VectorXd shared = at_nodes(mesh, one, volumes);
    EXPECT_GT(shared.maxCoeff(), 0.1);
    EXPECT_LE(shared.maxCoeff(), 1.0 + 1e-12);
    EXPECT_EQ((shared.array() > 0.0).count(), mesh.cells.rows());
}

}  // namespace
}  // namespace myo::model
