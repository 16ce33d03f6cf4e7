#include "dynamics/step_grid.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "dynamics/extrapolation.hpp"

namespace myo::dynamics::step_grid_test {
namespace {

using testing::ElementsAre;

/// A model whose loads begin at these times, in this order.
model::Model jumping_at(const std::vector<double>& times_s) {
    model::Model model;
    for (const double time_s : times_s) {
        model::DeadForce force{Eigen::VectorXd::Ones(1), Eigen::Vector3d::UnitX()};
        force.from_s = time_s;
        model.forces.push_back(force);
    }
    return model;
}

/// Ends of the steps of 0.1 s up to 0.3 s, in hundredths of a second.
std::vector<double> ends(const std::vector<double>& jumps_s, double end_s = 0.3) {
    std::vector<double> found = step_ends(jumping_at(jumps_s), 0.1, end_s);
    for (double& time : found) time *= 100.0;
    return found;
}

auto near_to(double hundredths) { return testing::DoubleNear(hundredths, 1e-9); }

TEST(StepGrid, ReachesTheEndWithMultiplesOfTheStep) {
    EXPECT_THAT(ends({}), ElementsAre(near_to(10), near_to(20), near_to(30)));
    EXPECT_THAT(ends({}, 0.3 + 1e-12), ElementsAre(near_to(10), near_to(20), near_to(30)))
        << "rounding is no further step";
    EXPECT_THAT(ends({}, 0.25), ElementsAre(near_to(10), near_to(20), near_to(30))) << "the last step is whole";
    EXPECT_THAT(ends({}, 0.01), ElementsAre(near_to(10)));
}

TEST(StepGrid, HasAnEndAtEveryJumpWithinTheRun) {
    EXPECT_THAT(ends({0.23, 0.07}), ElementsAre(near_to(7), near_to(10), near_to(20), near_to(23), near_to(30)));
    EXPECT_THAT(ends({0.2}), ElementsAre(near_to(10), near_to(20), near_to(30)));
    // Not at the start, before it, or from the end on.
    EXPECT_THAT(ends({0.0, -0.15, 0.3, 0.31}), ElementsAre(near_to(10), near_to(20), near_to(30)));
}

TEST(StepGrid, LeavesOutMultiplesWithinATwentiethOfAJump) {
    EXPECT_THAT(ends({0.2049}), ElementsAre(near_to(10), near_to(20.49), near_to(30)));
    EXPECT_THAT(ends({0.1951}), ElementsAre(near_to(10), near_to(19.51), near_to(30)));
    EXPECT_THAT(ends({0.2051}), ElementsAre(near_to(10), near_to(20), near_to(20.51), near_to(30)));
    // The end of the run stays.
    EXPECT_THAT(ends({0.299}), ElementsAre(near_to(10), near_to(20), near_to(29.9), near_to(30)));
}

TEST(StepGrid, MergesJumpsWithinRounding) {
    EXPECT_THAT(ends({0.25, 0.25 + 0.9e-7}), ElementsAre(near_to(10), near_to(20), near_to(25.000009), near_to(30)));
    EXPECT_THAT(ends({0.25, 0.25 + 1.1e-7}),
                ElementsAre(near_to(10), near_to(20), near_to(25), near_to(25.000011), near_to(30)));
    const std::vector<double> jumps = {0.25, 0.4};
    EXPECT_TRUE(is_jump(jumps, 0.25 - 0.9e-7, 0.1));
    EXPECT_FALSE(is_jump(jumps, 0.25 - 1.1e-7, 0.1));
    EXPECT_TRUE(is_jump(jumps, 0.4, 0.1));
    EXPECT_FALSE(is_jump({}, 0.4, 0.1));
}

/// One node that moves along x with these velocities for a second each.
Extrapolation past_of(double first_m_s, double second_m_s) {
    Extrapolation past;
    past.restart(0.0, Eigen::Vector3d::Zero());
    past.add(1.0, Eigen::Vector3d(first_m_s, 0.0, 0.0));
    past.add(2.0, Eigen::Vector3d(first_m_s + second_m_s, 0.0, 0.0));
    return past;
}

TEST(Predictors, AreSilentWhereTheVelocityChangesByMoreThanTwoFifths) {
    for (const double second : {0.61, 1.66}) EXPECT_TRUE(past_of(1.0, second).at(3.0)) << second;
    for (const double second : {0.59, 1.68, -1.0}) EXPECT_FALSE(past_of(1.0, second).at(3.0)) << second;
    // A parabola through 0, 1 and 1.8 goes on to 2.4.
    EXPECT_NEAR((*past_of(1.0, 0.8).at(3.0))(0, 0), 2.4, 1e-12);
    EXPECT_NEAR(past_of(1.0, -1.0).parabola_at(3.0)(0, 0), -3.0, 1e-12) << "asked for, it is told";
}

TEST(Predictors, OfFewerPositionsAreALineOrTheLastOne) {
    Extrapolation past;
    EXPECT_FALSE(past.known());
    past.restart(1.0, Eigen::Vector3d(2.0, 0.0, 0.0));
    EXPECT_TRUE(past.known());
    EXPECT_EQ(past.parabola_at(9.0)(0, 0), 2.0);
    past.add(2.0, Eigen::Vector3d(3.0, 0.0, 0.0));
    EXPECT_NEAR(past.parabola_at(4.0)(0, 0), 5.0, 1e-12);
    past.clear();
    EXPECT_FALSE(past.known());
}

}  // namespace
}  // namespace myo::dynamics::step_grid_test
