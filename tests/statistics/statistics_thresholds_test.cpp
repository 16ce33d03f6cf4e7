#include <gtest/gtest.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "statistics/correlates.hpp"
#include "statistics/folds.hpp"
#include "statistics/independence_test.hpp"
#include "statistics/linear_cross_validation.hpp"
#include "statistics/nuisance_space.hpp"
#include "statistics/residual_spot.hpp"
#include "statistics/residual_tests.hpp"
#include "statistics/score_test.hpp"
#include "support/not_finite.hpp"

namespace myo::statistics::statistics_thresholds_test {
namespace {

using test::nan;

/// A series to be appended to a layout, with the sample numbers that it holds; every 0.1 s.
struct Seen {
    int trial, marker;
    std::vector<int> samples;
};

ResidualLayout layout_of(const std::vector<Seen>& all) {
    ResidualLayout layout;
    for (const Seen& one : all) {
        const Eigen::Index begin = layout.size();
        for (const int sample : one.samples) {
            layout.sample.push_back(sample);
            layout.time_s.push_back(0.1 * sample);
        }
        layout.series.push_back({one.trial, one.marker, 0, begin, layout.size()});
    }
    return layout;
}

TEST(FoldsOfTrials, AreNumberedInTheOrderOfTrialsWithData) {
    // Trial 4 has no sample: the folds are those of 2 and 9.
    const ResidualLayout layout = layout_of({{9, 0, {0, 1}}, {4, 0, {}}, {2, 0, {0}}, {9, 1, {5}}});
    const Folds folds = make_folds(layout);
    EXPECT_TRUE(folds.by_trial);
    EXPECT_EQ(folds.count, 2);
    EXPECT_EQ(folds.of_entry, (std::vector<int>{1, 1, 0, 1}));
}

TEST(FoldsOfTime, WithoutDataAreLeftOut) {
    // Four blocks of one second; nothing was seen in the second one.
    const ResidualLayout layout = layout_of({{0, 0, {0, 3, 24, 28, 35, 40}}});
    const Folds folds = make_folds(layout, {.blocks = 4});
    EXPECT_FALSE(folds.by_trial);
    EXPECT_EQ(folds.count, 3);
    EXPECT_EQ(folds.of_entry, (std::vector<int>{0, 0, 1, 1, 2, 2})) << "the last sample is in the last block";
}

TEST(FoldsOfTime, AreThoseOfTheTimeOfAllTrials) {
    // From 1 s to 5 s together.
    const ResidualLayout layout = layout_of({{0, 0, {10, 29}}, {1, 0, {31, 50}}});
    const Folds folds = time_folds(layout, {.blocks = 2});
    EXPECT_FALSE(folds.by_trial);
    EXPECT_EQ(folds.of_entry, (std::vector<int>{0, 0, 1, 1}));
    // A guard of 0.5 s reaches 0.25 s to each side of 3 s, and not beyond the ends.
    EXPECT_EQ(time_folds(layout, {.blocks = 2, .guard_s = 0.5}).of_entry, (std::vector<int>{0, -1, -1, 1}));
    EXPECT_EQ(time_folds(layout, {.blocks = 2, .guard_s = 0.19}).of_entry, (std::vector<int>{0, 0, 1, 1}));
    // One sample is one fold, whatever is asked for.
    EXPECT_EQ(make_folds(layout_of({{0, 0, {3}}}), {.blocks = 5, .guard_s = 1.0}).of_entry, (std::vector<int>{0}));
}

TEST(HeldOutFolds, LeaveWhatTheOthersHoldAThousandthOf) {
    const Folds folds{2, {0, 1}, false};
    for (const double share : {0.9e-3, 1.2e-3}) {
        // Fold 1 holds this share of the information about the parameter.
        const Eigen::MatrixXd J = Eigen::Vector2d(std::sqrt(1.0 - share), std::sqrt(share));
        const Eigen::Vector2d r(0.5, 2.0);
        const LinearCrossValidation result = linear_cross_validation(r, J, folds);
        const bool known = share > 1e-3;
        EXPECT_EQ(result.folds[0].undetermined, known ? 0 : 1);
        EXPECT_EQ(result.folds[1].undetermined, 0);
        EXPECT_EQ(result.undetermined(), known ? 0 : 1);
        // With the other fold alone the parameter moves by r / J of its entry.
        EXPECT_NEAR(result.folds[0].change(0), known ? r(1) / J(1, 0) : 0.0, 1e-9);
        EXPECT_NEAR(result.folds[1].change(0), r(0) / J(0, 0), 1e-12);
        EXPECT_NEAR(result.residual(1), r(1) - J(1, 0) * r(0) / J(0, 0), 1e-12);
    }
    EXPECT_EQ(LinearCrossValidation{}.mean_square(), 0.0);
    // Zero columns are undetermined everywhere, and harmless.
    const LinearCrossValidation none = linear_cross_validation(Eigen::Vector2d(1.0, 2.0), Eigen::Vector2d::Zero(),
                                                               folds);
    EXPECT_EQ(none.undetermined(), 2);
    EXPECT_EQ(none.squares, 5.0);
}

/// One marker for 4 s; squares of one at rest and `square` from 1 s on for `samples` samples.
std::optional<ResidualSpot> spot_of(double square, int samples) {
    std::vector<int> numbers(41);
    for (int k = 0; k < 41; ++k) numbers[static_cast<std::size_t>(k)] = k;
    const ResidualLayout layout = layout_of({{0, 0, numbers}});
    Eigen::VectorXd r = Eigen::VectorXd::Ones(41);
    r.segment(10, samples).setConstant(std::sqrt(square));
    return residual_spot(r, layout);
}

TEST(Spots, HoldFourFifthsInAtMostAQuarterOfTheTime) {
    // 40 quiet samples: one of 160 is four fifths of 200.
    const std::optional<ResidualSpot> enough = spot_of(161.0, 1);
    ASSERT_TRUE(enough);
    EXPECT_NEAR(enough->from_s, 1.0, 1e-12);
    EXPECT_EQ(enough->from_s, enough->to_s);
    EXPECT_NEAR(enough->share, 161.0 / 201.0, 1e-9);
    EXPECT_EQ(enough->markers, std::vector<int>{0});
    // Below four fifths it needs a neighbour.
    const std::optional<ResidualSpot> less = spot_of(159.0, 1);
    ASSERT_TRUE(less);
    EXPECT_NEAR(less->to_s - less->from_s, 0.1, 1e-12);
    // Ten samples last 0.9 s and thirteen 1.2 s, all of which four fifths of the squares need.
    EXPECT_TRUE(spot_of(13.0, 10));
    EXPECT_FALSE(spot_of(9.2, 13));
    EXPECT_FALSE(spot_of(1.0, 1));
}

TEST(Spots, NameTheMarkersWithNineTenthsOfTheirSquares) {
    for (const double second : {0.11, 0.12}) {
        std::vector<int> numbers(41);
        for (int k = 0; k < 41; ++k) numbers[static_cast<std::size_t>(k)] = k;
        const ResidualLayout layout = layout_of({{3, 7, numbers}, {3, 2, numbers}, {3, 5, numbers}});
        Eigen::VectorXd r = Eigen::VectorXd::Zero(layout.size());
        r(20) = 1.0, r(41 + 20) = std::sqrt(second);
        const std::optional<ResidualSpot> spot = residual_spot(r, layout);
        ASSERT_TRUE(spot);
        EXPECT_EQ(spot->trial, 3);
        // 1 of 1.11 is more than nine tenths, 1 of 1.12 is less.
        EXPECT_EQ(spot->markers, second < 0.115 ? std::vector<int>{7} : (std::vector<int>{2, 7}));
    }
}

TEST(Correlation, OfALineIsItsSign) {
    const Eigen::VectorXd t = Eigen::VectorXd::LinSpaced(30, 0.0, 1.0);
    const Eigen::VectorXd wave = (40.0 * t).array().sin();
    Eigen::VectorXd gaps = wave;
    gaps.head(5).setConstant(nan);
    const std::vector<Correlate> found = correlates(
        wave, {{"unknown", Eigen::VectorXd::Constant(30, nan)}, {"down", -3.0 * gaps.array() + 2.0}, {"time", t}});
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(found[0].name, "down");
    EXPECT_NEAR(found[0].correlation, -1.0, 1e-12);
    EXPECT_LT(found[0].p, 1e-6);
    EXPECT_LE(found[0].effective_samples, 25.0) << "of the samples that both know";
    EXPECT_EQ(found[1].name, "time");
    EXPECT_EQ(found[2].correlation, 0.0);
    EXPECT_EQ(found[2].effective_samples, 0.0);
    EXPECT_EQ(found[2].p, 1.0);
    // Offsets and units of both change nothing.
    const Correlate plain = correlates(wave, {{"t", t}})[0];
    const Correlate scaled = correlates(1e6 * wave.array() + 5.0, {{"t", -1e-6 * t.array() + 300.0}})[0];
    EXPECT_NEAR(scaled.correlation, -plain.correlation, 1e-6);
    EXPECT_NEAR(scaled.p, plain.p, 1e-5);
    EXPECT_TRUE(correlates(wave, {}).empty());
}

TEST(Directions, AreDroppedBelowTheToleranceOfTheirLength) {
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(4, 2);
    for (const double unit : {1e-12, 1.0, 1e9})
        for (const double apart : {1e-9, 1e-7}) {
            J.col(0) << unit, 0.0, 0.0, 0.0;
            J.col(1) << unit, apart * unit, 0.0, 0.0;
            EXPECT_EQ(NuisanceSpace(J).rank(), apart > 1e-8 ? 2 : 1) << unit << " " << apart;
            EXPECT_EQ(NuisanceSpace(J, 1e-10).rank(), 2);
        }
    EXPECT_EQ(NuisanceSpace(Eigen::MatrixXd::Zero(4, 2)).rank(), 0);
    EXPECT_EQ(NuisanceSpace(Eigen::MatrixXd(0, 2)).rows(), 0);
    // The remainder of a candidate is compared with its own length, 1e-6.
    const NuisanceSpace first(Eigen::MatrixXd(Eigen::Vector4d(1.0, 0.0, 0.0, 0.0)));
    for (const double rest : {0.9e-6, 1.1e-6}) {
        const ProjectedCandidate candidate = project_candidate(first, 1e5 * Eigen::Vector4d(1.0, 0.0, rest, 0.0));
        EXPECT_EQ(candidate.rank(), rest > 1e-6 ? 1 : 0);
        EXPECT_NEAR(candidate.kept(0), rest, 1e-12);
        EXPECT_NEAR(candidate.length(0), 1e5, 1e-3);
    }
}

TEST(Judgements, HaveTheirThresholdsOnTheCarefulSide) {
    struct Judged {
        double p, typical, constant;
        bool drift;
    };
    for (const Judged& one : {Judged{0.011, 0.26, 0.49, true},
                              {0.01, 0.26, 0.49, false},
                              {0.011, 0.25, 0.49, false},
                              {0.011, 0.26, 0.5, false}}) {
        const IndependenceTest test{.p = one.p, .typical_share = one.typical, .constant_share = one.constant};
        EXPECT_EQ(test.is_drift(), one.drift) << one.p << " " << one.typical << " " << one.constant;
    }
    EXPECT_FALSE(IndependenceTest{}.is_drift());
    ResidualTests tests;
    EXPECT_FALSE(tests.significant()) << "nothing was tested";
    tests.threshold = 0.0025;
    EXPECT_FALSE(tests.significant());
    for (double* p : {&tests.variance.p, &tests.ljung_box.p, &tests.periodicity.p, &tests.space.p}) {
        *p = tests.threshold;
        EXPECT_FALSE(tests.significant());
        *p = 0.99 * tests.threshold;
        EXPECT_TRUE(tests.significant());
        EXPECT_EQ(tests.variance_fired(), p == &tests.variance.p);
        EXPECT_EQ(tests.colour_fired(), p == &tests.ljung_box.p || p == &tests.periodicity.p);
        EXPECT_EQ(tests.space_fired(), p == &tests.space.p);
        *p = 1.0;
    }
    EXPECT_DOUBLE_EQ(test_residuals(Eigen::VectorXd(), {}, 0, {.alpha = 0.2}).threshold, 0.05) << "four p-values";
}

TEST(Patterns, OfOneSeriesHaveNoTestAndThoseOfTrialsAreCorrected) {
    const ResidualLayout one = layout_of({{0, 0, {0, 1, 2, 3}}});
    const SpaceTest alone = space_test(Eigen::Vector4d(1.0, -2.0, 3.0, 1.0), one);
    ASSERT_EQ(alone.trials.size(), 1u);
    EXPECT_NEAR(alone.trials[0].share, 1.0, 1e-12);
    EXPECT_EQ(alone.p, 1.0);
    EXPECT_NEAR(alone.trials[0].pattern(0), 1.0, 1e-12);
    // Two trials of two series each, of which the second one has a common course.
    const ResidualLayout two = layout_of({{0, 0, {0, 1, 2, 3, 4, 5}},
                                          {0, 1, {0, 1, 2, 3, 4, 5}},
                                          {8, 0, {0, 1, 2, 3, 4, 5}},
                                          {8, 1, {0, 1, 2, 3, 4, 5}},
                                          {9, 0, {}}});
    Eigen::VectorXd r(24);
    r << 1, 1, -1, 1, -1, 1, 1, -1, -1, -1, -1, 1, 1, -2, 1, 1, -1, 2, -2, 4, -2, -2, 2, -4;
    const SpaceTest test = space_test(r, two);
    ASSERT_EQ(test.trials.size(), 2u) << "the third trial holds nothing";
    EXPECT_EQ(test.trials[1].trial, 8);
    EXPECT_EQ(test.trials[1].series, (std::vector<int>{2, 3}));
    EXPECT_NEAR(test.trials[1].share, 1.0, 1e-12);
    // Rows are 1 to -2; the largest entry is positive, the length one.
    EXPECT_NEAR(test.trials[1].pattern(0), -1.0 / std::sqrt(5.0), 1e-9);
    EXPECT_NEAR(test.trials[1].pattern(1), 2.0 / std::sqrt(5.0), 1e-9);
    EXPECT_LT(test.trials[1].expected_share, test.trials[1].share);
    EXPECT_NEAR(test.p, std::min(1.0, 2.0 * std::min(test.trials[0].p, test.trials[1].p)), 1e-15);
}

}  // namespace
}  // namespace myo::statistics::statistics_thresholds_test
