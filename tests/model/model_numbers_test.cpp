#include <gtest/gtest.h>

#include <Eigen/Core>

#include <limits>
#include <optional>
#include <vector>

#include "fibre/signal.hpp"
#include "model/directional_mass.hpp"
#include "model/internal_forces.hpp"
#include "model/mass_matrix.hpp"
#include "model/model.hpp"
#include "model/point_friction.hpp"
#include "support/beam.hpp"
#include "support/meshes.hpp"

namespace myo::model::model_numbers_tests {
namespace {

using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;
using fibre::Signal;

constexpr double never = std::numeric_limits<double>::infinity();

TEST(DeadForce, FollowsItsCourseWithinItsWindow) {
    DeadForce load;
    EXPECT_TRUE(load.switches());
    EXPECT_EQ(load.factor(-1e9, false), 1.0) << "always, unless it is limited";
    load.from_s = 1.0;
    load.until_s = 3.0;
    load.course = Signal{{0.0, 2.0, 2.0, 4.0}, {0.0, 1.0, -1.0, -3.0}};
    EXPECT_FALSE(load.switches());
    struct Instant {
        double time_s, at, before;
    };
    for (const Instant& t : {Instant{0.999, 0.0, 0.0},
                             {1.0, 0.5, 0.0},
                             {1.5, 0.75, 0.75},
                             {2.0, -1.0, 1.0},
                             {2.5, -1.5, -1.5},
                             {3.0, 0.0, -2.0},
                             {3.001, 0.0, 0.0}}) {
        EXPECT_NEAR(load.factor(t.time_s, false), t.at, 1e-15) << t.time_s;
        EXPECT_NEAR(load.factor(t.time_s, true), t.before, 1e-15) << t.time_s;
    }
    // A window without length never acts.
    load.until_s = 1.0;
    EXPECT_EQ(load.factor(1.0, false), 0.0);
    EXPECT_EQ(load.factor(1.0, true), 0.0);
}

TEST(ExternalForces, AddAllLoadsOfTheirTime) {
    test::BeamSpec spec;
    Model model = test::make_beam(spec);
    const VectorXd tip = test::tip_share(model, spec);
    model.forces = {{tip, {1.0, 0.0, 0.0}, 0.0, 1.0, Signal::constant(1.0)},
                    {tip, {0.0, 2.0, 0.0}, -never, never, Signal{{0.0, 2.0}, {0.0, 1.0}}}};
    const MassMatrix mass = mass_matrix(model);
    const auto total = [&](double t, bool before) {
        return Vector3d(external_forces(model, mass, t, before).rowwise().sum());
    };
    EXPECT_LT((total(0.5, false) - Vector3d(1.0, 0.5, 0.0)).norm(), 1e-14);
    EXPECT_LT((total(1.0, true) - Vector3d(1.0, 1.0, 0.0)).norm(), 1e-14);
    EXPECT_LT((total(1.0, false) - Vector3d(0.0, 1.0, 0.0)).norm(), 1e-14);
    EXPECT_LT((total(7.0, false) - Vector3d(0.0, 2.0, 0.0)).norm(), 1e-14);
    const Matrix3Xd f = external_forces(model, mass, 7.0);
    EXPECT_LT((f.row(1).transpose() - 2.0 * tip).norm(), 1e-15);
}

TEST(JumpTimes, AreAllDiscontinuitiesOnceInOrder) {
    test::BeamSpec spec;
    Model model = test::make_beam(spec);
    EXPECT_TRUE(jump_times(model).empty());
    const VectorXd tip = test::tip_share(model, spec);
    model.forces = {{tip, Vector3d::UnitX(), 3.0, never, Signal{{0.0, 0.5, 0.5}, {0.0, 1.0, 2.0}}},
                    {tip, Vector3d::UnitX(), -never, 0.5, Signal::constant(1.0)}};
    model.activation = {Signal::held({0.0, 1.0, 2.0}, {1.0, 0.9, 0.9}), Signal{{0.0, 4.0}, {1.0, 0.8}}};
    model.directional_masses = {line_mass(tip, Vector3d::UnitX(), 1.0)};
    model.directional_masses[0].from_s = 2.0;
    model.directional_masses[0].until_s = 7.0;
    model.force_elements = {
        point_friction(*model.body, 0, {model.body->mesh.cells(0, 0)}, VectorXd::Ones(1), std::nullopt, 0.1, 0.01)};
    EXPECT_EQ(jump_times(model), (std::vector<double>{0.0, 0.5, 1.0, 2.0, 3.0, 7.0}));
}

TEST(Moduli, AreThoseOfYoungAndPoissonAndBack) {
    const std::vector<material::Moduli> none = uniform_moduli(2, 6.0, 0.0);
    ASSERT_EQ(none.size(), 2u);
    EXPECT_DOUBLE_EQ(none[1].mu, 3.0);
    EXPECT_DOUBLE_EQ(none[1].kappa, 2.0);
    EXPECT_TRUE(uniform_moduli(0, 6.0, 0.0).empty());
    std::vector<material::Moduli> moduli;
    for (const double nu : {-0.9, 0.0, 0.3, 0.49, 0.4999}) moduli.push_back(material::moduli_from_young(2e5, nu));
    const std::vector<double> back = poissons_ratios(moduli);
    ASSERT_EQ(back.size(), 5u);
    EXPECT_NEAR(back[0], -0.9, 1e-14);
    EXPECT_NEAR(back[1], 0.0, 1e-15);
    EXPECT_NEAR(back[2], 0.3, 1e-15);
    EXPECT_NEAR(back[4], 0.4999, 1e-14);
    for (const material::Moduli& m : moduli) EXPECT_NEAR(material::young_from_moduli(m).youngs_modulus_Pa, 2e5, 1e-6);
}

/// Cells of other densities weigh as much more, and where they are.
TEST(MassMatrixOfParts, HasTheirMassAndCentre) {
    for (const fem::ElementKind kind : {fem::ElementKind::hex8, fem::ElementKind::tet10}) {
        test::BeamSpec spec;
        spec.kind = kind;
        Model model = test::make_beam(spec);
        const MatrixXd plain = mass_matrix(model).isotropic;
        model.density_factors.assign(static_cast<std::size_t>(model.body->cell_count()), 1.0);
        EXPECT_LT((MatrixXd(mass_matrix(model).isotropic) - plain).norm(), 1e-14 * plain.norm());
        for (int c = 0; c < model.body->cell_count(); ++c) {
            const auto cell = model.body->mesh.cells.col(c);
            double middle = 0.0;
            for (const int node : cell) middle += model.body->mesh.nodes(0, node) / static_cast<double>(cell.size());
            if (middle > 0.05) model.density_factors[static_cast<std::size_t>(c)] = 3.0;
        }
        const MassMatrix mass = mass_matrix(model);
        const double half_kg = 0.5 * spec.density_kg_m3 * spec.size.prod();
        EXPECT_NEAR(mass.nodal_kg.sum(), 4.0 * half_kg, 1e-14);
        EXPECT_NEAR(mass.nodal_kg.dot(model.body->mesh.nodes.row(0)), half_kg * (0.025 + 3.0 * 0.075), 1e-15);
        // The product with a nodal field is that of the dense matrix.
        const Matrix3Xd X = test::rough_field(model.body->node_count(), 0.3);
        EXPECT_LT((times_mass(X, mass) - X * MatrixXd(mass.isotropic)).norm(), 1e-13 * mass.nodal_kg.norm());
    }
}

TEST(Factors, OfPointsMultiplyAndAreOneWhereThereAreNone) {
    const VectorXd a = Vector3d(2.0, 3.0, 0.5), b = Vector3d(5.0, 0.1, 4.0), none;
    EXPECT_EQ(times_factors(none, none).size(), 0);
    EXPECT_EQ(times_factors(a, none), a);
    EXPECT_EQ(times_factors(none, b), b);
    EXPECT_LT((times_factors(a, b) - VectorXd(Vector3d(10.0, 0.3, 2.0))).norm(), 1e-15);
}

/// Damping times of a cell add; a creeping body's rates contain their factors already.
TEST(ViscousScale, IsTheDampingTimeOfTheCell) {
    test::BeamSpec spec;
    Model model = test::make_beam(spec);
    EXPECT_FALSE(is_viscous(model));
    model.damping_excess_s = {0.0, 0.02, 0.0, 0.0};
    EXPECT_TRUE(is_viscous(model)) << "one cell is enough";
    model.damping_s = 0.003;
    EXPECT_NEAR(viscous_scale(model, 0), 0.003, 1e-18);
    EXPECT_NEAR(viscous_scale(model, 1), 0.023, 1e-17);
    const Stiffness own = stiffness(model);
    ASSERT_EQ(own.viscous.size(), 4u);
    EXPECT_NEAR(own.viscous[1].mu, 0.023 * model.moduli[1].mu, 1e-12 * model.moduli[1].mu);
    EXPECT_EQ(own.elastic[1].kappa, model.moduli[1].kappa);
    model.damping_excess_s.clear();
    model.creep = material::MaxwellBranch{0.5, 0.1};
    EXPECT_EQ(viscous_scale(model, 1), 1.0);
}

}  // namespace
}  // namespace myo::model::model_numbers_tests
