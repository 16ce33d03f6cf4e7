#include "diagnosis/selection/ranking.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace myo::diagnosis {
namespace {

JudgedFit fit(double held_out, double held_out_in_time, int single_trial_directions) {
    JudgedFit fit;
    fit.fit.residual = Eigen::VectorXd::LinSpaced(400, -1.0, 1.0);
    fit.held_out_rms = held_out;
    fit.held_out_in_time_rms = held_out_in_time;
    fit.single_trial_directions = single_trial_directions;
    return fit;
}

/// Enters the weights of the fits among each other.
void weigh(const FitData& data, const std::vector<JudgedFit*>& fits) {
    const std::vector<FitWeight> weights = weights_of(data, {fits.begin(), fits.end()}, JudgementPolicy{});
    for (std::size_t i = 0; i < fits.size(); ++i) {
        fits[i]->criterion = weights[i].criterion;
        fits[i]->weight = weights[i].weight;
    }
}

FitData data_of_one_marker() {
    FitData data;
    data.layout.series = {{0, 0, 0, 0, 400}};
    for (int k = 0; k < 400; ++k) {
        data.layout.sample.push_back(k);
        data.layout.time_s.push_back(0.01 * k);
    }
    return data;
}

/// A number that one trial alone tells of is as it was fitted when that is held out: it wins there without being
/// tested.
TEST(Weigh, ComparesByTimeWhatHoldingOutATrialDoesNotTest) {
    const FitData data = data_of_one_marker();
    for (const double in_time : {0.8, 1.6}) {
        JudgedFit of_one_trial = fit(0.9, in_time, 2), of_all = fit(1.2, 1.2, 1), broken = fit(0.1, 0.1, 0);
        broken.fit.residual.resize(0);
        weigh(data, {&of_one_trial, &of_all, &broken});
        EXPECT_EQ(of_one_trial.criterion < of_all.criterion, in_time < 1.0);
        EXPECT_EQ(broken.weight, 0.0);
    }
    JudgedFit worse = fit(1.4, 0.5, 2),
              better = fit(1.2, 1.2, 1);  // not even flattered it is best: nothing to be asked again
    weigh(data, {&worse, &better});
    EXPECT_LT(better.criterion, worse.criterion);
}

/// A hysteresis of no width is a gain: of two that are as good the one at its bound is the less likely; where it is far
/// better it stays.
TEST(Weigh, WhatEndsAtItsBoundIsTheLimitOfAnotherKind) {
    const FitData data = data_of_one_marker();
    for (const double within_held_out : {1.0, 2.0}) {
        JudgedFit at_bound = fit(1.0, 1.0, 0), within = fit(within_held_out, within_held_out, 0);
        for (JudgedFit* of : {&at_bound, &within}) {
            for (Eigen::Index k = 0; k < 400; ++k)
                of->fit.residual(k) = std::sin(static_cast<double>(k * k));  // without memory
            of->fit.values.effects.push_back({"actuation_hysteresis", {{"width", of == &at_bound ? 1e-4 : 0.02}}});
            prediction::ModelParameter width;
            width.kind = prediction::ModelParameter::Kind::effect;
            width.of_effect = "width";
            width.parameter.lower = 1e-4;
            width.parameter.upper = 10.0;
            of->fit.parameters.push_back(width);
        }
        ASSERT_TRUE(effect_at_bound(at_bound.fit, JudgementPolicy{}));
        ASSERT_FALSE(effect_at_bound(within.fit, JudgementPolicy{}));
        weigh(data, {&at_bound, &within});
        EXPECT_EQ(within.weight > at_bound.weight, within_held_out == 1.0);
        if (within_held_out == 1.0) {
            EXPECT_NEAR(within.weight, 0.8, 1e-12) << "four to one";
        }
    }
}

/// Four markers in two trials, with courses of their own or one in common.
JudgedFit judged_courses(bool shared) {
    FitData data;
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    constexpr int samples = 150;
    JointFit fit;
    fit.residual.resize(24 * samples);
    fit.jacobian = Eigen::MatrixXd::Zero(fit.residual.size(), 0);
    data.noise_m = Eigen::VectorXd::Constant(fit.residual.size(), 1e-4);
    for (int s = 0; s < 24; ++s) {
        const Eigen::Index begin = data.layout.size();
        double course = 0.0;
        for (int k = 0; k < samples; ++k) {
            course = 0.8 * course + 0.6 * normal(random);
            fit.residual(begin + k) = (shared ? 1.5 * std::sin(0.2 * k) : course) + normal(random);
            data.layout.sample.push_back(k);
            data.layout.time_s.push_back(0.01 * k);
        }
        data.layout.series.push_back({s / 12, s % 12 / 3, s % 3, begin, begin + samples});
    }
    return judged(data, fit, {});
}

TEST(Judged, TellsWanderOfTheMeasurementFromAForce) {
    for (const bool shared : {false, true}) {
        const JudgedFit fit = judged_courses(shared);
        EXPECT_TRUE(fit.tests.significant());
        EXPECT_GT(fit.tests.systematic.rms, 0.6);
        EXPECT_EQ(fit.drifts(), !shared);
    }
}

}  // namespace
}  // namespace myo::diagnosis
