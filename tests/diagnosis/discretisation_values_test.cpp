#include <gtest/gtest.h>

#include "diagnosis/discretisation/discretisation_match.hpp"
#include "diagnosis/made_problem.hpp"
#include "diagnosis/screening/debiased_start.hpp"

// Corrections of the discretisation on made-up fits of one modulus: closed forms without a run.

namespace myo::diagnosis::discretisation_values_test {
namespace {

using Eigen::VectorXd;

constexpr int samples = 4;
constexpr double E = test::made_modulus_Pa;

/// Residual changes by 10 noise levels along the first entry if the modulus doubles.
JointFit fit() { return test::made_fit(VectorXd::Ones(samples), 10.0 * VectorXd::Unit(samples, 0)); }

PredictionShift shift_of(const VectorXd& over_noise) { return test::made_shift({test::made_noise_m * over_noise}); }

TEST(DiscretisationValues, StepErrorsFallWithTheSquare) {
    EXPECT_NEAR(step_extrapolation(NumericsPolicy{}), 4.0 / 3.0, 1e-15) << "half the step has a quarter of the error";
    NumericsPolicy first_order;
    first_order.step_order = 1.0;
    EXPECT_NEAR(step_extrapolation(first_order), 2.0, 1e-15);
}

/// A finer mesh that moves like a modulus higher by 5 %: the parameters undo it, the rest they leave.
TEST(DiscretisationValues, MatchUndoesWhatTheModulusCan) {
    const FitData data = test::made_data(samples);
    NumericalError error;
    error.step_shift = shift_of(step_extrapolation(NumericsPolicy{}) * 0.3 * VectorXd::Unit(samples, 0));
    error.mesh_change = shift_of(0.5 * VectorXd::Unit(samples, 0) + 2.0 * VectorXd::Unit(samples, 2));
    const MatchedValues matched = match_discretisation(data, fit(), error, NumericsPolicy{});
    EXPECT_NEAR(matched.setup.youngs_modulus_Pa, E, 1e-9);
    EXPECT_NEAR(matched.finer_step.youngs_modulus_Pa, 0.97 * E, 1e-6);
    EXPECT_NEAR(matched.finer_mesh.youngs_modulus_Pa, 0.95 * E, 1e-6);
    // The next iteration starts from the matched values.
    error.matched = matched;
    EXPECT_NEAR(match_discretisation(data, fit(), error, NumericsPolicy{}).finer_mesh.youngs_modulus_Pa, 0.90 * E,
                1e-6);
}

TEST(DiscretisationValues, MatchStaysWithinTheBounds) {
    NumericalError error;
    error.step_shift = shift_of(VectorXd::Zero(samples));
    error.mesh_change = shift_of(9.0 * VectorXd::Unit(samples, 0));
    const FitData data = test::made_data(samples);
    EXPECT_NEAR(match_discretisation(data, fit(), error, NumericsPolicy{}).finer_mesh.youngs_modulus_Pa, 0.5 * E, 1e-6);
}

/// The limit lies 4/3 of the change beyond by the step, and by the factor of the mesh.
TEST(DiscretisationValues, ParametersAreExtrapolated) {
    MatchedValues matched;
    matched.setup.youngs_modulus_Pa = E;
    matched.finer_step.youngs_modulus_Pa = 0.97 * E;
    matched.finer_mesh.youngs_modulus_Pa = 0.95 * E;
    EXPECT_NEAR(extrapolated_values(fit(), matched, 2.0, NumericsPolicy{}).youngs_modulus_Pa, (1.0 - 0.04 - 0.10) * E,
                1e-6);
    JointFit moved = fit();
    moved.values.youngs_modulus_Pa = 1.2 * E;
    const MatchedValues there = moved_match(moved, matched);
    EXPECT_NEAR(there.setup.youngs_modulus_Pa, 1.20 * E, 1e-6);
    EXPECT_NEAR(there.finer_step.youngs_modulus_Pa, 1.17 * E, 1e-6);
    EXPECT_NEAR(there.finer_mesh.youngs_modulus_Pa, 1.15 * E, 1e-6);
}

/// The doubt is a share of the shift that the modulus does not take up; independent between trials.
TEST(DiscretisationValues, DoubtIsWhatTheParametersCannotCompensate) {
    const FitData data = test::made_data(samples, 2);
    JointFit of_both = test::made_fit(VectorXd::Ones(2 * samples), VectorXd::Unit(2 * samples, 0));
    NumericalError error;
    const VectorXd one = VectorXd::Unit(samples, 2), none = VectorXd::Zero(samples);
    const auto left = [&](const VectorXd& first, const VectorXd& second) {
        error.shift = test::made_shift({test::made_noise_m * first, test::made_noise_m * second});
        return extrapolation_left_m(data, error, of_both, NumericsPolicy{}) /
               (NumericsPolicy{}.extrapolation_doubt * test::made_noise_m / std::sqrt(2.0 * samples));
    };
    EXPECT_NEAR(left(VectorXd::Unit(samples, 0), none), 0.0, 1e-9);
    EXPECT_NEAR(left(one, none), 1.0, 1e-9);
    EXPECT_NEAR(left(one, one), std::sqrt(2.0), 1e-9);
    EXPECT_NEAR(left(3.0 * one, 4.0 * one), 5.0, 1e-9);
    // An effective modulus was found, but this fit does not move the modulus: its share counts, too.
    error.by_modulus = test::made_shift({test::made_noise_m * one, test::made_noise_m * none});
    EXPECT_NEAR(left(one, none), 1.0, 1e-9);
    of_both.parameters[0].kind = prediction::ModelParameter::Kind::damping;
    EXPECT_NEAR(left(one, none), 2.0, 1e-9);
}

TEST(DiscretisationValues, MissingShiftsAreTakenFromTheOtherError) {
    NumericalError own, other;
    own.shift = own.step_shift = {shift_of(VectorXd::Ones(samples))[0], {}};
    other.shift = other.step_shift = {shift_of(VectorXd::Zero(samples))[0], shift_of(3.0 * VectorXd::Ones(samples))[0]};
    own.left_rms_m = 1.0;
    const NumericalError both = completed(own, other);
    EXPECT_EQ(both.shift[0][0](0, 0), own.shift[0][0](0, 0)) << "its own shift stays";
    EXPECT_EQ(both.shift[1][0](0, 0), other.shift[1][0](0, 0));
    EXPECT_EQ(both.step_shift[1][0](0, 0), other.shift[1][0](0, 0));
    EXPECT_EQ(both.left_rms_m, 1.0);
}

TEST(DiscretisationValues, EffectiveModuliMultiplyTheCells) {
    const EffectiveModulus none, found{0.1, 0.02, 0.03, 0.01};
    EXPECT_FALSE(none.any());
    EXPECT_EQ(none.factor(), 1.0);
    EXPECT_TRUE(found.any());
    EXPECT_NEAR(found.factor(), 1.13, 1e-15);
    EXPECT_NEAR(found.factor_of_finer_mesh(), 1.05, 1e-15);
    EXPECT_NEAR(found.factor_of_finer_step(), 1.11, 1e-15);
}

TEST(JointFitValues, ChangeBetweenFitsIsFirstOrder) {
    const JointFit a = fit();
    JointFit b = a;
    b.values.youngs_modulus_Pa *= 1.2;
    EXPECT_NEAR(change_between(a, b), 10.0 * 0.2 / std::sqrt(samples), 1e-9);
    EXPECT_NEAR(change_between(a, a), 0.0, 1e-15);
    EXPECT_NEAR(a.squares(), 4.0, 1e-12);
    EXPECT_EQ(a.excess(), 0.0);
    JointFit c = a;
    c.residual *= 2.0;
    EXPECT_NEAR(c.excess(), 12.0, 1e-12);
    c.report.evaluations = 3;
    c.report.jacobians = 2;
    EXPECT_EQ(c.runs(5), 25);
}

/// Damping that is three times the expected one, and a start at its bound, are reset; the modulus stays.
TEST(DebiasedStart, ResetsDistortedParametersOnly) {
    JointFit of = fit();
    prediction::ModelParameter damping, start;
    damping.kind = prediction::ModelParameter::Kind::damping;
    start.kind = prediction::ModelParameter::Kind::start_shift;
    start.parameter.lower = -0.01;
    start.parameter.upper = 0.02;
    of.parameters.insert(of.parameters.end(), {damping, start});
    prediction::ParameterValues expected = of.values;
    expected.damping_s = 0.004;
    expected.start_shift_s = {0.0};
    of.values.youngs_modulus_Pa = 2.0 * E;
    const auto reset = [&](double damping_s, double start_s) {
        of.values.damping_s = damping_s;
        of.values.start_shift_s = {start_s};
        return debiased_start(of, expected, DeclaredFitPolicy{});
    };
    const double most = DeclaredFitPolicy{}.max_damping_ratio * 0.004;
    EXPECT_FALSE(reset(0.999 * most, 0.019));
    const auto damped = reset(1.001 * most, 0.019);
    ASSERT_TRUE(damped);
    EXPECT_EQ(damped->damping_s, 0.004);
    EXPECT_EQ(damped->start_shift_s[0], 0.019);
    EXPECT_EQ(damped->youngs_modulus_Pa, 2.0 * E);
    for (const double bound : {-0.01, 0.02}) {
        const auto shifted = reset(0.004, bound);
        ASSERT_TRUE(shifted);
        EXPECT_EQ(shifted->start_shift_s[0], 0.0);
    }
}

}  // namespace
}  // namespace myo::diagnosis::discretisation_values_test
