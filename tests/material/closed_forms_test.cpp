#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "material/catalogue.hpp"
#include "material/lanes.hpp"
#include "material/moduli.hpp"
#include "support/deformations.hpp"

// Energies and stresses of the laws for deformations with closed forms, and how they split volume from shape.

namespace myo::material::closed_forms_test {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double shear = 0.9, bulk = 2.6, lame = bulk - 2.0 / 3.0 * shear;

/// Energy and stress of a complete law at one point.
struct Whole {
    double energy = 0.0;
    Matrix3d stress;
};

Whole whole_of(const Material& law, const Matrix3d& F) {
    LawResponse<double> response;
    law.respond(F, shear, bulk, false, response);
    Whole result{response.distortion.value, response.distortion.gradient};
    if (!law.has_split()) return result;
    const ScalarFunction U = law.bulk(response.volume.value, bulk);
    result.energy += U.value;
    result.stress += U.first * response.volume.gradient;
    return result;
}

Matrix3d diagonal(double a, double b, double c) { return Vector3d(a, b, c).asDiagonal(); }

void expect_diagonal(const Whole& found, double energy, const Vector3d& stress, const std::string& what) {
    EXPECT_NEAR(found.energy, energy, 1e-12 * (1.0 + std::abs(energy))) << what;
    EXPECT_LT((found.stress - Matrix3d(stress.asDiagonal())).norm(), 1e-11 * (1.0 + stress.norm())) << what;
}

/// Stretches along the axes: every law by its principal stretches.
TEST(ClosedForms, OfPrincipalStretches) {
    for (const Vector3d& s : {Vector3d(1.3, 0.9, 0.8), Vector3d(0.7, 1.1, 1.6), Vector3d(1.2, 1.2, 1.2)}) {
        const double J = s.prod(), I1 = s.squaredNorm(), trace = s.sum() - 3.0, thin = std::pow(J, -2.0 / 3.0);
        const Vector3d one = Vector3d::Ones(), inverse = s.cwiseInverse(), E = 0.5 * (s.cwiseAbs2() - one);
        const double U = bulk / 4.0 * (J * J - 1.0 - 2.0 * std::log(J)), dU = bulk / 2.0 * (J - 1.0 / J);
        const Matrix3d F = s.asDiagonal();
        expect_diagonal(whole_of(*find_material("neo_hookean"), F), shear / 2.0 * (thin * I1 - 3.0) + U,
                        shear * thin * (s - I1 / 3.0 * inverse) + dU * J * inverse, "neo-Hookean");
        expect_diagonal(whole_of(*find_material("corotational"), F),
                        shear * (s - one).squaredNorm() + lame / 2.0 * trace * trace,
                        2.0 * shear * (s - one) + lame * trace * one, "corotational");
        expect_diagonal(whole_of(*find_material("st_venant_kirchhoff"), F),
                        shear * E.squaredNorm() + lame / 2.0 * E.sum() * E.sum(),
                        s.cwiseProduct(2.0 * shear * E + lame * E.sum() * one), "St. Venant-Kirchhoff");
        const double limit = 40.0, left = 1.0 - (thin * I1 - 3.0) / limit;
        expect_diagonal(whole_of(*find_material("gent", {limit}), F), -shear * limit / 2.0 * std::log(left) + U,
                        shear / left * thin * (s - I1 / 3.0 * inverse) + dU * J * inverse, "Gent");
        // cof F = J F^-1 here, so that the second invariant is J^2 sum 1/s^2.
        const double share = 0.4, I2 = J * J * inverse.squaredNorm(), thinner = thin * thin;
        const Vector3d d_I2 = 2.0 * J * J * (inverse.squaredNorm() * inverse - inverse.array().cube().matrix());
        expect_diagonal(whole_of(*find_material("mooney_rivlin", {share}), F),
                        shear / 2.0 * ((1.0 - share) * (thin * I1 - 3.0) + share * (thinner * I2 - 3.0)) + U,
                        shear * (1.0 - share) * thin * (s - I1 / 3.0 * inverse) +
                            shear / 2.0 * share * thinner * (d_I2 - 4.0 / 3.0 * I2 * inverse) + dU * J * inverse,
                        "Mooney-Rivlin");
    }
}

/// Shear stress per angle in simple shear, and the normal stress that linear laws lack.
TEST(ClosedForms, OfSimpleShear) {
    for (const double angle : {-0.9, 0.2, 1.5}) {
        Matrix3d F = Matrix3d::Identity();
        F(0, 1) = angle;
        const Whole soft = whole_of(*find_material("neo_hookean"), F),
                    green = whole_of(*find_material("st_venant_kirchhoff"), F);
        EXPECT_NEAR(soft.stress(0, 1), shear * angle, 1e-12) << "linear in the angle, however large";
        const Matrix3d cauchy = soft.stress * F.transpose();
        EXPECT_NEAR(cauchy(0, 1), shear * angle, 1e-12);
        EXPECT_NEAR(cauchy(0, 0) - cauchy(1, 1), shear * angle * angle, 1e-12)
            << "Poynting: as the square of the angle";
        const double E_yy = 0.5 * angle * angle;
        EXPECT_NEAR(green.energy, shear * (0.5 * angle * angle + E_yy * E_yy) + lame / 2.0 * E_yy * E_yy, 1e-12);
    }
}

/// A turn by 2.8 rad adds nothing: the strain is that of the stretches.
TEST(ClosedForms, OfAStretchedAndTurnedBar) {
    const Matrix3d turn = Eigen::AngleAxisd(2.8, Vector3d(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
    const Matrix3d F = turn * diagonal(1.4, 0.8, 0.9);
    const Whole found = whole_of(*find_material("corotational"), F);
    const double trace = 0.1;
    EXPECT_NEAR(found.energy, shear * (0.16 + 0.04 + 0.01) + lame / 2.0 * trace * trace, 1e-12);
    EXPECT_LT((turn.transpose() * found.stress -
               diagonal(0.8 * shear + lame * trace, -0.4 * shear + lame * trace, -0.2 * shear + lame * trace))
                  .norm(),
              1e-12);
}

/// The matrix of unit determinant nearest to F is F less the gradient of the volume's part.
TEST(ProjectiveLaw, ProjectsOnTheNearestMatrixOfUnitVolume) {
    const MaterialPointer law = find_material("projective_corotational");
    std::mt19937 random(11);
    std::vector<Matrix3d> samples = test::sample_deformations();
    samples.push_back(diagonal(0.05, 0.9, 1.1));
    samples.push_back(diagonal(-0.3, 0.9, 1.1));  // inverted
    samples.push_back(test::random_rotation(random) * diagonal(0.2, 0.3, 0.25));
    for (const Matrix3d& F : samples) {
        // Swollen to a multiple of its volume a cell has several such matrices, and not the nearest one is found.
        if (F.determinant() > 3.0) continue;
        LawResponse<double> response;
        law->respond(F, shear, bulk, false, response);
        const Matrix3d D = F - response.volume.gradient;
        EXPECT_NEAR(D.determinant(), 1.0, 1e-11);
        EXPECT_NEAR(response.volume.value, 0.5 * (F - D).squaredNorm(), 1e-12);
        // On the way from D to F stands the normal of the surface of unit determinants, the cofactors of D.
        const Matrix3d normal = D.inverse().transpose();
        const double along = (F - D).cwiseProduct(normal).sum() / normal.squaredNorm();
        EXPECT_LT((F - D - along * normal).norm(), 1e-10 * (1.0 + F.norm()));
        for (int trial = 0; trial < 200; ++trial) {
            // Near D and far from it.
            Matrix3d other = D + (trial < 100 ? 0.05 : 1.0) *
                                     Matrix3d::NullaryExpr([&] { return std::normal_distribution<double>()(random); });
            const double determinant = other.determinant();
            if (determinant < 1e-3) continue;
            other /= std::cbrt(determinant);
            EXPECT_GE((F - other).norm(), (F - D).norm() - 1e-12);
        }
    }
    for (const double a : {0.9, 1.0, 1.2}) {
        const Whole found = whole_of(*law, a * Matrix3d::Identity());
        expect_diagonal(found, 3.0 * (shear + 0.5 * lame) * (a - 1.0) * (a - 1.0),
                        Vector3d::Constant((2.0 * shear + lame) * (a - 1.0)), "dilation");
    }
}

/// At rest the split is that of small strain: volume has all of the bulk modulus, shape all of the shear modulus.
TEST(VolumeSplit, IsThatOfSmallStrainAtRest) {
    const Eigen::Matrix<double, 9, 1> dilation = Matrix3d::Identity().reshaped();
    int split = 0;
    for (const MaterialPointer& law : material_catalogue()) {
        const ScalarFunction at_rest = law->bulk(0.0, bulk);
        if (!law->has_split()) {
            EXPECT_EQ(law->volume_measure(diagonal(2.0, 1.0, 1.0), true).hessian.norm(), 0.0) << law->id();
            EXPECT_EQ(at_rest.second, 0.0) << law->id();
            continue;
        }
        ++split;
        EXPECT_EQ(at_rest.value, 0.0) << law->id();
        EXPECT_EQ(at_rest.first, 0.0) << law->id();
        EXPECT_NEAR(at_rest.second, bulk, 1e-15) << law->id();
        const TensorFunction theta = law->volume_measure(Matrix3d::Identity(), false),
                             W = law->distortion(Matrix3d::Identity(), shear, bulk, true);
        EXPECT_NEAR(theta.value, 0.0, 1e-14) << law->id();
        EXPECT_LT((theta.gradient - Matrix3d::Identity()).norm(), 1e-14) << law->id();
        EXPECT_NEAR(dilation.dot(W.hessian * dilation), 0.0, 1e-12) << law->id();
        EXPECT_EQ(law->distortion(diagonal(1.1, 0.8, 1.3), shear, 1e9, false).value,
                  law->distortion(diagonal(1.1, 0.8, 1.3), shear, 0.0, false).value)
            << law->id() << ": shape does not know the bulk modulus";
    }
    EXPECT_GE(split, 5);
}

/// Laws of isochoric invariants do not see a change of size at all, at any strain.
TEST(VolumeSplit, IsExactForIsochoricLaws) {
    for (const std::string id : {"neo_hookean", "gent", "mooney_rivlin"})
        for (const Matrix3d& F : test::sample_deformations())
            for (const double size : {0.5, 3.0}) {
                const TensorFunction once = find_material(id)->distortion(F, shear, bulk, false),
                                     larger = find_material(id)->distortion(size * F, shear, bulk, false);
                EXPECT_NEAR(larger.value, once.value, 1e-12 * (1.0 + once.value)) << id;
                EXPECT_LT((size * larger.gradient - once.gradient).norm(), 1e-12 * (1.0 + once.gradient.norm())) << id;
                EXPECT_NEAR(once.gradient.cwiseProduct(F).sum(), 0.0, 1e-12 * (1.0 + once.gradient.norm() * F.norm()));
            }
}

/// Just within and just beyond the strain at which the chains are stretched out, one point and one lane alike.
TEST(GentLimit, IsFiniteWithinAndNoNumberBeyond) {
    const double stretch = 3.0, limit = stretch * stretch + 2.0 / stretch - 3.0;
    const Matrix3d F = diagonal(stretch, 1.0 / std::sqrt(stretch), 1.0 / std::sqrt(stretch));
    const Whole within = whole_of(*find_material("gent", {limit * (1.0 + 1e-6)}), F),
                nearer = whole_of(*find_material("gent", {limit * (1.0 + 1e-7)}), F);
    EXPECT_NEAR(nearer.stress.norm() / within.stress.norm(), 10.0, 0.01) << "as the inverse of the distance";
    EXPECT_GT(nearer.energy, within.energy);
    EXPECT_LT(nearer.energy, 1e3) << "though the energy grows as its logarithm only";
    const MaterialPointer beyond = find_material("gent", {limit * (1.0 - 1e-6)});
    EXPECT_TRUE(std::isnan(whole_of(*beyond, F).energy));
    EXPECT_FALSE(whole_of(*beyond, F).stress.allFinite());
    Matrix3<Pack> lanes;
    for (int lane = 0; lane < pack_width; ++lane) set_lane(lanes, lane, lane == 0 ? F : Matrix3d::Identity().eval());
    Pack energy;
    Matrix3<Pack> stress;
    beyond->respond_whole(lanes, Pack(shear), Pack(bulk), energy, stress);
    EXPECT_TRUE(std::isnan(static_cast<double>(energy[0])));
    EXPECT_NEAR(static_cast<double>(energy[pack_width - 1]), 0.0, 1e-14) << "a bad cell does not spoil its neighbour";
}

TEST(ModuliPairs, GoThereAndBackWithTheirLimits) {
    for (const double ratio : {-0.9, -0.2, 0.0, 0.3, 0.49, 0.4999}) {
        const Moduli m = moduli_from_young(1e5, ratio);
        const YoungPoisson back = young_from_moduli(m);
        EXPECT_NEAR(back.youngs_modulus_Pa, 1e5, 1e-7) << ratio;
        EXPECT_NEAR(back.poissons_ratio, ratio, 1e-12);
    }
    EXPECT_DOUBLE_EQ(moduli_from_young(6.0, 0.0).mu, 3.0);
    EXPECT_DOUBLE_EQ(moduli_from_young(6.0, 0.0).kappa, 2.0);
    EXPECT_DOUBLE_EQ(moduli_from_young(6.0, 0.25).kappa, 4.0);
    const YoungPoisson incompressible = young_from_moduli({1.0, 1e12});
    EXPECT_NEAR(incompressible.youngs_modulus_Pa, 3.0, 1e-9);
    EXPECT_NEAR(incompressible.poissons_ratio, 0.5, 1e-9);
}

}  // namespace
}  // namespace myo::material::closed_forms_test
