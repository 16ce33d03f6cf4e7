#include "diagnosis/discretisation/effective_modulus.hpp"

#include <gtest/gtest.h>

#include "diagnosis/diagnosis.hpp"
#include "diagnosis/discretisation/refinement.hpp"
#include "prediction/predict_trials.hpp"
#include "support/swung_beam.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::VectorXd;

/// Cells of 15 mm swing too fast or too slow. With the modulus that makes up for it at one modulus of the body, they
/// come nearer to finer cells at another one than with positions shifted alone.
TEST(EffectiveModulus, OfCellsHoldsForOtherMotionsWhereAShiftDoesNot) {
    const test::Folder folder("stiffening");
    setup::Setup setup = test::swung_beam(folder, 0.4);
    setup.noise_m.setConstant(2e-5);  // so that the mesh's error matters
    const FitData data = fit_data(setup, {0});
    const prediction::ParameterValues here = prediction::declared_values(setup);
    prediction::ParameterValues there = here;
    there.youngs_modulus_Pa *= 1.15;

    const Refinement refinement = refined(setup, true, NumericsPolicy{}, {});
    const NumericalError plain = error_at({setup, refinement, here, data.trials}, NumericsPolicy{}, {});
    const std::optional<NumericalError> found = match_modulus(setup, here, data, plain, NumericsPolicy{}, {});
    ASSERT_TRUE(found);
    const NumericalError& matched = *found;
    EXPECT_NE(matched.effective_modulus.mesh, 0.0);
    EXPECT_LT(std::abs(matched.effective_modulus.factor() - 1.0), 0.15);
    EXPECT_LT(matched.rest_rms_m, 0.4 * plain.rest_rms_m);

    // What a finer mesh and step say of the other motion.
    const VectorXd coarse = flat_residual(data, prediction::predict_trials_with(setup, there, data.trials));
    const VectorXd limit = coarse +
                           flat_shift(data,
                                      error_at({setup, refinement, there, data.trials}, NumericsPolicy{}, {}).shift);
    setup::Setup softer = setup;
    softer.modulus_factor = matched.effective_modulus.factor();
    const VectorXd by_modulus = flat_residual(data, prediction::predict_trials_with(softer, there, data.trials)) +
                                flat_shift(data, matched.shift);
    const VectorXd by_shift = coarse + flat_shift(data, plain.shift);
    EXPECT_LT((by_modulus - limit).norm(), 0.5 * (by_shift - limit).norm());
}

TEST(EffectiveModulus, IsLeftAloneWhereTheErrorIsFarBelowTheNoise) {
    const test::Folder folder("stiffening_small");
    setup::Setup setup = test::swung_beam(folder, 0.2);
    setup.noise_m.setConstant(0.05);
    const FitData data = fit_data(setup, {0});
    const prediction::ParameterValues values = prediction::declared_values(setup);
    const Refinement refinement = refined(setup, true, NumericsPolicy{}, {});
    const NumericalError error = error_at({setup, refinement, values, data.trials}, NumericsPolicy{}, {});
    EXPECT_FALSE(match_modulus(setup, values, data, error, NumericsPolicy{}, {}));
}

}  // namespace
}  // namespace myo::diagnosis
