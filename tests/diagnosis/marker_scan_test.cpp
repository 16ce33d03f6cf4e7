#include "diagnosis/screening/marker_scan.hpp"

#include <gtest/gtest.h>

#include "diagnosis/made_problem.hpp"

// Exchanged and slipped markers in made-up residuals of three markers at rest.

namespace myo::diagnosis::marker_scan_test {
namespace {

using Eigen::Index;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr int samples = 20, onset = 8;
const Vector3d rest[] = {{0.10, 0.00, 0.00}, {0.10, 0.01, 0.00}, {0.05, 0.00, 0.02}};

/// Two trials in which a model without motion is right but for what the residual holds.
struct Still {
    Still() {
        setup.marker_names = {"left", "right", "middle"};
        setup.trials.resize(2);
        setup.trials[0].name = "first";
        setup.trials[1].name = "second";
        for (int t = 0; t < 2; ++t) {
            data.trials.push_back(static_cast<std::size_t>(t));
            prediction::TrialPrediction prediction;
            for (int m = 0; m < 3; ++m) {
                prediction.positions_m.push_back(rest[m].replicate(1, samples));
                for (int axis = 0; axis < 3; ++axis) {
                    const Index begin = data.layout.size();
                    for (int k = 0; k < samples; ++k) {
                        data.layout.sample.push_back(k);
                        data.layout.time_s.push_back(0.01 * k);
                    }
                    data.layout.series.push_back({t, m, axis, begin, begin + samples});
                }
            }
            fit.predictions.push_back(prediction);
        }
        data.noise_m = VectorXd::Constant(data.layout.size(), test::made_noise_m);
        fit.residual = VectorXd::Zero(data.layout.size());
        for (Index k = 0; k < fit.residual.size(); ++k) fit.residual(k) = 0.1 * std::sin(static_cast<double>(k * k));
        fit.jacobian.resize(fit.residual.size(), 0);
    }

    /// Adds what the residual of a marker becomes from the onset on if it was measured elsewhere.
    void measured_off(int trial, int marker, const Vector3d& by_m) {
        for (const statistics::ResidualSeries& series : data.layout.series)
            if (series.trial == trial && series.marker == marker)
                for (Index k = series.begin + onset; k < series.end; ++k)
                    fit.residual(k) -= by_m(series.axis) / test::made_noise_m;
    }
    EffectScore best(const std::string& allowed) const {
        EffectScore found;
        for (const EffectScore& score : scan_markers(
                 setup, data, fit, statistics::NuisanceSpace(fit.jacobian),
                 [&](const std::string& id) { return id == allowed; }, ScreeningPolicy{}))
            if (score.share() > found.share()) found = score;
        return found;
    }

    setup::Setup setup;
    FitData data;
    JointFit fit;
};

TEST(MarkerScan, FindsNothingInNoise) {
    const Still still;
    EXPECT_FALSE(still.best("marker_swap").usable());
}

TEST(MarkerScan, FindsExchangedNamesWithTrialAndOnset) {
    Still still;
    still.measured_off(1, 0, rest[1] - rest[0]);
    still.measured_off(1, 1, rest[0] - rest[1]);
    const EffectScore found = still.best("marker_swap");
    ASSERT_TRUE(found.usable());
    EXPECT_EQ(std::get<std::vector<std::string>>(found.best.effect.at("markers")),
              (std::vector<std::string>{"left", "right"}));
    EXPECT_EQ(effect::text(found.best.effect, "trial"), "second");
    EXPECT_NEAR(effect::number(found.best.effect, "time_s"), 0.01 * onset, 1e-12);
    EXPECT_GT(found.share(), 0.99);
    still.setup.experiment.markers.compare = experiment::Comparison::displacement;
    EXPECT_FALSE(still.best("marker_swap").usable()) << "displacements do not tell names";
}

TEST(MarkerScan, FindsASlipWithItsVector) {
    Still still;
    const Vector3d slip(3e-4, -1e-4, 2e-4);
    still.measured_off(0, 2, slip);
    const EffectScore found = still.best("marker_slip");
    ASSERT_TRUE(found.usable());
    EXPECT_EQ(effect::text(found.best.effect, "marker"), "middle");
    EXPECT_EQ(effect::text(found.best.effect, "trial"), "first");
    EXPECT_NEAR(effect::number(found.best.effect, "time_s"), 0.01 * onset, 1e-12);
    EXPECT_LT((std::get<VectorXd>(found.best.effect.at("shift_m")) - slip).norm(), 0.1 * test::made_noise_m);
}

/// Three numbers of a marker explain its one place in a hold, whatever the body does.
TEST(MarkerScan, SeesNoSlipInAHold) {
    Still still;
    still.measured_off(0, 2, {3e-4, -1e-4, 2e-4});
    still.setup.trials[0].hold = true;
    const EffectScore found = still.best("marker_slip");
    EXPECT_FALSE(found.usable() && effect::has(found.best.effect, "trial") &&
                 effect::text(found.best.effect, "trial") == "first");
    still.setup.trials[1].hold = true;
    EXPECT_FALSE(still.best("marker_slip").usable());
}

TEST(MarkerScan, AnEventInAllTrialsNamesNone) {
    Still still;
    for (const int trial : {0, 1}) still.measured_off(trial, 2, {3e-4, 0.0, 0.0});
    const EffectScore found = still.best("marker_slip");
    ASSERT_TRUE(found.usable());
    EXPECT_FALSE(effect::has(found.best.effect, "trial"));
}

/// A slip is scored if it removes a share of the residual, at both sides of the limit.
TEST(MarkerScan, ScoresOnlyWhatRemovesAShare) {
    Still still;
    still.measured_off(0, 2, {3e-4, 0.0, 0.0});
    const double share = still.best("marker_slip").share();
    ASSERT_GT(share, 0.5);
    for (const bool scored : {true, false}) {
        ScreeningPolicy policy;
        policy.min_slip_gain = share * (scored ? 0.99 : 1.01);
        const std::vector<EffectScore> scores = scan_markers(
            still.setup, still.data, still.fit, statistics::NuisanceSpace(still.fit.jacobian),
            [](const std::string& id) { return id == "marker_slip"; }, policy);
        EXPECT_EQ(scores.empty(), !scored);
    }
}

}  // namespace
}  // namespace myo::diagnosis::marker_scan_test
