#include <gtest/gtest.h>

#include <functional>

#include "plain_body.hpp"
#include "support/figures.hpp"

namespace myo::effect {
namespace {

using Eigen::Vector3d;

double signal_at(const Affected& affected, double t) { return affected.model.activation.front().value(t) - 1.0; }

/// A beam whose first muscle has this signal.
test::HeldBeam actuated(const fibre::Signal& signal) {
    test::HeldBeam beam = test::held_beam({6, 1, 1});
    beam.affected.model.activation.front() = signal;
    return beam;
}

TEST(EffectForms, ActuatorsAnswerAStepAsTheirEquationsSay) {
    const test::HeldBeam beam = actuated(fibre::Signal::step(0.0, 1.0, 0.8));
    for (const double t : {0.02, 0.05, 0.1}) {
        EXPECT_NEAR(signal_at(test::with_effect(beam, "actuation_lag", {{"time_constant_s", 0.04}}), t),
                    -0.2 * (1.0 - std::exp(-t / 0.04)), 0.02 * 0.2)
            << t;
        EXPECT_NEAR(signal_at(test::with_effect(beam, "actuation_leak", {{"time_constant_s", 0.04}}), t),
                    -0.2 * std::exp(-t / 0.04), 0.02 * 0.2)
            << t;
        EXPECT_NEAR(signal_at(test::with_effect(beam, "actuation_delay", {{"delay_s", 0.03}}), t),
                    t < 0.03 ? 0.0 : 0.8 - 1.0, 1e-12)
            << t;
        EXPECT_NEAR(signal_at(test::with_effect(beam, "actuation_gain", {{"relative_change", 0.5}}), t), -0.3, 1e-12)
            << t;
        // z runs towards -width with the travel of u: z = -width (1 - exp(-|u| / width)).
        EXPECT_NEAR(signal_at(test::with_effect(beam, "actuation_hysteresis", {{"fraction", 0.5}, {"width", 0.1}}), t),
                    -0.5 * 0.2 - 0.5 * 0.1 * (1.0 - std::exp(-2.0)), 1e-9)
            << t;
    }
}

/// A switch between two samples of the response, at 0.0123 s: the equations hold from there on, to rounding.
TEST(EffectForms, ActuatorsAnswerASwitchInTheMiddleOfAStep) {
    const double at = 0.0123;
    const test::HeldBeam beam = actuated({{0.0, at, at, 0.1}, {1.0, 1.0, 0.8, 0.8}});
    const Affected lag = test::with_effect(beam, "actuation_lag", {{"time_constant_s", 0.04}});
    const Affected leak = test::with_effect(beam, "actuation_leak", {{"time_constant_s", 0.04}});
    const Affected play = test::with_effect(beam, "actuation_hysteresis", {{"fraction", 0.5}, {"width", 0.1}});
    const double played = -0.5 * 0.2 - 0.5 * 0.1 * (1.0 - std::exp(-2.0));
    for (const double t : {0.0, 0.01, at, 0.0125, 0.02, 0.1}) {  // the response is linear between its samples: at these
        EXPECT_NEAR(signal_at(lag, t), t < at ? 0.0 : -0.2 * (1.0 - std::exp(-(t - at) / 0.04)), 1e-12) << t;
        EXPECT_NEAR(signal_at(leak, t), t < at ? 0.0 : -0.2 * std::exp(-(t - at) / 0.04), 1e-12) << t;
        EXPECT_NEAR(signal_at(play, t), t < at ? 0.0 : played, 1e-12) << t;
    }
    for (const Affected& affected : {lag, leak, play}) {
        EXPECT_EQ(affected.model.activation.front().jumps(), std::vector<double>{at});
        EXPECT_EQ(affected.model.activation.front().value_before(at), 1.0);
    }
}

/// A delayed switch moves the body as an exact delay does, with an error that falls with the square of the step.
TEST(EffectForms, ADelayedSwitchErrsByTheSquareOfTheStep) {
    test::HeldBeam beam = actuated(fibre::Signal::step(0.02, 1.0, 0.8));
    beam.affected.options.start = dynamics::StartKind::equilibrium;
    const double delay = 0.0132;
    const auto tip = [&](const Affected& affected, double h_s) {
        const dynamics::Trace trace = test::fine_run(affected, h_s, 0.08);
        return test::tip_displacement(affected.model, beam.spec, trace.positions.back());
    };
    Affected late = beam.affected;
    late.model.activation.front() = fibre::Signal::step(0.02 + delay, 1.0, 0.8);
    const Vector3d exact = tip(late, 2.5e-4);
    std::vector<double> errors;
    for (const double h_s : {0.005, 0.0025}) {
        beam.affected.options.h_s = h_s;
        errors.push_back((tip(test::with_effect(beam, "actuation_delay", {{"delay_s", delay}}), h_s) - exact).norm());
        errors.push_back((tip(late, h_s) - exact).norm());
    }
    test::record("errors_of_effect_and_jump_m", errors);
    EXPECT_GT(errors[0] / errors[2], 3.0);
    EXPECT_LT(errors[2], 2.0 * errors[3]);
}

/// What is held all along bleeds off from t = 0 on and is reached by less; only what follows late says the same late as
/// early.
TEST(EffectForms, ActuatorsAnswerAConstantSignalAsTheirEquationsSay) {
    for (const fibre::Signal& signal : {fibre::Signal::constant(0.8), fibre::Signal{{0.0, 1.0}, {0.8, 0.8}}}) {
        const test::HeldBeam beam = actuated(signal);
        for (const double t : {0.0, 0.03, 0.1}) {
            EXPECT_NEAR(signal_at(test::with_effect(beam, "actuation_leak", {{"time_constant_s", 0.04}}), t),
                        -0.2 * std::exp(-t / 0.04), 1e-12)
                << t;
            EXPECT_NEAR(
                signal_at(test::with_effect(beam, "actuation_hysteresis", {{"fraction", 0.5}, {"width", 0.1}}), t),
                -0.5 * 0.2 - 0.5 * 0.1 * (1.0 - std::exp(-2.0)), 1e-12)
                << t;
            EXPECT_NEAR(signal_at(test::with_effect(beam, "actuation_gain", {{"relative_change", 0.5}}), t), -0.3,
                        1e-12)
                << t;
            EXPECT_NEAR(signal_at(test::with_effect(beam, "actuation_delay", {{"delay_s", 0.03}}), t), -0.2, 1e-12)
                << t;
        }
        EXPECT_EQ(test::with_effect(beam, "actuation_lag", {{"time_constant_s", 0.04}}).model.activation.front(),
                  signal);
        // The second muscle is at rest, where there is nothing to lose.
        for (const char* id : {"actuation_leak", "actuation_hysteresis"}) {
            const EffectParameters parameters{{"time_constant_s", 0.04}, {"fraction", 0.5}, {"width", 0.1}};
            EXPECT_EQ(test::with_effect(beam, id, parameters).model.activation.back(), fibre::Signal::constant(1.0))
                << id;
        }
    }
}

/// Leak, hysteresis and gain show on a held signal and are sought there, lag and dead time do not; none on muscles at
/// rest.
TEST(EffectForms, ActuatorsAreSoughtWhereTheyShow) {
    const auto sought = [](const char* id, const fibre::Signal& signal) {
        const test::HeldBeam beam = actuated(signal);
        EffectSearch search;
        search.trials = {beam.context};
        search.models = {beam.affected.model};
        return !find_effect(id)->probes(search).empty();
    };
    for (const char* id : {"actuation_leak", "actuation_hysteresis", "actuation_gain"}) {
        EXPECT_TRUE(sought(id, fibre::Signal::constant(0.8))) << id;
        EXPECT_TRUE(sought(id, fibre::Signal::step(0.0, 1.0, 0.8))) << id;
        EXPECT_FALSE(sought(id, fibre::Signal::constant(1.0))) << id;
    }
    for (const char* id : {"actuation_lag", "actuation_delay"}) {
        EXPECT_TRUE(sought(id, fibre::Signal::step(0.0, 1.0, 0.8))) << id;
        EXPECT_FALSE(sought(id, fibre::Signal::constant(0.8))) << id;
    }
}

class ActuationForms : public testing::TestWithParam<fem::ElementKind> {
protected:
    static constexpr double muscle_Pa = 8e4;

