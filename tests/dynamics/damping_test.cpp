#include <gtest/gtest.h>

#include <numbers>

#include "dynamics/material_damping.hpp"
#include "support/beam.hpp"
#include "support/figures.hpp"
#include "support/oscillation.hpp"

namespace myo::dynamics {
namespace {

using Eigen::VectorXd;

using std::numbers::pi;

/// The decay of runs is what their own viscous forces take from the mode, also where the body is compressible and
/// sagged.
TEST(MaterialDamping, SmallVibrationsDecayByTheFactorOfTheirMode) {
    for (const char* element : {"hex8", "tet10"})
        for (const double nu : {0.3, 0.499}) {
            test::BeamSpec spec = test::ringing_beam();
            spec.kind = test::element(element);
            // Of tet10 what resists at the points besides distortion is not damped: the less the more layers there are.
            if (spec.kind == fem::ElementKind::tet10) spec.cells = {10, 3, 3};
            spec.poissons_ratio = nu;
            spec.damping_s = 0.002;
            const model::Model model = test::held(spec);
            const NaturalMode mode = test::first_mode(model);
            const double factor = damping_factor(model, model.body->mesh.nodes, mode),
                         h = 2.0 * pi / mode.omega_rad_s / 60.0;
            const VectorXd q = test::ring(model, mode, Integrator::tr_bdf2, h, 60);
            ASSERT_GT(q.size(), 0);
            const double error = test::fit_oscillation(q, h).damping_ratio /
                                     damping_ratio(factor, spec.damping_s, mode.omega_rad_s) -
                                 1.0;
            const std::string name = std::string(element) + (nu < 0.4 ? "_compressible" : "");
            test::record(name + "_error", error);
            test::record(name + "_factor_over_slender", factor / slender_damping_factor(nu));
            EXPECT_LT(std::abs(error), 0.01) << element << " " << nu;
            EXPECT_NEAR(factor / slender_damping_factor(nu), 1.0, 0.04)
                << element << " " << nu << ": it is three times as long as thick";
        }
}

/// The first modes of a slender bar: it bends to two sides, with no node and with one, then it is twisted.
TEST(MaterialDamping, OfSlenderBendingAndTorsionHasItsClosedForm) {
    for (const double nu : {0.3, 0.49}) {
        test::BeamSpec spec;
        spec.cells = {30, 2, 2};
        spec.size = {0.3, 0.02, 0.02};
        spec.poissons_ratio = nu;
        const model::Model model = test::make_beam(spec);
        StageSolver solver(model);
        const NaturalModes found = natural_modes(solver, model.body->mesh.nodes, 5);
        ASSERT_TRUE(found.ok());
        std::vector<double> factors;
        for (const NaturalMode& mode : found.modes)
            factors.push_back(damping_factor(model, model.body->mesh.nodes, mode));
        test::record("factors_" + format_number(nu), factors);
        EXPECT_NEAR(factors[0], slender_damping_factor(nu), 0.012);
        EXPECT_NEAR(factors[1], slender_damping_factor(nu), 0.012);
        EXPECT_NEAR(factors[4], 1.0, 0.002);
        EXPECT_LT((found.modes[4].shape * test::tip_share(model, spec)).norm(),
                  1e-3 * found.modes[4].shape.cwiseAbs().maxCoeff())
            << "the twisted end stays in its place";
    }
}

/// A plate so wide that its middle cannot become narrower where it is stretched. Few layers of cells have their own
/// part in it: what resists the bending within compressible hexahedra is all damped, and of tet10 what resists at the
/// points is not.
TEST(MaterialDamping, OfAWidePlateHasItsClosedForm) {
    for (const double nu : {0.3, 0.49}) {
        const double plate = 2.0 * (1.0 - nu + nu * nu) / (3.0 * (1.0 - nu));
        const auto error = [&](fem::ElementKind kind, const Eigen::Vector3i& cells) {
            test::BeamSpec spec;
            spec.kind = kind;
            spec.cells = cells;
            spec.size = {0.1, 0.6, 0.008};
            spec.poissons_ratio = nu;
            const model::Model model = test::make_beam(spec);
            return damping_factor(model, model.body->mesh.nodes, test::first_mode(model)) - plate;
        };
        const double two = error(fem::ElementKind::hex8, {12, 16, 2}),
                     four = error(fem::ElementKind::hex8, {12, 16, 4}),
                     tets = error(fem::ElementKind::tet10, {10, 14, 2});
        test::record("errors_" + format_number(nu), {two, four, tets});
        EXPECT_NEAR(two, 0.0, 0.04);
        EXPECT_NEAR(four, 0.0, 0.012);
        EXPECT_NEAR(tets, 0.0, 0.045);
    }
}

/// An experiment tells the time whether the body creeps or not, and its ratio does not depend on it.
TEST(MaterialDamping, IsNotThatOfACreepingBranch) {
    model::Model model = test::make_beam(test::ringing_beam());
    const NaturalMode mode = test::first_mode(model);
    const double factor = damping_factor(model, model.body->mesh.nodes, mode);
    model.creep = material::MaxwellBranch{0.5, 0.1};
    model.damping_s = 0.004;
    EXPECT_EQ(damping_factor(model, model.body->mesh.nodes, mode), factor);
}

}  // namespace
}  // namespace myo::dynamics
