#include "statistics/residual_spot.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace myo::statistics {
namespace {

constexpr int trial_samples = 100;
constexpr double dt_s = 0.01;

/// Trials 2 and 5 with three markers each, 1 s long.
ResidualLayout two_trials() {
    ResidualLayout layout;
    for (const int trial : {2, 5})
        for (int marker = 0; marker < 3; ++marker)
            for (int axis = 0; axis < 3; ++axis) {
                const Eigen::Index begin = layout.size();
                for (int t = 0; t < trial_samples; ++t) {
                    layout.sample.push_back(t);
                    layout.time_s.push_back(dt_s * t);
                }
                layout.series.push_back({trial, marker, axis, begin, layout.size()});
            }
    return layout;
}

TEST(ResidualSpot, TellsTrialTimeAndMarkers) {
    const ResidualLayout layout = two_trials();
    Eigen::VectorXd r = Eigen::VectorXd::Constant(layout.size(), 0.5);
    for (const ResidualSeries& series : layout.series)
        if (series.trial == 5 && series.marker != 1 && series.axis == 1)
            r.segment(series.begin + 60, 10).setConstant(20.0);
    const std::optional<ResidualSpot> spot = residual_spot(r, layout);
    ASSERT_TRUE(spot);
    EXPECT_EQ(spot->trial, 5);
    EXPECT_EQ(spot->markers, (std::vector<int>{0, 2}));
    EXPECT_GE(spot->from_s, 0.6 - 1e-12);
    EXPECT_LE(spot->to_s, 0.69 + 1e-12);
    EXPECT_GE(spot->share, 0.8);
    // The shortest time that holds four fifths: eight or nine of ten equal trial_samples.
    EXPECT_GE(spot->to_s - spot->from_s, 0.07 - 1e-12);
}

/// Neither where all is alike, nor in a swing that decays, nor where nothing is left, nor where two trials share it.
TEST(ResidualSpot, IsNotSeenInWhatLasts) {
    const ResidualLayout layout = two_trials();
    EXPECT_FALSE(residual_spot(Eigen::VectorXd::Zero(layout.size()), layout));
    EXPECT_FALSE(residual_spot(Eigen::VectorXd::Ones(layout.size()), layout));
    Eigen::VectorXd swing(layout.size()), twice = Eigen::VectorXd::Zero(layout.size());
    for (Eigen::Index k = 0; k < layout.size(); ++k) {
        const double t = layout.time_s[static_cast<std::size_t>(k)];
        swing(k) = std::exp(-2.0 * t) * std::cos(30.0 * t);
        if (t > 0.3 && t < 0.4) twice(k) = 1.0;
    }
    EXPECT_FALSE(residual_spot(swing, layout));
    EXPECT_FALSE(residual_spot(twice, layout));
}

}  // namespace
}  // namespace myo::statistics
