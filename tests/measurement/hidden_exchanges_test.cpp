#include "measurement/hidden_exchanges.hpp"

#include <gtest/gtest.h>

#include "measurement/marker_predictor.hpp"
#include "measurement/swinging_markers.hpp"

namespace myo::measurement {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using test::swinging_markers;

Eigen::VectorXd noise_of_five(double noise_m) { return Eigen::VectorXd::Constant(5, noise_m); }

/// Two markers hidden before a sample, and exchanged from there to an end.
void exchange_behind_gap(std::vector<Matrix3Xd>& truth, std::vector<Matrix3Xd>& tracks, std::size_t i, std::size_t j,
                         Index at, Index end) {
    for (const std::size_t k : {i, j}) test::hide(truth[k], at - 10, at);
    tracks = truth;
    tracks[i].middleCols(at, end - at) = truth[j].middleCols(at, end - at);
    tracks[j].middleCols(at, end - at) = truth[i].middleCols(at, end - at);
}

TEST(HiddenExchanges, ArePutBackWhateverTheBodyDidInTheGap) {
    for (const double noise : {1e-5, 1e-4})
        for (unsigned seed = 1; seed <= 5; ++seed)
            for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{0, 4}, {3, 4}, {1, 2}})
                for (const Index at : {30, 100})
                    for (const Index end : {at + 12, Index{120}}) {
                        std::vector<Matrix3Xd> truth = swinging_markers(noise, seed), tracks;
                        exchange_behind_gap(truth, tracks, i, j, at, end);
                        const std::vector<Exchange> found = put_back_hidden_exchanges(tracks, noise_of_five(noise));
                        ASSERT_EQ(found.size(), 1u) << noise << " " << seed << " " << i << j << " " << at << " " << end;
                        EXPECT_EQ(found[0].markers, (std::vector<std::size_t>{i, j}));
                        EXPECT_EQ(found[0].first, at);
                        EXPECT_EQ(found[0].end, end);
                        for (const std::size_t k : {i, j})
                            EXPECT_EQ((tracks[k].rightCols(120 - at) - truth[k].rightCols(120 - at)).norm(), 0.0);
                    }
}

/// Gaps anywhere, a slip in a common gap, and an exchange in full view, which may be an effect.
TEST(HiddenExchanges, AreNotSeenInOtherThings) {
    for (const double noise : {0.0, 1e-4, 5e-4})
        for (unsigned seed = 1; seed <= 20; ++seed) {
            std::mt19937 random(seed);
            std::vector<Matrix3Xd> tracks = swinging_markers(noise, seed);
            for (Matrix3Xd& track : tracks)
                for (int gap = 0; gap < 3; ++gap) {
                    const Index first = std::uniform_int_distribution<Index>(1, 95)(random);
                    test::hide(track, first, first + std::uniform_int_distribution<Index>(1, 20)(random));
                }
            EXPECT_TRUE(put_back_hidden_exchanges(tracks, noise_of_five(noise)).empty()) << noise << " " << seed;
            tracks = swinging_markers(noise, seed);
            tracks[3].rightCols(60).colwise() += Eigen::Vector3d(0.0, 0.01, 0.0);
            for (const std::size_t k : {3u, 4u}) test::hide(tracks[k], 50, 60);
            EXPECT_TRUE(put_back_hidden_exchanges(tracks, noise_of_five(noise)).empty()) << noise << " " << seed;
        }
    std::vector<Matrix3Xd> visible = swinging_markers(1e-4, 1);
    const Matrix3Xd tail = visible[1].rightCols(60);
    visible[1].rightCols(60) = visible[2].rightCols(60);
    visible[2].rightCols(60) = tail;
    EXPECT_TRUE(put_back_hidden_exchanges(visible, noise_of_five(1e-4)).empty());
    std::vector<Matrix3Xd> none;
    EXPECT_TRUE(put_back_hidden_exchanges(none, Eigen::VectorXd()).empty());
}

/// Two motions determine a marker, also where one of those that show them is hidden.
TEST(MarkerPredictor, FollowsTheOthersAndSaysHowSurely) {
    std::vector<Matrix3Xd> tracks = swinging_markers(1e-5, 3);
    test::hide(tracks[1], 40, 60);
    const MarkerPredictor predictor(tracks, 4, 1e-5);
    ASSERT_TRUE(predictor.is_usable());
    EXPECT_EQ(predictor.samples().size(), 120u) << "three others are enough";
    const auto fit = predictor.fit(40, 60);
    ASSERT_TRUE(fit);
    EXPECT_LT(fit->largest_m, 5e-4);
    for (std::size_t place = 40; place < 60; ++place) {
        EXPECT_LT(predictor.distance(*fit, place), 1e-3) << place;
        EXPECT_GT(predictor.widening(*fit, place), 1.0);
    }
    EXPECT_FALSE(MarkerPredictor(tracks, 4, 1e-5, {0, 1, 2}).is_usable()) << "one other marker";
    EXPECT_FALSE(predictor.fit(0, 118)) << "too few samples";
}

}  // namespace
}  // namespace myo::measurement
