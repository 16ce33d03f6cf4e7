#include "diagnosis/fit/repeatability.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "prediction/predict_trials.hpp"
#include "support/figures.hpp"
#include "support/swung_beam.hpp"

// What repeated trials leave between each other, on two recordings of the swung beam made by its own model.

namespace myo::diagnosis::repeatability_test {
namespace {

/// Spread of one recording about the motion that both share, three times the declared noise.
constexpr double spread_m = 3e-4;

/// The beam whose traces hold its own motion, the second one at times that are off by `late_s`, each with a spread of
/// its own.
setup::Setup recorded_twice(const test::Folder& folder, double late_s) {
    setup::Setup setup = test::swung_beam(folder);
    std::mt19937_64 random(5);
    std::normal_distribution<double> spread(0.0, spread_m);
    for (std::size_t t = 0; t < setup.trials.size(); ++t) {
        measurement::Recording& measured = setup.trials[t].measured;
        const Eigen::VectorXd time_s = measured.time_s;
        if (t == 1) measured.time_s.array() += late_s;
        const prediction::TrialPrediction made = prediction::predict_trial(setup, t,
                                                                           prediction::declared_values(setup));
        EXPECT_TRUE(made.ok()) << made.message;
        for (std::size_t m = 0; m < setup.marker_names.size(); ++m) {
            measured.tracks[m] = made.positions_m[m];
            for (double& x : measured.tracks[m].reshaped()) x += spread(random);
        }
        measured.time_s = time_s;
    }
    return setup;
}

std::vector<prediction::TrialPrediction> predictions_of(const setup::Setup& setup) {
    std::vector<std::size_t> all(setup.trials.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return prediction::predict_trials_with(setup, prediction::declared_values(setup), all);
}

Repeatability of(const setup::Setup& setup) { return repeatability(setup, predictions_of(setup), RepeatPolicy{}); }

TEST(Repeatability, IsTheSpreadOfRepeatedTrials) {
    const test::Folder folder("repeats");
    for (const double late_s : {0.0, 0.002}) {
        const Repeatability found = of(recorded_twice(folder, late_s));
        ASSERT_EQ(found.repeats.size(), 1u) << late_s;
        EXPECT_EQ(found.repeats[0], (std::pair<std::size_t, std::size_t>{0, 1}));
        test::record("spread over truth", found.rms_m / spread_m);
        EXPECT_NEAR(found.rms_m, spread_m, 0.05 * spread_m) << "a shift in time of " << late_s << " s is taken out";
        for (const double rms_m : found.marker_rms_m) EXPECT_NEAR(rms_m, spread_m, 0.15 * spread_m);
    }
}

/// A displaced camera is taken out where the registration is unknown, and counts where it is known.
TEST(Repeatability, TakesOutARigidDisplacementUnlessTheRegistrationIsKnown) {
    const test::Folder folder("displaced_repeats");
    setup::Setup setup = recorded_twice(folder, 0.0);
    for (Eigen::Matrix3Xd& track : setup.trials[1].measured.tracks)
        track.colwise() += Eigen::Vector3d(2e-3, 0.0, -1e-3);
    const double displaced_m = of(setup).rms_m;
    EXPECT_GT(displaced_m, 2.0 * spread_m);
    setup.experiment.registration.known = false;
    EXPECT_NEAR(of(setup).rms_m, spread_m, 0.05 * spread_m);
}

/// Trials that the model moves otherwise, or of unknown levels, are no repeats.
TEST(Repeatability, IsUnknownWhereNothingWasRepeated) {
    const test::Folder folder("no_repeats");
    setup::Setup setup = recorded_twice(folder, 0.0);
    setup.trials[1].model.gravity_m_s2 *= 1.05;
    const Repeatability other_load = of(setup);
    EXPECT_FALSE(other_load.known());
    EXPECT_EQ(other_load.rms_m, 0.0);
    setup = recorded_twice(folder, 0.0);
    const std::vector<prediction::TrialPrediction> predictions = predictions_of(setup);
    EXPECT_TRUE(repeatability(setup, predictions, RepeatPolicy{}).known());
    setup.trials[0].free_levels = {0};
    EXPECT_FALSE(repeatability(setup, predictions, RepeatPolicy{}).known());
}

}  // namespace
}  // namespace myo::diagnosis::repeatability_test
