#include <gtest/gtest.h>

#include <cmath>

#include "diagnosis/fit/joint_fit.hpp"
#include "diagnosis/fit/sensor_rows.hpp"
#include "support/chambered_beam.hpp"
#include "support/figures.hpp"

namespace myo::diagnosis {
namespace {

/// A hold by a tendon of 2 mm shortening, whose tension is measured to 1 mN.
setup::Setup held_beam(const test::Folder& folder) {
    return test::chambered_beam(folder, 0.1, [&](experiment::Experiment& e) {
        e.chambers.clear();
        experiment::TendonDeclaration tendon = test::upper_tendon();
        tendon.drive = experiment::TendonDrive::shortening;
        e.tendons = {tendon};
        e.sensors = {{"motor", experiment::SensorKind::tendon_tension, "upper", 0.001}};
        folder.write("sensors.csv", "time_s,motor_N\n0,0\n");
        experiment::TrialDeclaration& trial = e.trials[0];
        trial.sensors = folder.path() / "sensors.csv";
        trial.hold = true;
        trial.start = experiment::StartState::equilibrium;
        trial.constant_commands = {{"upper", 0.002}};
    });
}

/// Markers of 1 m noise say nothing of the modulus: the sensor alone determines it.
TEST(SensorFit, FindsTheModulusFromTheSensorAlone) {
    const test::Folder folder("sensor_fit");
    setup::Setup setup = held_beam(folder);
    setup.noise_m.setOnes();
    prediction::ParameterValues truth = prediction::declared_values(setup);
    truth.youngs_modulus_Pa *= 1.1;
    const prediction::TrialPrediction made = prediction::predict_trial(setup, 0, truth);
    ASSERT_TRUE(made.ok()) << made.message;
    setup.trials[0].sensors[0].values += made.sensor_residuals[0];
    const FitData data = fit_data(setup, {0});
    const prediction::ParameterValues start = prediction::declared_values(setup);
    const DiagnosisPolicy policy;
    const JointFit fit = joint_fit({setup, data, start, policy, EffectFreedom::all, {30}}, {});
    ASSERT_TRUE(fit.usable()) << fit.report.message;
    EXPECT_NEAR(fit.values.youngs_modulus_Pa / truth.youngs_modulus_Pa, 1.0, 1e-3);
    ASSERT_EQ(fit.sensor_residual.size(), 1);
    EXPECT_LT(std::abs(fit.sensor_residual(0)), 0.1);
    EXPECT_EQ(fit.samples(), static_cast<double>(fit.residual.size()) + 1.0);
    EXPECT_NEAR(fit.squares(), fit.residual.squaredNorm() + fit.sensor_residual.squaredNorm(), 1e-12);
    // The slope by the modulus, against a difference of rows.
    const auto row_at = [&](double factor) {
        prediction::ParameterValues there = fit.values;
        there.youngs_modulus_Pa *= factor;
        return sensor_rows(setup, data.trials, {prediction::predict_trial(setup, 0, there)}, policy.declared)(0);
    };
    const double difference = (row_at(1.01) - row_at(0.99)) / (0.02 * fit.values.youngs_modulus_Pa);
    EXPECT_GT(difference, 0.0);
    EXPECT_NEAR(fit.sensor_jacobian(0, 0) / difference, 1.0, 1e-2);
    // A fit that knows slopes and motion of another one ends at the same place.
    const JointFit again = joint_fit({setup, data, start, policy, EffectFreedom::all, {30}, warm_start_of(fit)}, {});
    EXPECT_NEAR(again.values.youngs_modulus_Pa / truth.youngs_modulus_Pa, 1.0, 1e-3);
    // A row is in units of the noise and of what mesh and step may change.
    const double reading = setup.trials[0].sensors[0].values(0), miss = fit.predictions[0].sensor_residuals[0](0);
    EXPECT_NEAR(fit.sensor_residual(0), miss / std::hypot(0.001, 0.05 * reading), 1e-9);
    test::record("modulus", std::vector<double>{fit.values.youngs_modulus_Pa, again.values.youngs_modulus_Pa});
}

}  // namespace
}  // namespace myo::diagnosis
