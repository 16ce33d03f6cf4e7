#include <gtest/gtest.h>

#include <functional>

#include "base/decompositions.hpp"
#include "material/catalogue.hpp"
#include "model/internal_forces.hpp"
#include "support/differences.hpp"
#include "support/meshes.hpp"

namespace myo::model {
namespace {

using Eigen::Map;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// One or two distorted cells (a few tetrahedra), strongly deformed, with every term of the energy switched on.
struct Case {
    Model model;
    Stiffness moduli;
    std::vector<double> activation{0.7, 1.4};
    VectorXd history;
    double rate_factor = 30.0;
    Matrix3Xd x;

    Case(const std::string& element_id, const material::MaterialPointer& law, double deformation) {
        const fem::ElementKind kind = test::element(element_id);
        const bool hex = fem::cell_type(kind) == mesh::CellType::hex8;
        mesh::VolumeMesh mesh = test::distorted_mesh(
            fem::cell_type(kind), hex ? Eigen::Vector3i(2, 1, 1) : Eigen::Vector3i(1, 1, 1), 0.15, 3);
        std::mt19937 random(4);
        std::uniform_real_distribution<double> shift(-1.0, 1.0);
        const auto noise = [&](Eigen::Index n) { return Matrix3Xd::NullaryExpr(3, n, [&] { return shift(random); }); };
        if (kind == fem::ElementKind::tet10 || kind == fem::ElementKind::tet10_full)
            mesh.nodes += 0.02 * noise(mesh.node_count());  // curved edges
        model.body = make_body(mesh, kind, {});
        model.material = law;
        model.moduli = uniform_moduli(model.body->cell_count(), 1.0, 0.45);
        for (std::size_t c = 0; c < model.moduli.size(); ++c) model.moduli[c].mu *= 1.0 + 0.3 * static_cast<double>(c);
        model.damping_s = 0.02;
        model.point_factors = 1.0 + 0.3 * VectorXd::LinSpaced(model.body->point_count(), -1.0, 5.0).array().sin();
        auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>();
        const Box whole{{-1, -1, -1}, {2, 2, 2}}, part{{-1, -1, -1}, {0.5, 2, 2}};
        fibres->push_back(fibre::fibres_in_box(mesh, whole, Vector3d(1, 2, 1).normalized(), 0.8, "a"));
        fibres->push_back(fibre::fibres_in_box(mesh, part, Vector3d(0, -1, 3).normalized(), 0.5, "b"));
        model.fibres = fibres;
        model.activation = {fibre::Signal::constant(0.7), fibre::Signal::constant(1.4)};
        moduli = stiffness(model);

        const Matrix3Xd before = mesh.nodes + 0.5 * deformation * noise(mesh.node_count());
        history = -rate_factor * strains(model, before);
        Eigen::Matrix3d A = Eigen::AngleAxisd(1.3, Vector3d(1, -1, 2).normalized()).toRotationMatrix();
        A *= Eigen::Vector3d(1.0 + deformation, 1.0 - deformation, 1.0 + 0.5 * deformation).asDiagonal();
        x = test::mapped(mesh, A, {0.2, 0.1, -0.3}) + deformation * 0.3 * noise(mesh.node_count());
    }

