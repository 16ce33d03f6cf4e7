#include <gtest/gtest.h>

#include "dynamics/simulate.hpp"
#include "effect/bends_between_steps.hpp"
#include "effect/trial_context.hpp"
#include "support/figures.hpp"

namespace myo::effect {
namespace {

constexpr double h = 0.01;

/// Slope 2 from 0.1 + theta h on, between two constants.
fibre::Signal ramp(double theta) { return {{0.1 + theta * h, 0.3 + theta * h}, {1.0, 1.4}}; }

/// The impulse of TR-BDF2's stages up to t = 0.25, in the middle of the ramp.
double impulse_of_steps(const fibre::Signal& signal) {
    const double root = std::sqrt(2.0);
    double sum = 0.0;
    for (int k = 0; k < 25; ++k)
        sum += h * (0.25 * root * (signal.value(k * h) + signal.value((k + 2.0 - root) * h)) +
                    (1.0 - 0.5 * root) * signal.value((k + 1) * h));
    return sum;
}

TEST(BendsBetweenSteps, HaveTheirImpulseWhereverTheyFall) {
    double worst = 0.0, worst_of_samples = 0.0;
    for (const double theta : {0.0, 0.1, 0.25, 0.5, 0.61803, 0.9}) {
        const double exact = 0.25 + std::pow(0.15 - theta * h, 2);  // 1, and half the slope times the time squared
        worst = std::max(worst, std::abs(impulse_of_steps(with_bends_between_steps(ramp(theta), h, 0.5)) - exact));
        worst_of_samples = std::max(worst_of_samples, std::abs(impulse_of_steps(ramp(theta)) - exact));
    }
    test::record("worst_over_worst_of_samples", worst / worst_of_samples);
    EXPECT_LT(worst, 0.06 * worst_of_samples);
}

/// A bend of no length.
TEST(BendsBetweenSteps, GiveAJumpItsImpulseWhereverItFalls) {
    for (const double theta : {0.0, 0.1, 0.25, 0.5, 0.61803, 0.9}) {
        const fibre::Signal jump = fibre::Signal::step(0.1 + theta * h, 1.0, 1.4);
        EXPECT_NEAR(impulse_of_steps(with_bends_between_steps(jump, h, 0.5)), 0.25 + 0.4 * (0.15 - theta * h), 1e-4)
            << theta;
        EXPECT_TRUE(with_bends_between_steps(jump, h, 0.5).jumps().empty());
    }
}

TEST(BendsBetweenSteps, LeaveLinesConstantsAndJumpsAtTheStartAsTheyAre) {
    const fibre::Signal smooth = with_bends_between_steps(ramp(0.3), h, 0.5);
    for (const double t : {0.0, 0.05, 0.08, 0.12, 0.2, 0.28, 0.33, 0.5})
        EXPECT_NEAR(smooth.value(t), ramp(0.3).value(t), 1e-12) << t;
    const fibre::Signal jumping = fibre::Signal::step(0.0123, 1.0, 0.8);
    EXPECT_EQ(with_bends_between_steps(jumping, h, 0.5), jumping);
    const fibre::Signal both{{0.0, 0.0123, 0.0123, 0.1, 0.3}, {1.0, 1.0, 0.8, 0.8, 1.2}};
    const fibre::Signal kept = with_bends_between_steps(both, h, 0.5);
    EXPECT_EQ(kept.jumps(), std::vector<double>{0.0123});
    for (const double t : {0.0, 0.0122, 0.0123, 0.05, 0.08, 0.12, 0.2})
        EXPECT_NEAR(kept.value(t), both.value(t), 1e-12) << t;
}

using Tips = std::vector<Eigen::Vector3d>;

/// The tip every `every` steps of a run in m.
Tips tips(const test::HeldBeam& beam, Affected run, double h_s, std::size_t every) {
    run.options.h_s = h_s;
    const dynamics::Trace trace = dynamics::simulate(run.model, run.options);
    EXPECT_TRUE(trace.complete()) << trace.message;
    Tips list;
    for (std::size_t k = 0; k < trace.positions.size(); k += every)
        list.push_back(test::tip_displacement(run.model, beam.spec, trace.positions[k]));
    return list;
}

/// A beam whose muscle's signal bends at ends of steps, and half a step later.
struct Delayed {
    static constexpr double step = 0.005, delay = 0.5 * step;
    test::HeldBeam beam = test::held_beam({6, 1, 1});
    Affected by_samples, by_effect;

    Delayed() {
        beam.affected.model.activation.front() = fibre::Signal{{0.01, 0.04}, {1.0, 0.8}};
        beam.affected.options.start = dynamics::StartKind::equilibrium;
        beam.affected.options.end_s = 0.08;
        by_samples = beam.affected;
        for (double& time : by_samples.model.activation.front().times_s) time += delay;
        by_effect = with_effect_at(step);
    }

    Affected with_effect_at(double h_s) const {
        test::HeldBeam own = beam;
        own.affected.options.h_s = h_s;
        return test::with_effect(own, "actuation_delay", {{"delay_s", delay}});
    }
};

TEST(BendsBetweenSteps, GiveADelayedRunTheErrorOfTheUndelayedOne) {
    const Delayed of;
    const Tips limit = tips(of.beam, of.beam.affected, of.step / 64, 32),
               undelayed = tips(of.beam, of.beam.affected, of.step, 1);
    const auto differs = [&](const Affected& run) {
        const Tips delayed = tips(of.beam, run, of.step, 1);
        double squares = 0.0;
        for (std::size_t k = 1; k < undelayed.size(); ++k) {
            const Eigen::Vector3d own = 0.5 * (undelayed[k] + undelayed[k - 1] - limit[2 * k] - limit[2 * k - 2]);
            squares += (delayed[k] - limit[2 * k - 1] - own).squaredNorm();
        }
        return std::sqrt(squares);
    };
    const double ratio = differs(of.by_effect) / differs(of.by_samples);
    test::record("differs_over_shifted_samples", ratio);
    EXPECT_LT(ratio, 0.5);
}

TEST(BendsBetweenSteps, LetTheErrorOfTheStepBeTakenOffARunWithADelay) {
    const Delayed of;
    const Tips limit = tips(of.beam, of.by_samples, of.step / 64, 64);
    const auto left = [&](const Affected& coarse, const Affected& fine) {
        const Tips wide = tips(of.beam, coarse, of.step, 1), narrow = tips(of.beam, fine, 0.5 * of.step, 2);
        double squares = 0.0;
        for (std::size_t k = 0; k < wide.size(); ++k)
            squares += ((4.0 * narrow[k] - wide[k]) / 3.0 - limit[k]).squaredNorm();
        return std::sqrt(squares);
    };
    const double ratio = left(of.by_effect, of.with_effect_at(0.5 * of.step)) / left(of.by_samples, of.by_samples);
    test::record("left_over_shifted_samples", ratio);
    EXPECT_LT(ratio, 0.5);
}

}  // namespace
}  // namespace myo::effect
