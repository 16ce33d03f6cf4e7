#include "diagnosis/verdict/deviations.hpp"

#include <gtest/gtest.h>
#include <Eigen/QR>

#include <cmath>
#include <random>

#include "inverse/fit_evaluations.hpp"
#include "support/figures.hpp"

// Deviations of a straight line fitted to series with correlated noise, against the spread of repeated fits.

namespace myo::diagnosis::deviations_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index samples = 300;
constexpr int series = 6;

/// Data of one trial: six coordinates, sampled every 10 ms, noise of 1 m.
FitData data_of_six_series() {
    FitData data;
    data.trials = {0};
    data.noise_m = VectorXd::Ones(series * samples);
    for (int s = 0; s < series; ++s) {
        data.layout.series.push_back({0, s / 3, s % 3, s * samples, (s + 1) * samples});
        for (Index k = 0; k < samples; ++k) {
            data.layout.sample.push_back(static_cast<int>(k));
            data.layout.time_s.push_back(0.01 * static_cast<double>(k));
        }
    }
    return data;
}

/// Unit noise with this correlation between neighbouring samples of a series.
VectorXd noise_of(double correlation, std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    VectorXd r(series * samples);
    for (Index i = 0; i < r.size(); ++i)
        r(i) = i % samples == 0 ? normal(random)
                                : correlation * r(i - 1) + std::sqrt(1.0 - correlation * correlation) * normal(random);
    return r;
}

/// A constant and a slow wave, as a fitted level and a creep would be.
MatrixXd columns() {
    MatrixXd J(series * samples, 2);
    for (Index i = 0; i < J.rows(); ++i) J.row(i) << 1.0, std::sin(0.02 * static_cast<double>(i % samples));
    return J;
}

JudgedFit fitted(const VectorXd& noise) {
    JudgedFit fit;
    const MatrixXd J = columns();
    const VectorXd values = J.householderQr().solve(-noise);
    fit.fit.jacobian = J;
    fit.fit.residual = noise + J * values;
    for (const char* name : {"level", "wave"}) {
        prediction::ModelParameter p;
        p.parameter.name = name;
        fit.fit.parameters.push_back(p);
    }
    std::vector<inverse::Parameter> parameters;
    for (const prediction::ModelParameter& p : fit.fit.parameters) parameters.push_back(p.parameter);
    inverse::set_covariance(parameters, {true, {}, fit.fit.residual, J}, fit.fit.report);
    fit.fit.report.values = values;
    return fit;
}

/// The stated deviation is the spread of the estimates, whatever the correlation of the noise.
TEST(Deviations, HoldUnderCorrelatedNoise) {
    const FitData data = data_of_six_series();
    std::mt19937_64 random(2);
    constexpr int repetitions = 300;
    for (const double correlation : {0.0, 0.9}) {
        Eigen::Array2d spread = Eigen::Array2d::Zero(), stated = spread, white = spread;
        for (int i = 0; i < repetitions; ++i) {
            const JudgedFit fit = fitted(noise_of(correlation, random));
            spread += fit.fit.report.values.array().square() / repetitions;
            white += fit.fit.report.deviations.array().square() / repetitions;
            stated += with_deviations(fit, data, {}, {}).fit.report.deviations.array().square() / repetitions;
        }
        for (Index p = 0; p < 2; ++p) {
            const double ratio = std::sqrt(stated(p) / spread(p));
            test::record("stated over spread", ratio);
            EXPECT_NEAR(ratio, 1.0, 0.2) << correlation;
            if (correlation == 0.0) continue;
            EXPECT_LT(std::sqrt(white(p) / spread(p)), 0.4) << "as if the noise were white";
        }
    }
}

/// Half of what was taken off for the step may be wrong: the level may be off by as much.
TEST(Deviations, CoverTheDoubtInRemovedErrors) {
    const FitData data = data_of_six_series();
    std::mt19937_64 random(3);
    const JudgedFit fit = fitted(noise_of(0.0, random));
    const NumericsPolicy policy;
    NumericalError error;
    error.step_shift = {std::vector<Eigen::Matrix3Xd>(2, Eigen::Matrix3Xd::Constant(3, samples, 2.0))};
    const double without = with_deviations(fit, data, {}, policy).fit.report.deviations(0),
                 with = with_deviations(fit, data, error, policy).fit.report.deviations(0);
    EXPECT_NEAR(std::sqrt(with * with - without * without), 2.0 * policy.extrapolation_doubt, 1e-6);
}

TEST(Deviations, IntervalsStayWithinBoundsAndAreRelativeOverDecades) {
    inverse::Parameter p;
    EXPECT_FALSE(interval_95(p, 1.0, std::nan("")));
    EXPECT_NEAR(interval_95(p, 1.0, 0.1)->low, 1.0 - 0.196, 1e-4);
    p.lower = 0.9;
    EXPECT_EQ(interval_95(p, 1.0, 0.1)->low, 0.9);
    p = {"stiffness", 1.0, 0.0, 1e9, 1e-9, true};
    const Interval wide = *interval_95(p, 1.0, 1.0);
    EXPECT_NEAR(wide.low * wide.high, 1.0, 1e-6) << "of the logarithm";
    EXPECT_GT(wide.low, 0.0);
}

}  // namespace
}  // namespace myo::diagnosis::deviations_test
