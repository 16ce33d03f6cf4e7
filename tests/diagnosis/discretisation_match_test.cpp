#include "diagnosis/discretisation/discretisation_match.hpp"
#include "diagnosis/unmoved_fit.hpp"

#include <gtest/gtest.h>

#include "diagnosis/discretisation/refinement.hpp"
#include "support/figures.hpp"
#include "support/recorded_motion.hpp"
#include "support/swung_beam.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::VectorXd;

/// A beam of coarse cells with a fit of its modulus, and the errors found with values that move alike, step by step.
struct Matched {
    test::Folder folder{"matched_values"};
    setup::Setup setup;
    FitData data;
    JointFit fit;
    Refinement refinement;
    NumericalError plain;
    MatchedValues matched;
    NumericalError error;

    explicit Matched(bool refine_mesh)
        : setup(short_swing(folder)),
          data(fit_data(setup, {0})),
          fit(test::unmoved_fit(setup, data, prediction::declared_values(setup))),
          refinement(refined(setup, refine_mesh, NumericsPolicy{}, {})) {
        plain = error_at({setup, refinement, fit.values, data.trials}, NumericsPolicy{}, {});
        error = plain;
        for (int step = 0; step < 3; ++step) {
            matched = match_discretisation(data, fit, error, NumericsPolicy{});
            error = error_at({setup, refinement, fit.values, data.trials, nullptr, &matched}, NumericsPolicy{}, {});
        }
    }

    static setup::Setup short_swing(const test::Folder& folder) {
        setup::Setup setup = test::swung_beam(folder, 0.4);
        setup.noise_m.setConstant(2e-5);  // so that the mesh's error matters
        return setup;
    }
    VectorXd motion(const setup::Setup& of, const prediction::ParameterValues& values) const {
        return flat_residual(data, prediction::predict_trials_with(of, values, data.trials));
    }
};

TEST(MatchedValues, LeaveLittleOfTheError) {
    const Matched of(true);
    const double left = shift_rms_m(of.error.shift) / shift_rms_m(of.plain.shift);
    test::record("left", left);
    EXPECT_LT(left, 0.4);
}

TEST(MatchedValues, MoveAsPredictedAtTheLimitOfTheStep) {
    const Matched of(false);
    setup::Setup finest = of.setup;
    for (setup::PreparedTrial& trial : finest.trials) trial.options.h_s *= 0.125;
    const VectorXd coarse = of.motion(of.setup, of.fit.values);
    const VectorXd predicted = coarse + flat_shift(of.data, of.error.shift);
    const double left = (of.motion(finest,
                                   extrapolated_values(of.fit, of.matched, of.error.mesh_factor, NumericsPolicy{})) -
                         predicted)
                            .norm();
    const double was = (of.motion(finest, of.fit.values) - coarse).norm();
    test::record("left", left / was);
    EXPECT_LT(left, 0.2 * was);
}

TEST(MatchedValues, GiveOnePredictionWhateverTheValuesItIsWrittenFor) {
    const Matched of(true);
    const prediction::ParameterValues limit = extrapolated_values(of.fit, of.matched, of.error.mesh_factor,
                                                                  NumericsPolicy{});
    const NumericalError there = error_at({of.setup, of.refinement, limit, of.data.trials, nullptr, &of.matched},
                                          NumericsPolicy{}, {});
    const VectorXd at_fit = of.motion(of.setup, of.fit.values) + flat_shift(of.data, of.error.shift);
    const VectorXd at_limit = of.motion(of.setup, limit) + flat_shift(of.data, there.shift);
    EXPECT_LT((at_limit - at_fit).norm(), 1e-6 * at_fit.norm());
    ASSERT_TRUE(there.matched);
    EXPECT_EQ(there.matched->finer_mesh.youngs_modulus_Pa, of.matched.finer_mesh.youngs_modulus_Pa);
}

TEST(MatchedValues, MoveAlongWithTheFit) {
    const Matched of(true);
    JointFit moved = of.fit;
    moved.values.youngs_modulus_Pa *= 1.1;
    const MatchedValues there = moved_match(moved, of.matched);
    EXPECT_EQ(there.setup.youngs_modulus_Pa, moved.values.youngs_modulus_Pa);
    EXPECT_NEAR(there.finer_mesh.youngs_modulus_Pa - there.setup.youngs_modulus_Pa,
                of.matched.finer_mesh.youngs_modulus_Pa - of.matched.setup.youngs_modulus_Pa, 1e-6);
}

}  // namespace
}  // namespace myo::diagnosis
