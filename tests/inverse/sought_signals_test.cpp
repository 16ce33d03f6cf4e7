#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Core>

#include <cmath>
#include <vector>

#include "inverse/acting_signals.hpp"
#include "inverse/actuation_signals.hpp"

namespace myo::inverse::sought_signals_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using testing::ElementsAre;

/// Two signals of different scales on three actuators, the second of which follows the first one backwards.
SoughtSignals two_signals() {
    SoughtSignals sought;
    sought.signals = {{"a", 0.5, 2.0, 1.0, 1.0, 0.5}, {"p", 0.0, 4e4, 1e3, 0.0, 1e4}};
    sought.groups = {{0, 1.0}, {0, -0.5}, {1, 2.0}};
    sought.frequency_Hz = 10.0;
    sought.end_s = 0.4;
    return sought;
}

/// The ways in which signals are sought.
std::vector<SoughtSignals> all_ways() {
    std::vector<SoughtSignals> ways;
    for (const bool hold : {false, true})
        for (const bool from_before : {false, true})
            for (const bool seek_before : {false, true}) {
                if (seek_before && !from_before) continue;
                SoughtSignals sought = two_signals();
                sought.hold = hold, sought.from_before = from_before, sought.seek_before = seek_before;
                ways.push_back(sought);
            }
    ways.push_back(two_signals());
    ways.back().constant = true;
    return ways;
}

/// Values of which no two differ by the same.
MatrixXd uneven(const SoughtSignals& sought) {
    MatrixXd values = unmoved_values(sought);
    for (Index k = 0; k < values.cols(); ++k)
        for (Index s = 0; s < values.rows(); ++s)
            values(s, k) += sought.signals[static_cast<std::size_t>(s)].scale *
                            std::sin(1.0 + 2.3 * static_cast<double>(k) + static_cast<double>(s));
    return values;
}

TEST(SoughtKnots, ReachTheEndAndNoFarther) {
    SoughtSignals sought = two_signals();
    const auto knots = [&](double end_s) {
        sought.end_s = end_s;
        return knot_times(sought).size();
    };
    EXPECT_EQ(knots(0.4), 5u);
    EXPECT_EQ(knots(0.4 + 1e-12), 5u) << "rounding is no further period";
    EXPECT_EQ(knots(0.401), 6u);
    EXPECT_EQ(knots(0.001), 2u) << "one period at least";
    sought.hold = true;
    EXPECT_EQ(knots(0.4), 4u) << "the last one is held to the end";
    EXPECT_EQ(knots(0.401), 5u);
    EXPECT_EQ(knots(0.001), 1u);
    sought.end_s = 0.3;
    const auto near = [](double t) { return testing::DoubleNear(t, 1e-12); };
    EXPECT_THAT(knot_times(sought), ElementsAre(near(0.0), near(0.1), near(0.2)));
    sought.seek_before = true;
    EXPECT_THAT(knot_times(sought), ElementsAre(near(-0.1), near(0.0), near(0.1), near(0.2)));
    sought.hold = false, sought.from_before = true;
    EXPECT_THAT(knot_times(sought), ElementsAre(near(0.0), near(0.1), near(0.2), near(0.3)));
    sought.seek_before = false;
    EXPECT_THAT(knot_times(sought), ElementsAre(near(0.1), near(0.2), near(0.3)));
    sought.constant = true;
    EXPECT_THAT(knot_times(sought), ElementsAre(0.0));
}

TEST(SoughtValues, BeginAtTheLevelBeforeWithinTheirBounds) {
    SoughtSignals sought = two_signals();
    sought.signals[0].before = 0.2;
    sought.signals[1].before = 9e4;
    const MatrixXd values = unmoved_values(sought);
    ASSERT_EQ(values.cols(), 5);
    EXPECT_TRUE((values.row(0).array() == 0.5).all());
    EXPECT_TRUE((values.row(1).array() == 4e4).all());
}

TEST(Commands, TurnAboutTheValueAtWhichTheActuatorIsPassive) {
    SoughtSignals sought = two_signals();
    sought.constant = true;
    sought.groups.push_back({7, 3.0, fibre::Signal::step(0.1, 0.0, 2.0)});
    const std::vector<fibre::Signal> commands = commands_of(sought, Eigen::Vector2d(1.4, 3e3));
    ASSERT_EQ(commands.size(), 4u);
    EXPECT_NEAR(commands[0].value(0.3), 1.4, 1e-12);
    EXPECT_NEAR(commands[1].value(0.3), 0.8, 1e-12) << "muscles are passive at 1";
    EXPECT_NEAR(commands[2].value(0.3), 6e3, 1e-9) << "chambers at 0";
    EXPECT_EQ(commands[3], fibre::Signal::step(0.1, 0.0, 2.0)) << "what is not sought stays";
    EXPECT_NEAR(commands[0].value_before(0.0), 1.4, 1e-12) << "a body at rest has one value";
}

/// The commands are affine in the values: differences of any size are the derivative.
TEST(Commands, PassDerivativesOnToTheValues) {
    for (SoughtSignals sought : all_ways()) {
        sought.groups.push_back({0, 1.0, fibre::Signal{{0.0, 0.2}, {1.0, 3.0}}});
        std::vector<std::vector<double>> weights;
        for (const fibre::Signal& command : commands_of(sought, uneven(sought))) {
            std::vector<double>& own = weights.emplace_back();
            for (std::size_t k = 0; k < command.values.size(); ++k)
                own.push_back(std::cos(static_cast<double>(3 * weights.size() + k)));
        }
        const auto loss = [&](const MatrixXd& values) {
            const std::vector<fibre::Signal> commands = commands_of(sought, values);
            double sum = 0.0;
            for (std::size_t g = 0; g < commands.size(); ++g)
                for (std::size_t k = 0; k < commands[g].values.size(); ++k)
                    sum += weights[g][k] * commands[g].values[k];
            return sum;
        };
        const MatrixXd values = uneven(sought), gradient = value_gradient(sought, weights);
        ASSERT_EQ(gradient.cols(), values.cols());
        for (Index i = 0; i < values.size(); ++i) {
            MatrixXd above = values;
            above(i) += 1.0;
            EXPECT_NEAR(gradient(i), loss(above) - loss(values), 1e-7) << i << " held " << sought.hold;
            EXPECT_NE(gradient(i), 0.0);
        }
    }
}

