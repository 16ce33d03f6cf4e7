#include "planning/detection.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "statistics/distributions.hpp"
#include "statistics/nuisance_space.hpp"

// Probability of detection against simulated repetitions of a linear experiment.

namespace myo::planning::detection_test {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int repetitions = 4000;
const DetectionPolicy policy;

/// Two trials with two calibrated parameters and an effect whose change is partly absorbed by them.
struct LinearExperiment {
    Index rows = 400;
    MatrixXd J{rows, 2};
    VectorXd effect{rows};
    std::vector<ErrorBlock> blocks{{0, 250}, {250, 150}};

    LinearExperiment() {
        for (Index k = 0; k < rows; ++k) {
            const double t = 0.05 * static_cast<double>(k);
            J.row(k) << std::sin(t), t * std::cos(t);
            effect(k) = std::sin(1.1 * t) + 0.2;
        }
    }
};

/// Share of repetitions in which the score test rejects, with white noise and a numerical error along the effect.
double rejected(const LinearExperiment& e, double size, double numerical_error) {
    const statistics::NuisanceSpace nuisance(e.J);
    const VectorXd outside = nuisance.outside(e.effect), u = outside.normalized();
    const double deviation = 1.0 / std::sqrt(noncentrality(u, e.blocks, numerical_error));
    std::mt19937_64 random(5);
    std::normal_distribution<double> normal;
    int count = 0;
    for (int i = 0; i < repetitions; ++i) {
        VectorXd r = size * e.effect + e.J * Eigen::Vector2d(3.0 * normal(random), normal(random));
        for (double& x : r) x += normal(random);
        for (const ErrorBlock& block : e.blocks) {
            const VectorXd own = u.segment(block.begin, block.size);
            r.segment(block.begin, block.size) += numerical_error * std::sqrt(static_cast<double>(block.size)) *
                                                  normal(random) * own.normalized();
        }
        const double score = u.dot(nuisance.outside(r).col(0)) / deviation;
        if (score * score > statistics::chi_squared_upper_quantile(policy.alpha, 1.0)) ++count;
    }
    return static_cast<double>(count) / repetitions;
}

TEST(Detection, EqualsSimulatedRepetitions) {
    const LinearExperiment e;
    const VectorXd outside = statistics::NuisanceSpace(e.J).outside(e.effect);
    for (const double numerical_error : {0.0, 0.12})
        for (const double size : {0.0, 0.1, 0.2, 0.4}) {
            const double probability = detection_probability(noncentrality(size * outside, e.blocks, numerical_error),
                                                             1.0, policy.alpha);
            const double error = std::sqrt(probability * (1.0 - probability) / repetitions);
            EXPECT_NEAR(rejected(e, size, numerical_error), probability, 3.0 * error + 1e-9)
                << size << " " << numerical_error;
            if (size == 0.0) {
                EXPECT_NEAR(probability, policy.alpha, 1e-12);
            }
        }
}

TEST(Detection, GrowsWithTheDifferenceAndFallsWithTheError) {
    const LinearExperiment e;
    double before = 0.0;
    for (const double size : {0.0, 0.05, 0.1, 0.2, 0.5, 100.0}) {
        const double probability = detection_probability(noncentrality(size * e.effect, e.blocks, 0.1), 2.0,
                                                         policy.alpha);
        EXPECT_GT(probability, before) << size;
        before = probability;
    }
    EXPECT_GT(before, 1.0 - 1e-9);
    EXPECT_LT(noncentrality(e.effect, e.blocks, 0.2), noncentrality(e.effect, e.blocks, 0.1));
    EXPECT_LT(noncentrality(1e6 * e.effect, {{0, e.rows}}, 0.1), std::pow(1e6 * e.effect.norm(), 2));
    EXPECT_EQ(noncentrality(0.0 * e.effect, e.blocks, 0.1), 0.0);
}

TEST(Detection, NeededNoncentralityGivesTheProbability) {
    for (const double freedom : {1.0, 2.0, 3.0}) {
        const double needed = needed_noncentrality(0.8, freedom, policy);
        EXPECT_NEAR(detection_probability(needed, freedom, policy.alpha), 0.8, 1e-9);
    }
    // Tabulated: Haynam et al. 1962, alpha 0.01, power 0.8, one degree of freedom.
    EXPECT_NEAR(needed_noncentrality(0.8, 1.0, policy), 11.679, 1e-3);
}

TEST(Detection, BlocksAreTheRowsOfATrial) {
    statistics::ResidualLayout layout;
    layout.series = {{0, 0, 0, 0, 4}, {0, 0, 1, 4, 8}, {2, 0, 0, 8, 11}};
    const std::vector<ErrorBlock> blocks = error_blocks(layout, 5);
    ASSERT_EQ(blocks.size(), 2u);
    EXPECT_EQ(blocks[0].begin, 5);
    EXPECT_EQ(blocks[0].size, 8);
    EXPECT_EQ(blocks[1].begin, 13);
    EXPECT_EQ(blocks[1].size, 3);
}

}  // namespace
}  // namespace myo::planning::detection_test
