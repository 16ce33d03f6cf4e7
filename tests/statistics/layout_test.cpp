#include <gtest/gtest.h>

#include <limits>

#include "noise.hpp"
#include "statistics/distributions.hpp"

namespace myo::statistics {
namespace {

using test::make_layout;

TEST(ResidualLayout, TellsWhatDoesNotFitTogether) {
    const ResidualLayout good = make_layout({.gaps = 0.2});
    EXPECT_TRUE(is_consistent(good));
    EXPECT_TRUE(is_consistent({}));
    ResidualLayout bad = good;
    bad.series.pop_back();
    EXPECT_FALSE(is_consistent(bad));
    bad = good;
    std::swap(bad.sample[3], bad.sample[4]);
    EXPECT_FALSE(is_consistent(bad));
    bad = good;
    bad.time_s.pop_back();
    EXPECT_FALSE(is_consistent(bad));
    EXPECT_EQ(trials_of(good), (std::vector<int>{0, 1}));
}

TEST(ResidualLayout, GridsKeepTimeAndLeaveGapsZero) {
    ResidualLayout layout;
    layout.series = {{7, 0, 1, 0, 3}, {7, 2, 0, 3, 5}};
    layout.sample = {2, 3, 6, 1, 3};
    layout.time_s = {0.2, 0.3, 0.6, 0.1, 0.3};
    const Eigen::VectorXd r = Eigen::VectorXd::LinSpaced(5, 1.0, 5.0);
    const GriddedSeries series = gridded(r, layout, layout.series[0]);
    EXPECT_EQ(series.values, (Eigen::VectorXd(5) << 1, 2, 0, 0, 3).finished());
    EXPECT_EQ(series.seen, (Eigen::VectorXd(5) << 1, 1, 0, 0, 1).finished());
    EXPECT_EQ(series.count(), 3);
    const GriddedTrial trial = gridded_trial(r, layout, 7);
    EXPECT_EQ(trial.first_sample, 1);
    EXPECT_EQ(trial.values, (Eigen::MatrixXd(2, 6) << 0, 1, 2, 0, 0, 3, 4, 0, 5, 0, 0, 0).finished());
    EXPECT_NEAR(trial.time_s(3), 0.4, 1e-12);
    EXPECT_NEAR(trial.time_s(4), 0.5, 1e-12);
    EXPECT_TRUE(gridded_trial(r, layout, 1).series.empty());
    const GriddedSeries known = gridded(Eigen::VectorXd{{1.0, std::numeric_limits<double>::quiet_NaN(), 3.0}});
    EXPECT_EQ(known.values, (Eigen::VectorXd{{1.0, 0.0, 3.0}}));
    EXPECT_EQ(known.count(), 2);
}

TEST(Distributions, AgreeWithTables) {
    EXPECT_NEAR(chi_squared_tail(3.841459, 1.0), 0.05, 1e-7);
    EXPECT_NEAR(chi_squared_tail(2.0, 2.0), std::exp(-1.0), 1e-14);
    EXPECT_NEAR(chi_squared_upper_quantile(0.01, 10.0), 23.20925, 1e-5);
    EXPECT_NEAR(noncentral_chi_squared_tail(3.841459, 1.0, 0.0), 0.05, 1e-7);
    // (z + sqrt(lambda))^2 of a normal z.
    EXPECT_NEAR(noncentral_chi_squared_tail(4.0, 1.0, 9.0), normal_tail(-1.0) + normal_tail(5.0), 1e-12);
    EXPECT_EQ(noncentral_chi_squared_tail(4.0, 1.0, 1e8), 1.0);
    EXPECT_NEAR(fisher_f_tail(4.964603, 1.0, 10.0), 0.05, 1e-7);
    EXPECT_NEAR(student_two_sided(-2.228139, 10.0), 0.05, 1e-7);
    EXPECT_NEAR(normal_tail(1.959964), 0.025, 1e-8);
    EXPECT_NEAR(normal_upper_quantile(normal_tail(3.0)), 3.0, 1e-10);
    EXPECT_EQ(chi_squared_tail(-1.0, 3.0), 1.0);
    EXPECT_EQ(fisher_f_tail(std::numeric_limits<double>::infinity(), 2.0, 3.0), 0.0);
    // A shifted gamma of skewness 2 is exponential.
    EXPECT_NEAR(shifted_gamma_tail(5.0, 3.0, 2.0, 2.0), std::exp(-2.0), 1e-12);
    EXPECT_NEAR(shifted_gamma_tail(5.0, 3.0, 2.0, 1e-4), normal_tail(1.0), 1e-4);
}

TEST(Distributions, LogarithmOfTheTailGoesOnBelowTheSmallestNumber) {
    for (const double freedom : {1.0, 2.0, 7.0, 40.0}) {
        EXPECT_NEAR(log_chi_squared_tail(30.0, freedom), std::log(chi_squared_tail(30.0, freedom)), 1e-12);
        // Recurrence of the incomplete gamma function: Q(a + 1, z) = Q(a, z) + z^a e^-z / Gamma(a + 1).
        const double x = 20'000.0, a = 0.5 * freedom, z = 0.5 * x;
        EXPECT_EQ(chi_squared_tail(x, freedom), 0.0);
        const double step = a * std::log(z) - z - std::lgamma(a + 1.0);
        const double expected = step + std::log1p(std::exp(log_chi_squared_tail(x, freedom) - step));
        EXPECT_NEAR(log_chi_squared_tail(x, freedom + 2.0), expected, 1e-9 * x);
    }
    EXPECT_NEAR(log_chi_squared_tail(20'000.0, 2.0), -10'000.0, 1e-6);
}

}  // namespace
}  // namespace myo::statistics