TEST(Rates, AreCountedInTheScalesOfTheSignals) {
    for (const SoughtSignals& sought : all_ways()) {
        const MatrixXd values = uneven(sought);
        const double weight = 0.7;
        MatrixXd gradient = MatrixXd::Constant(values.rows(), values.cols(), 0.1), unused = 0.0 * gradient;
        const double rate = mean_square_rate(sought, values, weight, gradient);
        for (Index i = 0; i < values.size(); ++i) {
            // Quadratic: central differences are exact.
            const double h = 0.1 * sought.signals[static_cast<std::size_t>(i % 2)].scale;
            MatrixXd above = values, below = values;
            above(i) += h, below(i) -= h;
            const double difference = (mean_square_rate(sought, above, 0.0, unused) -
                                       mean_square_rate(sought, below, 0.0, unused)) /
                                      (2.0 * h);
            EXPECT_NEAR(gradient(i) - 0.1, weight * difference, 1e-9 * (1.0 + std::abs(difference))) << "added";
        }
        // Signals at `before` do not change; without periods there are no rates.
        EXPECT_NEAR(mean_square_rate(sought, unmoved_values(sought), weight, gradient), 0.0, 1e-15);
        EXPECT_EQ(rate > 0.0, !sought.constant);
        // The matrix has the same rates, but for the constant level before the first of them.
        SoughtSignals from_zero = sought;
        for (SoughtSignal& signal : from_zero.signals) signal.before = 0.0;
        const MatrixXd D = rate_matrix(from_zero, values.cols());
        const MatrixXd in_scales = signal_scales(sought).cwiseInverse().asDiagonal() * values;
        const VectorXd scaled = in_scales.reshaped();
        if (sought.constant)
            EXPECT_EQ(D.rows(), 0);
        else
            EXPECT_NEAR((D * scaled).squaredNorm() / static_cast<double>(D.rows()),
                        mean_square_rate(from_zero, values, 0.0, unused), 1e-9);
    }
}

TEST(Rates, OfARampAreItsSlope) {
    SoughtSignals sought = two_signals();
    sought.signals.resize(1);
    sought.groups = {{0, 1.0}};
    MatrixXd values(1, 5), gradient = MatrixXd::Zero(1, 5);
    values << 1.0, 1.1, 1.2, 1.3, 1.4;
    // 1 per second, in scales of a half.
    EXPECT_NEAR(mean_square_rate(sought, values, 1.0, gradient), 4.0, 1e-9);
    // Inner values of a straight line cost nothing, the ends would rather be nearer.
    EXPECT_LT(gradient.middleCols(1, 3).cwiseAbs().maxCoeff(), 1e-9);
    EXPECT_LT(gradient(0, 0), 0.0);
    EXPECT_NEAR(gradient(0, 4), -gradient(0, 0), 1e-9);
}

/// Actuators that answer with the square of what is commanded.
TEST(ActingSignalsOfCommands, PassDerivativesOnThroughTheirAnswer) {
    const ActingSignals squares = [](std::vector<fibre::Signal> commands) {
        for (fibre::Signal& command : commands)
            for (double& value : command.values) value *= value;
        return commands;
    };
    SoughtSignals sought = two_signals();
    sought.signals[1].scale = 2.0, sought.signals[1].upper = 8.0, sought.signals[1].before = 1.0;
    const MatrixXd values = uneven(sought);
    const std::vector<fibre::Signal> plain = commands_of(sought, values),
                                     acting = acting_commands(sought, squares, values);
    std::vector<std::vector<double>> weights;
    MatrixXd expected = MatrixXd::Zero(values.rows(), values.cols());
    for (std::size_t g = 0; g < plain.size(); ++g) {
        weights.emplace_back();
        for (std::size_t k = 0; k < plain[g].values.size(); ++k) {
            EXPECT_NEAR(acting[g].values[k], plain[g].values[k] * plain[g].values[k], 1e-6);
            weights[g].push_back(std::cos(static_cast<double>(2 * g + k)));
            expected(static_cast<Index>(sought.groups[g].signal),
                     static_cast<Index>(k)) += weights[g][k] * 2.0 * plain[g].values[k] * sought.groups[g].factor;
        }
    }
    const MatrixXd gradient = acting_value_gradient(sought, squares, values, weights);
    EXPECT_LT((gradient - expected).norm(), 1e-6 * expected.norm());
    // Without an answer of their own they act as commanded, to the last bit.
    EXPECT_EQ(acting_commands(sought, {}, values), plain);
    EXPECT_EQ(acting_value_gradient(sought, {}, values, weights), value_gradient(sought, weights));
    // Commands that rest are moved by a trace, so that all of them have their knots.
    const std::vector<fibre::Signal> resting = acting_commands(
        sought, [](const std::vector<fibre::Signal>& commands) { return commands; }, unmoved_values(sought));
    EXPECT_NE(resting[0].values[0], resting[0].values[1]);
    EXPECT_NEAR(resting[0].values[0], resting[0].values[1], 1e-8);
}

}  // namespace
}  // namespace myo::inverse::sought_signals_test
