#include <gtest/gtest.h>

#include "calibration/calibrate.hpp"
#include "prediction/runnable_start.hpp"
#include "support/chambered_beam.hpp"

namespace myo::calibration {
namespace {

constexpr double inflated_modulus_Pa = 2.6e5;

/// The chambered beam under a pressure near the one at which it runs away, with the pose of the true modulus as its
/// measurement and half that modulus declared.
setup::Setup inflated_beam(const test::Folder& folder, double inflated_Pa) {
    setup::Setup setup = test::chambered_beam(folder, 0.1, [&](experiment::Experiment& e) {
        e.material.youngs_modulus_Pa = 0.5 * inflated_modulus_Pa;
        e.material.youngs_modulus_tolerance = 2.0;
        e.trials.resize(1);
        e.trials[0].hold = true;
        e.trials[0].start = experiment::StartState::equilibrium;
        e.trials[0].constant_commands = {{"upper", inflated_Pa}};
    });
    prediction::ParameterValues truth = prediction::declared_values(setup);
    truth.youngs_modulus_Pa = inflated_modulus_Pa;
    const prediction::TrialPrediction pose = prediction::predict_trial(setup, 0, truth);
    EXPECT_TRUE(pose.ok()) << pose.message;
    setup.trials[0].measured.tracks = pose.positions_m;
    return setup;
}

TEST(RunnableStart, FindsTheModulusOfABodyThatTheDeclaredOneLetsRunAway) {
    const test::Folder folder("runnable_start");
    const setup::Setup setup = inflated_beam(folder, 4.5e4);
    const prediction::ParameterValues declared = prediction::declared_values(setup);
    EXPECT_FALSE(prediction::predict_trial(setup, 0, declared).ok()) << "else the test shows nothing";
    const std::vector<prediction::ModelParameter> parameters = prediction::free_parameters(setup, {"youngs_modulus"});
    const auto start = prediction::runnable_start(setup, declared, parameters, {0}, {});
    ASSERT_TRUE(start);
    EXPECT_GT(start->youngs_modulus_Pa, declared.youngs_modulus_Pa);
    const Calibration calibration = calibrate(setup);
    ASSERT_TRUE(calibration.usable()) << calibration.fit.message;
    EXPECT_NEAR(calibration.after.values.youngs_modulus_Pa, inflated_modulus_Pa, 1e-3 * inflated_modulus_Pa);
}

TEST(RunnableStart, NeedsAFittedModulus) {
    const test::Folder folder("no_runnable_start");
    const setup::Setup setup = inflated_beam(folder, 4.5e4);
    EXPECT_FALSE(prediction::runnable_start(setup, prediction::declared_values(setup), {}, {0}, {}));
}

}  // namespace
}  // namespace myo::calibration
