#include "validation/slip.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "validation/synthetic_folder.hpp"

// Every declaration error changes what it says and nothing else, and occurs only where it is one.

namespace myo::validation::slips_test {
namespace {

/// A beam under gravity, released straight, whose weight bends it by 15 mm: 1.5 rho g L^3 / (E h^2) of L.
SyntheticCase sagging_beam() {
    SyntheticCase c;
    c.body.bounds = {Eigen::Vector3d::Zero(), Eigen::Vector3d(0.1, 0.02, 0.01)};
    c.body.thickness_m = 0.01;
    c.body.clamp = {Eigen::Vector3d(-1e-3, -1e-3, -1e-3), Eigen::Vector3d(1e-3, 0.021, 0.011)};
    c.material = {.youngs_modulus_Pa = 9.81e5,
                  .declared_modulus_Pa = 1e6,
                  .poissons_ratio = 0.45,
                  .density_kg_m3 = 1000.0,
                  .damping_s = 1e-3};
    c.gravity_m_s2 = {0.0, 0.0, -9.81};
    c.markers = {{0.1, 0.01, 0.01}};
    c.trials.resize(1);
    c.trials[0].name = "motion";
    return c;
}

/// The case after an error, of a certain stream of random numbers.
SyntheticCase after(const char* id, const SyntheticCase& truth, std::uint64_t seed = 1) {
    SyntheticCase declared = truth;
    RandomStream random{seed};
    find_slip(id)->make(declared, random);
    return declared;
}

/// Lines of one declaration that the other does not have.
std::vector<std::string> changed_lines(const SyntheticCase& a, const SyntheticCase& b) {
    const auto lines = [](const std::string& text) {
        std::multiset<std::string> all;
        for (std::size_t from = 0, to = 0; from < text.size(); from = to + 1) {
            to = std::min(text.find('\n', from), text.size());
            all.insert(text.substr(from, to - from));
        }
        return all;
    };
    const std::multiset<std::string> before = lines(experiment_text(a)), now = lines(experiment_text(b));
    std::vector<std::string> changed;
    std::set_difference(now.begin(), now.end(), before.begin(), before.end(), std::back_inserter(changed));
    return changed;
}

TEST(Slips, HaveIdsOfTheirOwnByWhichTheyAreFound) {
    std::set<std::string> ids;
    for (const Slip& slip : slips()) {
        ids.insert(slip.id);
        EXPECT_EQ(find_slip(slip.id), &slip);
        // A check names the cause, or the experiment is refused with words about it.
        EXPECT_FALSE(slip.checks.empty() && slip.refusal.empty()) << slip.id;
    }
    EXPECT_EQ(ids.size(), slips().size());
    EXPECT_EQ(find_slip(""), nullptr);
    EXPECT_EQ(find_slip("units"), nullptr);
}

TEST(Slips, UnitsAreWrongByTheirFactor) {
    const SyntheticCase truth = sagging_beam();
    const SyntheticCase modulus = after("modulus_in_MPa", truth), density = after("density_in_g_cm3", truth);
    EXPECT_DOUBLE_EQ(modulus.material.declared_modulus_Pa, 1.0);
    EXPECT_EQ(modulus.material.youngs_modulus_Pa, truth.material.youngs_modulus_Pa);
    EXPECT_THAT(changed_lines(truth, modulus), testing::ElementsAre("youngs_modulus_Pa = 1"));
    EXPECT_THAT(changed_lines(truth, density), testing::ElementsAre("density_kg_m3 = 1"));
}

TEST(Slips, AModulusBeyondItsToleranceIsTooHighOrTooLow) {
    const SyntheticCase truth = sagging_beam();
    int high = 0;
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const double factor = after("modulus_beyond_tolerance", truth, seed).material.declared_modulus_Pa / 1e6;
        const double size = factor > 1.0 ? factor : 1.0 / factor;
        // The tolerance of 30 % is left on either side, whatever the guess was before.
        EXPECT_GE(size, 1.7);
        EXPECT_LE(size, 3.0);
        high += factor > 1.0 ? 1 : 0;
    }
    EXPECT_GT(high, 15);
    EXPECT_LT(high, 45);
}

TEST(Slips, AWrongStartIsOneWhereTheSagIsSeen) {
    SyntheticCase c = sagging_beam();
    const Slip& sagging = *find_slip("sagging_for_straight");
    const Slip& straight = *find_slip("straight_for_sagging");
    // Released straight: only the declaration of a sag can be wrong.
    c.noise_m = 1e-4;
    EXPECT_TRUE(sagging.fits(c));
    EXPECT_FALSE(straight.fits(c));
    EXPECT_EQ(after("sagging_for_straight", c).trials[0].start, experiment::StartState::equilibrium);
    // Seen are more than twenty noise levels of 15 mm.
    c.noise_m = 0.74e-3;
    EXPECT_TRUE(sagging.fits(c));
    c.noise_m = 0.76e-3;
    EXPECT_FALSE(sagging.fits(c));
    c.noise_m = 1e-4;
    c.trials[0].start = experiment::StartState::equilibrium;
    EXPECT_FALSE(sagging.fits(c));
    EXPECT_TRUE(straight.fits(c));
    EXPECT_EQ(after("straight_for_sagging", c).trials[0].start, experiment::StartState::straight);
    // A column under its weight does not sag, and neither does a body without weight.
    c.gravity_m_s2 = {-9.81, 0.0, 0.0};
    EXPECT_FALSE(straight.fits(c));
    c.gravity_m_s2 = {0.0, -9.81, 0.0};
    EXPECT_TRUE(straight.fits(c));
}

/// A thousandth of the height about the lower edge, which lets the body turn.
TEST(Slips, HeldOnALineLeavesTheLowerEdge) {
    const SyntheticCase truth = sagging_beam(), line = after("held_on_a_line", truth);
    EXPECT_NEAR(line.body.clamp.highest.z(), 1e-5, 1e-18);
    EXPECT_EQ(line.body.clamp.lowest, truth.body.clamp.lowest);
    EXPECT_EQ(line.body.clamp.highest.head<2>(), truth.body.clamp.highest.head<2>());
    EXPECT_TRUE(line.body.clamp.contains({0.0, 0.01, 0.0}));
    EXPECT_FALSE(line.body.clamp.contains({0.0, 0.01, 0.005}));
    SyntheticCase tail = truth;
    tail.body.family = BodyFamily::tail;
    EXPECT_TRUE(find_slip("held_on_a_line")->fits(truth));
    EXPECT_FALSE(find_slip("held_on_a_line")->fits(tail));
}

TEST(Slips, APredictedFitTrialIsASecondOneOnOneRecording) {
    const SyntheticCase truth = sagging_beam(), twice = after("fit_trial_predicted", truth);
    ASSERT_EQ(twice.trials.size(), 2u);
    EXPECT_EQ(twice.trials[1].role, experiment::TrialRole::validate);
    EXPECT_EQ(twice.trials[1].recording(), "motion");
    EXPECT_NE(twice.trials[1].name, twice.trials[0].name);
    EXPECT_EQ(twice.trials[0].role, truth.trials[0].role);
    EXPECT_THAT(changed_lines(truth, twice), testing::Contains("trace = \"motion.csv\""));
}

TEST(Slips, ClocksAndUnitsOfTimeStayOutOfTheDeclaration) {
    SyntheticCase truth = sagging_beam();
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const double clock = after("trace_in_another_clock", truth, seed).trials[0].clock_s;
        EXPECT_GE(clock, 100.0);
        EXPECT_LE(clock, 1e5);
        EXPECT_EQ(clock, std::round(clock));
    }
    EXPECT_THAT(changed_lines(truth, after("trace_in_another_clock", truth)), testing::IsEmpty());
    const Slip& signals = *find_slip("signals_in_ms");
    EXPECT_FALSE(signals.fits(truth));
    truth.muscles.resize(1);
    EXPECT_TRUE(signals.fits(truth));
    EXPECT_EQ(after("signals_in_ms", truth).trials[0].signal_unit_s, 1e-3);
    EXPECT_THAT(changed_lines(truth, after("signals_in_ms", truth)), testing::IsEmpty());
}

}  // namespace
}  // namespace myo::validation::slips_test