    /// A bar that weighs next to nothing and a muscle throughout: it follows its signal at once.
    static test::HeldBeam bar(const fibre::Signal& signal) {
        test::BeamSpec spec = test::slender_beam(GetParam());
        spec.cells = {4, 1, 1};
        spec.density_kg_m3 = 1e-3;
        spec.damping_s = 1e-5;
        test::HeldBeam beam = test::plain_body(spec);
        auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>();
        fibres->push_back(fibre::fibres_in_box(beam.context.body->mesh, {{-1.0, -1.0, -1.0}, {1.0, 1.0, 1.0}},
                                               Vector3d::UnitX(), muscle_Pa, "all"));
        beam.affected.model.fibres = fibres;
        beam.affected.model.activation = {signal};
        beam.affected.options.start = beam.context.start = dynamics::StartKind::equilibrium;
        beam.affected.options.h_s = 2e-3;
        beam.affected.options.end_s = 0.3;
        return beam;
    }

    /// Its length under u = a - 1, for small u: E e + k (e - u) = 0.
    static double shortening(const test::HeldBeam& beam, double u) {
        return beam.spec.size(0) * muscle_Pa * u / (beam.spec.youngs_modulus_Pa + muscle_Pa);
    }

    /// Largest error of the run's end over the largest motion.
    static double worst(const test::HeldBeam& beam, const std::string& id, const EffectParameters& parameters,
                        const std::function<double(double)>& u) {
        const Affected affected = test::with_effect(beam, id, parameters);
        const dynamics::Trace trace = test::fine_run(affected, beam.affected.options.h_s, beam.affected.options.end_s);
        double error = 0.0, most = 0.0;
        for (std::size_t k = 0; k < trace.times_s.size(); ++k) {
            const double expected = shortening(beam, u(trace.times_s[k]));
            error = std::max(
                error, std::abs(test::tip_displacement(affected.model, beam.spec, trace.positions[k]).x() - expected));
            most = std::max(most, std::abs(expected));
        }
        test::record(id, error / most);
        return error / most;
    }
};

constexpr double held_u = -0.01, tau_s = 0.08;

/// A constant, and one that moves late by next to nothing: they bleed off alike.
TEST_P(ActuationForms, AHeldMuscleBleedsOff) {
    const auto u = [](double t) { return held_u * std::exp(-t / tau_s); };
    EXPECT_LT(worst(bar(fibre::Signal::constant(1.0 + held_u)), "actuation_leak", {{"time_constant_s", tau_s}}, u),
              0.02);
    EXPECT_LT(worst(bar(fibre::Signal{{0.0, 0.25, 0.3}, {1.0 + held_u, 1.0 + held_u, 1.0 + 1.001 * held_u}}),
                    "actuation_leak", {{"time_constant_s", tau_s}}, u),
              0.02);
}

/// A ramp from 0.05 s to 0.15 s: a first-order lag is behind it by tau once it has settled.
TEST_P(ActuationForms, AMuscleFollowsARampLate) {
    const double from = 0.05, length = 0.1;
    const fibre::Signal ramp{{from, from + length}, {1.0, 1.0 + held_u}};
    const auto line = [=](double t) { return held_u * std::clamp((t - from) / length, 0.0, 1.0); };
    const auto lagged = [=](double t) {  // of a line that begins, less of one that ends it
        const auto of_line = [](double s) { return s > 0.0 ? s - tau_s * (1.0 - std::exp(-s / tau_s)) : 0.0; };
        return held_u / length * (of_line(t - from) - of_line(t - from - length));
    };
    EXPECT_LT(worst(bar(ramp), "actuation_lag", {{"time_constant_s", tau_s}}, lagged), 0.02);
    EXPECT_LT(worst(bar(ramp), "actuation_delay", {{"delay_s", 0.033}}, [=](double t) { return line(t - 0.033); }),
              0.02);
    EXPECT_LT(worst(bar(ramp), "actuation_gain", {{"relative_change", 0.4}}, [=](double t) { return 1.4 * line(t); }),
              0.02);
}

/// There and back: z goes from 0 by width (1 - exp(-|u| / width)), back straight to 0 and on to the other side.
TEST_P(ActuationForms, AMuscleComesBackOnAnotherWay) {
    const double fraction = 0.4, width = 0.004;
    const fibre::Signal there_and_back{{0.05, 0.15, 0.25}, {1.0, 1.0 + held_u, 1.0}};
    const double most = width * (1.0 - std::exp(held_u / width));
    const auto response = [=](double t) {
        const double travel = t < 0.15 ? 0.0 : -held_u * std::clamp((t - 0.15) / 0.1, 0.0, 1.0);
        const double u = t < 0.15 ? held_u * std::clamp((t - 0.05) / 0.1, 0.0, 1.0) : held_u + travel;
        const double z = t < 0.15        ? -width * (1.0 - std::exp(u / width))
                         : travel < most ? travel - most
                                         : width * (1.0 - std::exp(-(travel - most) / width));
        return (1.0 - fraction) * u + fraction * z;
    };
    EXPECT_LT(worst(bar(there_and_back), "actuation_hysteresis", {{"fraction", fraction}, {"width", width}}, response),
              0.02);
    const double reached = (1.0 - fraction) * held_u - fraction * most;
    EXPECT_LT(worst(bar(fibre::Signal::constant(1.0 + held_u)), "actuation_hysteresis",
                    {{"fraction", fraction}, {"width", width}}, [=](double) { return reached; }),
              0.02);
}

INSTANTIATE_TEST_SUITE_P(OnTwoMeshes, ActuationForms, testing::ValuesIn(test::two_kinds),
                         [](const auto& given) { return to_string(given.param); });

}  // namespace
}  // namespace myo::effect