    InternalEnergy at(const Matrix3Xd& positions, HessianKind kind, const VectorXd* pressure = nullptr) const {
        InternalInput input;
        input.stiffness = &moduli;
        input.activation = &activation;
        input.rate = {rate_factor, &history};
        input.pressure = pressure;
        return internal_energy(model, positions, input, kind);
    }
};

Matrix3Xd as_positions(const VectorXd& v) { return Map<const Matrix3Xd>(v.data(), 3, v.size() / 3); }
VectorXd as_vector(const Matrix3Xd& x) { return Map<const VectorXd>(x.data(), x.size()); }
MatrixXd full(const solver::SymmetricSparse& lower) {
    const MatrixXd L(lower);
    return L.selfadjointView<Eigen::Lower>();
}

void for_each_case(const std::function<void(Case&, const std::string&)>& visit) {
    for (const std::string& element : fem::element_ids())
        for (const material::MaterialPointer& law : material::material_catalogue())
            for (const double deformation : {0.02, 0.25}) {
                Case c(element, law, deformation);
                visit(c, element + " " + law->id() + " " + std::to_string(deformation));
            }
}

constexpr double eps = 1e-5;

/// With central differences every term: elastic, viscous, fibres, hourglass.
TEST(ModelDerivatives, ForceAndStiffnessAgreeWithDifferences) {
    for_each_case([](Case& c, const std::string& what) {
        const InternalEnergy exact = c.at(c.x, HessianKind::exact);
        const auto energy = [&](const VectorXd& v) {
            return VectorXd::Constant(1, c.at(as_positions(v), HessianKind::none).energy);
        };
        const auto gradient = [&](const VectorXd& v) {
            return as_vector(c.at(as_positions(v), HessianKind::none).gradient);
        };
        const VectorXd x = as_vector(c.x);
        test::expect_derivative(as_vector(exact.gradient).transpose(), test::central_differences(energy, x, eps), 1e-7,
                                what + " gradient");
        test::expect_derivative(full(exact.hessian), test::central_differences(gradient, x, eps), 1e-7,
                                what + " Hessian");
    });
}

/// Each term alone, so that a small one cannot hide behind a large one.
TEST(ModelDerivatives, EachTermAloneAgreesWithDifferences) {
    for (const std::string& element : fem::element_ids())
        for (int term = 0; term < 3; ++term) {
            Case c(element, material::neo_hookean(), 0.2);
            if (term != 0) c.moduli.elastic.clear();
            if (term != 1) c.moduli.viscous.clear();
            c.moduli.fibres = term == 2;
            const std::string what = element + " term " + std::to_string(term);
            const InternalEnergy exact = c.at(c.x, HessianKind::exact);
            const auto energy = [&](const VectorXd& v) {
                return VectorXd::Constant(1, c.at(as_positions(v), HessianKind::none).energy);
            };
            const auto gradient = [&](const VectorXd& v) {
                return as_vector(c.at(as_positions(v), HessianKind::none).gradient);
            };
            const VectorXd x = as_vector(c.x);
            test::expect_derivative(as_vector(exact.gradient).transpose(), test::central_differences(energy, x, eps),
                                    1e-7, what);
            test::expect_derivative(full(exact.hessian), test::central_differences(gradient, x, eps), 1e-7, what);
        }
}

TEST(ModelDerivatives, PositiveHessianIsSemidefiniteAndKeepsWhatAlreadyIs) {
    int indefinite = 0;
    for_each_case([&](Case& c, const std::string& what) {
        const MatrixXd exact = full(c.at(c.x, HessianKind::exact).hessian),
                       positive = full(c.at(c.x, HessianKind::positive).hessian);
        const double scale = exact.norm();
        indefinite += symmetric_eigenvalues(exact).minCoeff() < -1e-6 * scale;
        EXPECT_GT(symmetric_eigenvalues(positive).minCoeff(), -1e-12 * scale) << what;
    });
    EXPECT_GT(indefinite, 0);  // otherwise nothing was projected

    // Stretched by its load a cell's own stiffness is already semidefinite and must stay as it is.
    Case c("hex8_full", material::find_material("corotational"), 0.0);
    c.moduli.viscous.clear();
    c.moduli.fibres = false;
    const Matrix3Xd rest = c.model.body->mesh.nodes;
    const MatrixXd exact = full(c.at(rest, HessianKind::exact).hessian),
                   positive = full(c.at(rest, HessianKind::positive).hessian);
    EXPECT_LT((exact - positive).norm(), 1e-12 * exact.norm());
}

/// Rigid translation costs nothing: every Hessian has it in its null space when there are no clamps.
TEST(ModelDerivatives, TranslationsAreInTheNullSpace) {
    for_each_case([](Case& c, const std::string& what) {
        const MatrixXd H = full(c.at(c.x, HessianKind::exact).hessian);
        for (int r = 0; r < 3; ++r) {
            Matrix3Xd t = Matrix3Xd::Zero(3, c.x.cols());
            t.row(r).setOnes();
            EXPECT_LT((H * as_vector(t)).norm(), 1e-11 * H.norm()) << what;
        }
    });
}

TEST(ModelDerivatives, ClampsKeepTheFreePartOfTheHessian) {
    for (const std::string& element : fem::element_ids()) {
        Case c(element, material::neo_hookean(), 0.2);
        const MatrixXd whole = full(c.at(c.x, HessianKind::exact).hessian);
        const std::vector<int> clamped{0, 3, 5};
        if (c.model.body->node_count() <= 5) continue;
        c.model.body = make_body(c.model.body->mesh, c.model.body->kind, clamped);
        const BlockPattern& pattern = c.model.body->pattern;
        ASSERT_EQ(pattern.free_count, c.model.body->node_count() - 3);
        const MatrixXd part = full(c.at(c.x, HessianKind::exact).hessian);
        for (int j = 0; j < pattern.free_count; ++j)
            for (int i = 0; i < pattern.free_count; ++i) {
                const int a = pattern.free_nodes[static_cast<std::size_t>(i)],
                          b = pattern.free_nodes[static_cast<std::size_t>(j)];
                EXPECT_LT((part.block<3, 3>(3 * i, 3 * j) - whole.block<3, 3>(3 * a, 3 * b)).norm(),
                          1e-13 * whole.norm())
                    << element;
            }
        const Matrix3Xd scattered = scatter(pattern, gather(pattern, c.x));
        for (const int node : clamped) EXPECT_EQ(scattered.col(node).norm(), 0.0);
        EXPECT_EQ((gather(pattern, scattered) - gather(pattern, c.x)).norm(), 0.0);
    }
}

TEST(ModelDerivatives, StrainTangentAgreesWithDifferences) {
    for_each_case([](Case& c, const std::string& what) {
        const Matrix3Xd dx = test::rough_field(c.x.cols(), 0.9);
        const VectorXd differences = (strains(c.model, c.x + eps * dx) - strains(c.model, c.x - eps * dx)) /
                                     (2.0 * eps);
        test::expect_derivative(strain_tangent(c.model, c.x, dx), differences, 1e-8, what);
    });
}

TEST(ModelDerivatives, PredictedPressuresAreTheLinearPrediction) {
    for_each_case([](Case& c, const std::string& what) {
        if (c.model.material->bulk(0.1, 1.0).value == 0.0) return;  // a law without a split
        const Matrix3Xd dx = test::rough_field(c.x.cols(), 0.9);
        const VectorXd p = pressures(c.model, c.moduli, c.x);
        const VectorXd differences = (pressures(c.model, c.moduli, c.x + eps * dx) -
                                      pressures(c.model, c.moduli, c.x - eps * dx)) /
                                     (2.0 * eps);
        EXPECT_EQ(p.size(), c.model.body->volume_points());
        EXPECT_LT((predicted_pressures(c.model, c.moduli, c.x, Matrix3Xd::Zero(3, c.x.cols())) - p).norm(),
                  1e-15 * p.norm() + 1e-300);
        test::expect_derivative(predicted_pressures(c.model, c.moduli, c.x, dx) - p, differences, 1e-7, what);
        // With the pressures of x itself the mixed Hessian is the exact one.
        const MatrixXd exact = full(c.at(c.x, HessianKind::exact).hessian),
                       mixed = full(c.at(c.x, HessianKind::exact, &p).hessian);
        EXPECT_LT((exact - mixed).norm(), 1e-13 * exact.norm()) << what;
    });
}

TEST(ModelDerivatives, ViscousGradientIsTheDerivativeWithRespectToTheRate) {
    for_each_case([](Case& c, const std::string& what) {
        const Matrix3Xd elastic_only = [&] {
            Case e = c;
            e.moduli.viscous.clear();
            return e.at(c.x, HessianKind::none).gradient;
        }();
        const VectorXd rate = c.rate_factor * strains(c.model, c.x) + c.history;
        const Matrix3Xd viscous = viscous_gradient(c.model, c.x, rate);
        ASSERT_GT(viscous.norm(), 0.0);
        EXPECT_LT((elastic_only + viscous - c.at(c.x, HessianKind::none).gradient).norm(),
                  1e-12 * (elastic_only.norm() + viscous.norm()))
            << what;
        EXPECT_LT((viscous_gradient(c.model, c.x, -2.0 * rate) + 2.0 * viscous).norm(), 1e-13 * viscous.norm()) << what;
        // It takes energy: the power against the rate that belongs to a motion dx is positive.
        const Matrix3Xd dx = test::rough_field(c.x.cols(), 0.9);
        EXPECT_GT(viscous_gradient(c.model, c.x, strain_tangent(c.model, c.x, dx)).cwiseProduct(dx).sum(), 0.0) << what;
    });
}

TEST(ModelDerivatives, ActivationGradientAgreesWithDifferences) {
    for (const std::string& element : fem::element_ids()) {
        Case c(element, material::neo_hookean(), 0.2);
        const std::vector<double> d{0.3, -1.2};
        Case plus = c, minus = c;
        for (std::size_t g = 0; g < d.size(); ++g) {
            plus.activation[g] += 1e-3 * d[g];
            minus.activation[g] -= 1e-3 * d[g];
        }
        const Matrix3Xd differences = (plus.at(c.x, HessianKind::none).gradient -
                                       minus.at(c.x, HessianKind::none).gradient) /
                                      2e-3;
        test::expect_derivative(activation_gradient(c.model, c.x, d), differences, 1e-10, element);
    }
}

/// What parameter derivatives rest on: the energy at a combination of moduli is the combination of the energies.
TEST(ModelDerivatives, EnergyIsLinearInTheModuli) {
    for_each_case([](Case& c, const std::string& what) {
        c.moduli.fibres = false;
        Case a = c, b = c, sum = c;
        for (std::size_t i = 0; i < c.moduli.elastic.size(); ++i) {
            a.moduli.elastic[i] = {0.4, 1.5};
            b.moduli.elastic[i] = {-0.1, 7.0};
            sum.moduli.elastic[i] = {0.4 + 3.0 * -0.1, 1.5 + 3.0 * 7.0};
            a.moduli.viscous[i] = {0.02, 0.0};
            b.moduli.viscous[i] = {0.05, 0.0};
            sum.moduli.viscous[i] = {0.02 + 3.0 * 0.05, 0.0};
        }
        const InternalEnergy A = a.at(c.x, HessianKind::exact), B = b.at(c.x, HessianKind::exact),
                             S = sum.at(c.x, HessianKind::exact);
        EXPECT_NEAR(S.energy, A.energy + 3.0 * B.energy, 1e-12 * (std::abs(A.energy) + std::abs(B.energy))) << what;
        EXPECT_LT((S.gradient - A.gradient - 3.0 * B.gradient).norm(), 1e-12 * (A.gradient.norm() + B.gradient.norm()))
            << what;
        const MatrixXd H = full(A.hessian) + 3.0 * full(B.hessian);
        EXPECT_LT((full(S.hessian) - H).norm(), 1e-12 * (full(A.hessian).norm() + full(B.hessian).norm())) << what;
    });
}

TEST(ModelDerivatives, InputsAreLeftUntouchedAndRepeatsAreIdentical) {
    Case c("hex8", material::neo_hookean(), 0.2);
    const Matrix3Xd x = c.x;
    const VectorXd history = c.history;
    const InternalEnergy first = c.at(c.x, HessianKind::exact), second = c.at(c.x, HessianKind::exact);
    EXPECT_EQ(x, c.x);
    EXPECT_EQ(history, c.history);
    EXPECT_EQ(first.energy, second.energy);
    EXPECT_EQ(first.gradient, second.gradient);
    EXPECT_TRUE((first.hessian.coeffs() == second.hessian.coeffs()).all());
}

}  // namespace
}  // namespace myo::model
