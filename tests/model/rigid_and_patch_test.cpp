#include <gtest/gtest.h>

#include <limits>

#include "material/catalogue.hpp"
#include "model/internal_forces.hpp"
#include "support/deformations.hpp"
#include "support/meshes.hpp"

namespace myo::model {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

Model body_of(const std::string& element, const material::MaterialPointer& law, double poissons_ratio) {
    const fem::ElementKind kind = test::element(element);
    Model model;
    model.body = make_body(test::distorted_mesh(fem::cell_type(kind), {3, 3, 3}, 0.2, 5), kind, {});
    model.material = law;
    model.moduli = uniform_moduli(model.body->cell_count(), 1.0, poissons_ratio);
    model.damping_s = 0.01;
    return model;
}

InternalEnergy energy_at(const Model& model, const Matrix3Xd& x, const VectorXd& rate) {
    const Stiffness moduli = stiffness(model);
    InternalInput input;
    input.stiffness = &moduli;
    input.rate = {0.0, &rate};
    return internal_energy(model, x, input, HessianKind::none);
}

std::vector<int> inner_nodes(const Body& body) {
    std::vector<bool> outside(static_cast<std::size_t>(body.node_count()), false);
    for (Eigen::Index f = 0; f < body.boundary.count(); ++f)
        for (const int node : body.boundary.nodes.col(f)) outside[static_cast<std::size_t>(node)] = true;
    std::vector<int> nodes;
    for (int i = 0; i < body.node_count(); ++i)
        if (!outside[static_cast<std::size_t>(i)]) nodes.push_back(i);
    return nodes;
}

/// Large rotation and translation: no energy, no force, no strain, at rounding (kappa = 167 E).
TEST(RigidMotion, GivesNoForce) {
    const Matrix3d Q = Eigen::AngleAxisd(2.1, Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
    for (const std::string& element : fem::element_ids())
        for (const material::MaterialPointer& law : material::material_catalogue()) {
            const Model model = body_of(element, law, 0.499);
            const Matrix3Xd x = test::mapped(model.body->mesh, Q, {3.0, -2.0, 5.0});
            const VectorXd strain = strains(model, x);
            const InternalEnergy moved = energy_at(model, x, VectorXd::Zero(strain.size()));
            EXPECT_LT(moved.gradient.cwiseAbs().maxCoeff(), 1e-11) << element << " " << law->id();
            EXPECT_NEAR(moved.energy, 0.0, 1e-11) << element << " " << law->id();
            EXPECT_LT(strain.cwiseAbs().maxCoeff(), 1e-13) << element;
            // And rotating a deformed state rotates its forces.
            const Matrix3Xd y = model.body->mesh.nodes + 0.006 * test::rough_field(x.cols(), 0.4);
            const VectorXd rate = VectorXd::LinSpaced(strain.size(), -1.0, 1.0);
            const InternalEnergy at = energy_at(model, y, rate);
            const InternalEnergy turned = energy_at(model, (Q * y).colwise() + Vector3d(1, 2, 3), rate);
            EXPECT_NEAR(turned.energy, at.energy, 1e-10 * at.energy) << element << " " << law->id();
            EXPECT_LT((turned.gradient - Q * at.gradient).norm(), 1e-10 * at.gradient.norm())
                << element << " " << law->id();
        }
}

/// Forces and moments of internal forces vanish at any deformation.
TEST(RigidMotion, InternalForcesHaveNoResultantAndNoMoment) {
    for (const std::string& element : fem::element_ids())
        for (const material::MaterialPointer& law : material::material_catalogue()) {
            const Model model = body_of(element, law, 0.45);
            const Matrix3Xd x = model.body->mesh.nodes + 0.006 * test::rough_field(model.body->node_count(), 0.4);
            const VectorXd rate = VectorXd::LinSpaced(model.body->strain_count(), -1.0, 1.0);
            const Matrix3Xd f = energy_at(model, x, rate).gradient;
            Vector3d moment = Vector3d::Zero();
            for (Eigen::Index i = 0; i < f.cols(); ++i) moment += x.col(i).head<3>().cross(f.col(i).head<3>());
            EXPECT_LT(f.rowwise().sum().norm(), 1e-13 * f.norm()) << element;
            EXPECT_LT(moment.norm(), 1e-13 * f.norm()) << element << " " << law->id();
        }
}

/// Patch test on arbitrarily distorted meshes: a homogeneous deformation, small or large, loads no inner node, and its
/// energy is the energy density times the volume.
TEST(PatchTest, HomogeneousDeformationIsInEquilibrium) {
    std::mt19937 random(8);
    std::vector<Matrix3d> deformations{Matrix3d::Identity() + 1e-6 * Matrix3d::Random()};
    for (int k = 0; k < 2; ++k) deformations.push_back(test::random_deformation(random, 0.6, 1.6));
    for (const std::string& element : fem::element_ids())
        for (const material::MaterialPointer& law : material::material_catalogue())
            for (const Matrix3d& A : deformations) {
                const Model model = body_of(element, law, 0.4);
                const std::vector<int> inside = inner_nodes(*model.body);
                ASSERT_GE(inside.size(), 8u) << element;
                const Matrix3Xd x = test::mapped(model.body->mesh, A, {0.1, 0.2, 0.3});
                const InternalEnergy at = energy_at(model, x, VectorXd::Zero(model.body->strain_count()));
                double largest = 0.0;
                for (const int i : inside) largest = std::max(largest, at.gradient.col(i).norm());
                EXPECT_LT(largest, 1e-12 * at.gradient.colwise().norm().maxCoeff() + 1e-15)
                    << element << " " << law->id();

                const material::Moduli m = model.moduli.front();
                const double W = law->distortion(A, m.mu, m.kappa, false).value +
                                 law->bulk(law->volume_measure(A, false).value, m.kappa).value;
                const double volume = mesh::cell_volumes(model.body->mesh).sum();
                // The law subtracts 3 mu / 2 from a number of that size.
                const double rounding = 4.0 * std::numeric_limits<double>::epsilon() * m.mu * volume;
                EXPECT_NEAR(at.energy, volume * W, 1e-12 * volume * W + rounding) << element << " " << law->id();
            }
}

}  // namespace
}  // namespace myo::model
