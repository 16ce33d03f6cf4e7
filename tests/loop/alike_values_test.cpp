#include "loop/alike_values.hpp"

#include <gtest/gtest.h>

#include "loop/error_finder.hpp"
#include "support/figures.hpp"
#include "swung_beam.hpp"

namespace myo {
namespace {

using Eigen::VectorXd;

/// A beam of coarse cells with a fit of its modulus, and the errors found with values that move alike, step by step.
struct Matched {
    test::Folder folder{"alike_values"};
    Study study;
    FitData data;
    JointFit fit;
    ErrorFinder errors;
    NumericalError plain;
    AlikeValues alike;
    NumericalError error;

    explicit Matched(bool refine_mesh) : study(short_swing(folder)), data(fit_data(study, {0})), fit(test::unmoved_fit(study, data, declared_values(study))), errors(study, refine_mesh) {
        plain = errors.at(fit.values, data.trials, nullptr, {});
        error = plain;
        for (int step = 0; step < 3; ++step) {
            alike = more_alike(data, fit, error);
            error = errors.at(fit.values, data.trials, nullptr, {}, &alike);
        }
    }

    static Study short_swing(const test::Folder& folder) {
        Study study = test::swung_beam(folder, 0.4);
        study.noise_m.setConstant(2e-5);   // so that the mesh's error matters
        return study;
    }
    VectorXd motion(const Study& of, const StudyValues& values) const { return flat_residual(data, predict_trials_with(of, values, data.trials)); }
};

TEST(AlikeValues, LeaveLittleOfTheError) {
    const Matched of(true);
    const double left = shift_rms_m(of.error.shift) / shift_rms_m(of.plain.shift);
    test::record("left", left);
    EXPECT_LT(left, 0.4);
}

TEST(AlikeValues, MoveAsPredictedAtTheLimitOfTheStep) {
    const Matched of(false);
    Study finest = of.study;
    for (StudyTrial& trial : finest.trials) trial.options.h_s *= 0.125;
    const VectorXd coarse = of.motion(of.study, of.fit.values);
    const VectorXd predicted = coarse + flat_shift(of.data, of.error.shift);
    const double left = (of.motion(finest, at_the_limit(of.fit, of.alike, of.error.mesh_factor)) - predicted).norm();
    const double was = (of.motion(finest, of.fit.values) - coarse).norm();
    test::record("left", left / was);
    EXPECT_LT(left, 0.2 * was);
}

TEST(AlikeValues, GiveOnePredictionWhateverTheValuesItIsWrittenFor) {
    Matched of(true);
    const StudyValues limit = at_the_limit(of.fit, of.alike, of.error.mesh_factor);
    const NumericalError there = of.errors.at(limit, of.data.trials, nullptr, {}, &of.alike);
    const VectorXd at_fit = of.motion(of.study, of.fit.values) + flat_shift(of.data, of.error.shift);
    const VectorXd at_limit = of.motion(of.study, limit) + flat_shift(of.data, there.shift);
    EXPECT_LT((at_limit - at_fit).norm(), 1e-6 * at_fit.norm());
    ASSERT_TRUE(there.alike);
    EXPECT_EQ(there.alike->finer_mesh.youngs_modulus_Pa, of.alike.finer_mesh.youngs_modulus_Pa);
}

TEST(AlikeValues, MoveAlongWithTheFit) {
    const Matched of(true);
    JointFit moved = of.fit;
    moved.values.youngs_modulus_Pa *= 1.1;
    const AlikeValues there = moved_to(moved, of.alike);
    EXPECT_EQ(there.study.youngs_modulus_Pa, moved.values.youngs_modulus_Pa);
    EXPECT_NEAR(there.finer_mesh.youngs_modulus_Pa - there.study.youngs_modulus_Pa, of.alike.finer_mesh.youngs_modulus_Pa - of.alike.study.youngs_modulus_Pa, 1e-6);
}

}  // namespace
}  // namespace myo
