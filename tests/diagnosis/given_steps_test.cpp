#include "diagnosis/verdict/given_steps.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <memory>

#include "diagnosis/made_problem.hpp"
#include "support/swung_beam.hpp"

namespace myo::diagnosis::given_steps_test {
namespace {

/// Context of a search with steps of 8 and 5 ms, four times and as long as the given ones.
DiagnosisContext lengthened(setup::Setup setup) {
    DiagnosisContext context{setup, {}, test::made_data(10), {}, {}, {}};
    context.step_factors = {4.0, 1.0};
    context.setup.trials[0].options.h_s = 0.008;
    context.setup.trials[1].options.h_s = 0.005;
    context.setup.trials[0].options.max_iterations = 100;
    context.setup.trials[1].options.max_iterations = std::numeric_limits<int>::max();
    context.refinement.finer = std::make_shared<const setup::Setup>(context.setup);
    context.refinement.unmatched.effective_modulus = {
        .mesh = -0.04, .finer_mesh = -0.01, .step = 0.02, .finer_step = 0.005};
    context.setup.modulus_factor = context.refinement.unmatched.effective_modulus.factor();
    return context;
}

JudgedFit fit_with(const std::string& effect) {
    JudgedFit fit;
    fit.fit = test::made_fit(Eigen::VectorXd::Zero(10), Eigen::VectorXd::Ones(10));
    fit.fit.effects = {{effect, {}}};
    fit.numerics.emplace();
    return fit;
}

TEST(GivenSteps, AreNeededByForcesWithACornerAfterLongerSteps) {
    const test::Folder folder("given_steps_needed");
    DiagnosisContext context = lengthened(test::swung_beam(folder));
    EXPECT_TRUE(needs_given_steps(context, fit_with("dry_friction")));
    EXPECT_FALSE(needs_given_steps(context, fit_with("quadratic_drag")));
    context.step_factors = {1.0, 1.0};
    EXPECT_FALSE(needs_given_steps(context, fit_with("dry_friction"))) << "the steps are the given ones";
    context.step_factors.clear();
    EXPECT_FALSE(needs_given_steps(context, fit_with("dry_friction"))) << "the steps are the given ones";
}

TEST(GivenSteps, KeepTheMotionOfTheCellsAndForgetWhatBelongsToLongerSteps) {
    const test::Folder folder("given_steps");
    const DiagnosisContext before = lengthened(test::swung_beam(folder));
    const JudgedFit fit = fit_with("dry_friction");
    const FitWithSteps given = with_given_steps(before, fit);
    for (const setup::Setup* setup : {&given.context.setup, given.context.refinement.finer.get()}) {
        EXPECT_DOUBLE_EQ(setup->trials[0].options.h_s, 0.002);
        EXPECT_DOUBLE_EQ(setup->trials[1].options.h_s, 0.005);
        EXPECT_EQ(setup->trials[0].options.max_iterations, 400) << "for four times the steps";
        EXPECT_EQ(setup->trials[1].options.max_iterations, std::numeric_limits<int>::max());
    }
    EXPECT_FALSE(needs_given_steps(given.context, fit));
    // The modulus of the cells, E times the factor, is what the motion depends on.
    EXPECT_DOUBLE_EQ(given.context.setup.modulus_factor, 1.0 - 0.04) << "of the mesh alone";
    EXPECT_NEAR(given.fit.fit.values.youngs_modulus_Pa * given.context.setup.modulus_factor,
                fit.fit.values.youngs_modulus_Pa * before.setup.modulus_factor, 1e-9 * test::made_modulus_Pa);
    const EffectiveModulus& modulus = given.context.refinement.unmatched.effective_modulus;
    EXPECT_DOUBLE_EQ(modulus.factor_of_finer_mesh(), 1.0 - 0.01);
    EXPECT_DOUBLE_EQ(modulus.factor_of_finer_step(), modulus.factor());
    EXPECT_FALSE(given.fit.numerics);
    EXPECT_TRUE(warm_start_of(given.fit.fit).names.empty()) << "derivatives are computed with the given steps";
    EXPECT_EQ(given.fit.fit.residual, fit.fit.residual);
}

}  // namespace
}  // namespace myo::diagnosis::given_steps_test
