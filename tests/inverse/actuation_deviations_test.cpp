#include "inverse/actuation_deviations.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <random>

#include "inverse/actuated_beam.hpp"
#include "support/dense.hpp"
#include "support/differences.hpp"
#include "support/figures.hpp"

namespace myo::inverse {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::actuated_beam;
using test::aim_at;
using test::wave;
using ::testing::HasSubstr;

/// The beam with a signal for each of its two muscles, at 10 Hz.
ActuationProblem two_signals() {
    ActuationProblem problem = actuated_beam(false, false, false);
    problem.sought.signals = {{"lower", 0.5, 1.5, 1.0}, {"upper", 0.5, 1.5, 1.0}};
    problem.sought.groups = {{0, 1.0}, {1, 1.0}};
    problem.sought.frequency_Hz = 10.0;
    return problem;
}

MatrixXd two_waves(const SoughtSignals& sought) {
    MatrixXd values = unmoved_values(sought);
    for (Eigen::Index k = 0; k < values.cols(); ++k)
        values.col(k) << 1.0 - 0.05 * std::sin(1.0 + static_cast<double>(k)),
            1.0 + 0.04 * std::cos(static_cast<double>(k));
    return values;
}

/// Half the Hessian of the mean square residual where the residuals vanish, and of the loss, by differences of its
/// gradient.
MatrixXd half_hessian(ActuationProblem p, const MatrixXd& at, double smoothness_m_s) {
    p.smoothness_m_s = smoothness_m_s;
    const auto gradient = [&](const VectorXd& x) {
        return VectorXd(evaluate_actuation(p, x.reshaped(at.rows(), at.cols())).gradient.reshaped());
    };
    return 0.5 * test::central_differences(gradient, at.reshaped(), 1e-3);
}

/// What noise does to the values that minimise the loss, and how far the signal's largest rate may shift them by the
/// smoothness.
TEST(ActuationDeviations, AreThoseOfTheLossItself) {
    for (const bool hold : {false, true}) {
        ActuationProblem p = actuated_beam(hold, hold, !hold);
        const MatrixXd truth = wave(p.sought);
        aim_at(p, truth);
        p.smoothness_m_s = 2e-4;
        p.options.solver.tolerance = 1e-11;
        const double noise = 1e-3;  // more than the smoothness leaves of the residuals
        const ActuationDeviations found = actuation_deviations(p, truth, noise);
        ASSERT_TRUE(found.found) << found.reason;
        EXPECT_EQ(found.noise_m, noise);
        const MatrixXd loss = half_hessian(p, truth, p.smoothness_m_s), target = half_hessian(p, truth, 0.0);
        const double count = static_cast<double>(p.target.coordinates());
        const MatrixXd inverse = test::inverse(loss);
        const MatrixXd by_noise = noise * noise / count * inverse * target * inverse;
        const Eigen::Index n = truth.cols(), first = hold ? 0 : 1;  // from rest the first value is a change, too
        MatrixXd D = MatrixXd::Zero(n - first, n);
        for (Eigen::Index k = first; k < n; ++k) {
            D(k - first, k) = p.sought.frequency_Hz;
            if (k > 0) D(k - first, k - 1) = -p.sought.frequency_Hz;
        }
        const VectorXd constant = VectorXd::Constant(n, p.sought.signals.front().before);
        const double largest = (D * (truth.transpose() - constant)).cwiseAbs().maxCoeff();
        const MatrixXd shifts = std::pow(p.smoothness_m_s, 2) / static_cast<double>(D.rows()) * inverse * D.transpose();
        const VectorXd hidden = largest * shifts.cwiseAbs().rowwise().sum();
        const VectorXd expected = (by_noise.diagonal() + hidden.cwiseAbs2()).cwiseSqrt();
        test::expect_derivative(found.deviations.reshaped().transpose(), expected.transpose(), 2e-3, "deviations");
        const MatrixXd covariance = inverse;  // but for a factor
        const VectorXd sigma = covariance.diagonal().cwiseSqrt();
        const MatrixXd correlation = sigma.cwiseInverse().asDiagonal() * covariance * sigma.cwiseInverse().asDiagonal();
        EXPECT_LT((found.correlation - correlation).norm(), 5e-3);
    }
}

/// No marker is seen for half of the time: what the signal does there nobody knows, and the values beside it lie
/// within their deviations.
TEST(ActuationDeviations, AreNoneWhereNothingWasMeasured) {
    ActuationProblem p = actuated_beam(false, true, false);
    p.sought.frequency_Hz = 40.0;
    const MatrixXd truth = wave(p.sought);
    aim_at(p, truth);
    for (Eigen::Matrix3Xd& track : p.target.positions_m)
        for (Eigen::Index t = 0; t < track.cols(); ++t) {
            if (p.target.times_s(t) > 0.06 && p.target.times_s(t) < 0.21) track.col(t).setConstant(std::nan(""));
            track.col(t).array() += 1e-4 * std::sin(7.0 * static_cast<double>(t));
        }
    p.smoothness_m_s = 1e-4;
    const ActuationFit fit = fit_actuation(p, unmoved_values(p.sought), {200, 1e-6});
    ASSERT_TRUE(fit.converged()) << fit.message;
    const ActuationDeviations found = actuation_deviations(p, fit.values, 1e-4);
    ASSERT_TRUE(found.found) << found.reason;
    const std::vector<double> times = knot_times(p.sought);
    double worst = 0.0;
    int seen = 0;
    for (std::size_t k = 0; k < times.size(); ++k) {
        const auto column = static_cast<Eigen::Index>(k);
        if (times[k] > 0.09 && times[k] < 0.14) {
            EXPECT_TRUE(std::isnan(found.deviations(0, column))) << times[k];
        }
        if (!std::isfinite(found.deviations(0, column))) continue;
        ++seen;
        worst = std::max(worst, std::abs(fit.values(0, column) - truth(0, column)) / found.deviations(0, column));
    }
    test::record("worst_error_in_deviations", worst);
    EXPECT_LT(worst, 3.0);
    EXPECT_GE(seen, 5);
    EXPECT_THAT(::testing::PrintToString(found.warnings), HasSubstr("so they have no standard deviation"));
}

/// A smoothness that flattens the signal is no knowledge of it: the deviations hold what it hides.
TEST(ActuationDeviations, HoldWhatTheSmoothnessHides) {
    ActuationProblem p = actuated_beam(false, true, false);
    const MatrixXd truth = wave(p.sought);
    aim_at(p, truth);
    p.smoothness_m_s = 3e-4;
    const ActuationFit fit = fit_actuation(p, unmoved_values(p.sought), {200, 1e-7});
    const ActuationDeviations found = actuation_deviations(p, fit.values, 1e-6);
    ASSERT_TRUE(found.found) << found.reason;
    for (Eigen::Index k = 0; k < truth.size(); ++k)
        if (std::isfinite(found.deviations(k))) {
            EXPECT_LT(std::abs(fit.values(k) - truth(k)), 3.0 * found.deviations(k)) << k;
        }
}

/// Values found from noisy traces lie within one deviation of the truth as often as promised.
TEST(ActuationDeviations, CoverTheTruth) {
    ActuationProblem p = two_signals();
    const MatrixXd truth = two_waves(p.sought);
    aim_at(p, truth);
    const std::vector<Eigen::Matrix3Xd> exact = p.target.positions_m;
    const double noise = 1e-4;
    int within = 0, all = 0;
    for (unsigned seed = 1; seed <= 12; ++seed) {
        std::mt19937 random(seed);
        std::normal_distribution<double> normal(0.0, noise);
        for (std::size_t m = 0; m < exact.size(); ++m)
            for (Eigen::Index k = 0; k < exact[m].size(); ++k)
                p.target.positions_m[m](k) = exact[m](k) + normal(random);
        const ActuationFit fit = fit_actuation(p, unmoved_values(p.sought), {200, 1e-7});
        ASSERT_TRUE(fit.converged()) << fit.message;
        const ActuationDeviations found = actuation_deviations(p, fit.values, noise);
        ASSERT_TRUE(found.found) << found.reason;
        within += static_cast<int>(((fit.values - truth).cwiseAbs().array() < found.deviations.array()).count());
        all += static_cast<int>(truth.size());
    }
    test::record("share_within_one_deviation", static_cast<double>(within) / all);
    // 68.3 % of 96, whose standard deviation is 4.6 were they independent; those of one trace are not quite.
    EXPECT_NEAR(static_cast<double>(within) / all, 0.683, 0.15);
}

/// A camera frame that is sought leaves less to the signal; one that may hardly move is as good as known.
TEST(ActuationDeviations, AreLargerWhereTheCameraFrameIsSought) {
    ActuationProblem p = actuated_beam(false, true, false);
    const MatrixXd truth = wave(p.sought);
    aim_at(p, truth);
    const MatrixXd known = actuation_deviations(p, truth, 1e-4).deviations;
    p.placement_bounds = PlacementBounds{1e-3, 1e-2};
    const MatrixXd sought = actuation_deviations(p, truth, 1e-4).deviations;
    p.placement_bounds = PlacementBounds{1e-9, 1e-9};
    const MatrixXd hardly = actuation_deviations(p, truth, 1e-4).deviations;
    EXPECT_GT((sought - known).minCoeff(), 0.0);
    EXPECT_LT((hardly - known).cwiseAbs().maxCoeff(), 1e-6 * known.maxCoeff());
}

/// Two signals for muscles side by side, seen by markers that only bend up and down, are one signal for all the markers
/// can tell.
TEST(ActuationDeviations, NameSignalsThatCannotBeToldApart) {
    ActuationProblem p = two_signals();
    auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>();
    for (const double low : {0.0, 0.015})
        fibres->push_back(fibre::fibres_in_box(p.model.body->mesh, Box{{0.0, low, 0.0}, {0.1, low + 0.015, 0.01}},
                                               Eigen::Vector3d::UnitX(), 8e4, low > 0.0 ? "right" : "left"));
    p.model.fibres = fibres;
    p.target.markers = measurement::marker_set(p.model.body->mesh, {{0.1, 0.015, 0.03}, {0.1, 0.015, 0.0}});
    p.sought.from_before = true;  // so that the smoothness ties the level, too
    const MatrixXd values = unmoved_values(p.sought);
    aim_at(p, values);
    for (Eigen::Matrix3Xd& track : p.target.positions_m)
        track.row(1).setConstant(std::numeric_limits<double>::quiet_NaN());
    p.smoothness_m_s = 1e-6;
    const ActuationDeviations found = actuation_deviations(p, values, 1e-5);
    ASSERT_TRUE(found.found) << found.reason;
    EXPECT_THAT(::testing::PrintToString(found.warnings), HasSubstr("cannot separate them"));
    EXPECT_THAT(::testing::PrintToString(found.warnings), HasSubstr("come from the smoothness"));
    EXPECT_LT(found.correlation(1, 0), -0.95);
    // Without smoothness nothing is left that would determine them.
    p.smoothness_m_s = 0.0;
    const ActuationDeviations open = actuation_deviations(p, values, 1e-5);
    EXPECT_THAT(::testing::PrintToString(open.warnings), HasSubstr("do not determine"));
    EXPECT_GT(open.deviations.array().isNaN().count(), 0);
    // Above and below, with markers that see it, they are two.
    ActuationProblem apart = two_signals();
    aim_at(apart, two_waves(apart.sought));
    for (const std::string& warning : actuation_deviations(apart, two_waves(apart.sought), 1e-5).warnings)
        EXPECT_EQ(warning.find("apart"), std::string::npos) << warning;
}

TEST(ActuationDeviations, SayWhyThereAreNone) {
    ActuationProblem p = actuated_beam(true, false, false);
    aim_at(p, wave(p.sought));
    std::atomic<bool> cancel = true;
    const ActuationDeviations stopped = actuation_deviations(p, wave(p.sought), 1e-4, Progress({}, &cancel));
    EXPECT_FALSE(stopped.found);
    EXPECT_THAT(stopped.reason, HasSubstr("stopped"));
    p.sought.frequency_Hz = 1000.0;
    const ActuationDeviations many = actuation_deviations(p, unmoved_values(p.sought), 1e-4);
    EXPECT_FALSE(many.found);
    EXPECT_THAT(many.reason, HasSubstr("300 values are more than 200"));
}

}  // namespace
}  // namespace myo::inverse
