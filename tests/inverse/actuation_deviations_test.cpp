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

namespace myo {
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
    for (Eigen::Index k = 0; k < values.cols(); ++k) values.col(k) << 1.0 - 0.05 * std::sin(1.0 + static_cast<double>(k)), 1.0 + 0.04 * std::cos(static_cast<double>(k));
    return values;
}

/// The information is half the Hessian of the loss where the residuals vanish, the smoothness included: against differences of its gradient.
TEST(ActuationDeviations, AreThoseOfTheLossItself) {
    for (const bool hold : {false, true}) {
        ActuationProblem p = actuated_beam(hold, hold, !hold);
        const MatrixXd truth = wave(p.sought);
        aim_at(p, truth);
        p.smoothness_m_s = 2e-4;
        p.options.solver.tolerance = 1e-11;
        const double noise = 1e-3;   // more than the smoothness leaves of the residuals
        const ActuationDeviations found = actuation_deviations(p, truth, noise);
        ASSERT_TRUE(found.found) << found.reason;
        EXPECT_EQ(found.noise_m, noise);
        const auto gradient = [&](const VectorXd& x) { return VectorXd(evaluate_actuation(p, x.reshaped(truth.rows(), truth.cols())).gradient.reshaped()); };
        const MatrixXd hessian = test::central_differences(gradient, truth.reshaped(), 1e-3);
        const double count = static_cast<double>(p.target.coordinates());
        const MatrixXd covariance = noise * noise * test::inverse(0.5 * count * hessian);
        test::expect_derivative(found.deviations.reshaped().transpose(), covariance.diagonal().cwiseSqrt().transpose(), 2e-3, "deviations");
        const VectorXd sigma = covariance.diagonal().cwiseSqrt();
        EXPECT_LT((found.correlation - MatrixXd(sigma.cwiseInverse().asDiagonal() * covariance * sigma.cwiseInverse().asDiagonal())).norm(), 5e-3);
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
            for (Eigen::Index k = 0; k < exact[m].size(); ++k) p.target.positions_m[m](k) = exact[m](k) + normal(random);
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

/// Two signals for muscles side by side, seen by markers that only bend up and down, are one signal for all the markers can tell.
TEST(ActuationDeviations, NameSignalsThatCannotBeToldApart) {
    ActuationProblem p = two_signals();
    auto fibres = std::make_shared<std::vector<FibreGroup>>();
    for (const double low : {0.0, 0.015})
        fibres->push_back(fibres_in_box(p.model.body->mesh, Box{{0.0, low, 0.0}, {0.1, low + 0.015, 0.01}}, Eigen::Vector3d::UnitX(), 8e4, low > 0.0 ? "right" : "left"));
    p.model.fibres = fibres;
    p.target.markers = marker_set(p.model.body->mesh, {{0.1, 0.015, 0.03}, {0.1, 0.015, 0.0}});
    p.sought.from_before = true;   // so that the smoothness ties the level, too
    const MatrixXd values = unmoved_values(p.sought);
    aim_at(p, values);
    for (Eigen::Matrix3Xd& track : p.target.positions_m) track.row(1).setConstant(std::numeric_limits<double>::quiet_NaN());
    p.smoothness_m_s = 1e-6;
    const ActuationDeviations found = actuation_deviations(p, values, 1e-5);
    ASSERT_TRUE(found.found) << found.reason;
    EXPECT_THAT(::testing::PrintToString(found.warnings), HasSubstr("cannot tell them apart"));
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
    for (const std::string& warning : actuation_deviations(apart, two_waves(apart.sought), 1e-5).warnings) EXPECT_EQ(warning.find("apart"), std::string::npos) << warning;
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
}  // namespace myo
