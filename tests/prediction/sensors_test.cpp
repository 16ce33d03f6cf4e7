#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "prediction/prediction.hpp"
#include "prediction/weighted_residuals.hpp"
#include "support/chambered_beam.hpp"
#include "support/figures.hpp"

// Sensors beside the markers: reaction of the support, volume of a chamber, tension and shortening of a tendon.

namespace myo::prediction {
namespace {

using experiment::Experiment;
using experiment::SensorKind;
using testing::HasSubstr;

/// A sensor, declared and recorded in the fit trial.
void record(const test::Folder& folder, Experiment& e, const experiment::SensorDeclaration& sensor,
            const std::string& csv) {
    e.sensors.push_back(sensor);
    folder.write("sensors.csv", csv);
    e.trials[0].sensors = folder.path() / "sensors.csv";
}

/// Mean of predicted readings; the recording holds zeros.
double mean_reading(const TrialPrediction& prediction) { return prediction.sensor_residuals.at(0).mean(); }

/// At rest the support bears the weight of the body and what hangs on it.
TEST(Sensors, SeeTheWeightOnTheSupport) {
    const test::Folder folder("sensor_weight");
    const setup::Setup setup = test::chambered_beam(folder, 0.1, [&](Experiment& e) {
        e.trials[0].hold = true;
        e.trials[0].start = experiment::StartState::equilibrium;
        record(folder, e, {"cell", SensorKind::reaction, "", 0.001}, "time_s,cell_z_N,cell_x_N\n0,0,0\n0.1,0,0\n");
    });
    ASSERT_EQ(setup.trials[0].sensors.size(), 2u);
    const TrialPrediction rest = predict_trial(setup, 0, declared_values(setup));
    ASSERT_TRUE(rest.ok()) << rest.message;
    const double weight = 1070.0 * 9.81 * setup.body->volume_m3;
    EXPECT_NEAR(rest.sensor_residuals[0][0], weight, 1e-6 * weight);
    EXPECT_NEAR(rest.sensor_residuals[1][0], 0.0, 1e-9 * weight);
}

/// Released, the body falls: its support bears little at first, and swings about the weight; the impulse over the swing
/// is the change of momentum.
TEST(Sensors, SeeTheSwingOnTheSupport) {
    const test::Folder folder("sensor_swing");
    std::string csv = "time_s,cell_z_N\n";
    for (int k = 1; k < 100; ++k) csv += std::to_string(0.0051 * k) + ",0\n";
    const setup::Setup setup = test::chambered_beam(folder, 0.5, [&](Experiment& e) {
        record(folder, e, {"cell", SensorKind::reaction, "", 0.001}, csv);
    });
    const TrialPrediction swing = predict_trial(setup, 0, declared_values(setup));
    ASSERT_TRUE(swing.ok()) << swing.message;
    const double weight = 1070.0 * 9.81 * setup.body->volume_m3;
    EXPECT_LT(swing.sensor_residuals[0].head(3).mean(), 0.7 * weight);
    EXPECT_GT(swing.sensor_residuals[0].maxCoeff(), 1.2 * weight);
    EXPECT_NEAR(mean_reading(swing) / weight, 1.0, 0.05);
}

/// The volume of a chamber grows with its pressure, and says what markers alone do not.
TEST(Sensors, SeeTheVolumeOfAChamber) {
    const test::Folder folder("sensor_volume");
    const auto beam = [&](double pressure_Pa) {
        return test::chambered_beam(folder, 0.1, [&](Experiment& e) {
            e.trials[0].hold = true;
            e.trials[0].start = experiment::StartState::equilibrium;
            e.trials[0].constant_commands = {{"upper", pressure_Pa}};
            record(folder, e, {"air", SensorKind::chamber_volume, "upper", 1e-8}, "time_s,air_m3\n0,0\n");
        });
    };
    const setup::Setup loose = beam(0.0), blown = beam(4000.0);
    const double at_rest = 0.07 * 0.018 * 0.008;
    EXPECT_NEAR(mean_reading(predict_trial(loose, 0, declared_values(loose))) / at_rest, 1.0, 0.02);
    const TrialPrediction prediction = predict_trial(blown, 0, declared_values(blown));
    ASSERT_TRUE(prediction.ok()) << prediction.message;
    EXPECT_GT(mean_reading(prediction), 1.01 * at_rest);
    EXPECT_NEAR(mean_reading(prediction),
                setup::chamber_volume(*blown.body, blown.chambers[0], prediction.trace.positions[0]), 1e-15);
}

setup::Setup tendon_beam(const test::Folder& folder, experiment::TendonDrive drive, double command, SensorKind kind) {
    return test::chambered_beam(folder, 0.1, [&](Experiment& e) {
        e.chambers.clear();
        experiment::TendonDeclaration tendon = test::upper_tendon();
        tendon.drive = drive;
        e.tendons = {tendon};
        e.trials[0].hold = true;
        e.trials[0].start = experiment::StartState::equilibrium;
        e.trials[0].constant_commands = {{"upper", command}};
        const std::string column = kind == SensorKind::tendon_tension ? "motor_N" : "motor_m";
        record(folder, e, {"motor", kind, "upper", 0.01}, "time_s," + column + "\n0,0\n");
    });
}

/// A shortening that is driven and a tension that is measured, and the other way round, belong together.
TEST(Sensors, SeeTensionAndShorteningOfATendon) {
    const test::Folder folder("sensor_tendon");
    const setup::Setup taken = tendon_beam(folder, experiment::TendonDrive::shortening, 0.002,
                                           SensorKind::tendon_tension);
    const TrialPrediction shortened = predict_trial(taken, 0, declared_values(taken));
    ASSERT_TRUE(shortened.ok()) << shortened.message;
    const double tension = mean_reading(shortened);
    EXPECT_GT(tension, 0.1);
    const setup::Setup pulled = tendon_beam(folder, experiment::TendonDrive::tension, tension,
                                            SensorKind::tendon_shortening);
    const TrialPrediction other = predict_trial(pulled, 0, declared_values(pulled));
    ASSERT_TRUE(other.ok()) << other.message;
    // A thread that does not stretch is as stiff as a thousand bodies.
    EXPECT_NEAR(mean_reading(other), 0.002, 0.002 * 5e-3);
}

/// Readings are rows of the fit with exact derivatives.
TEST(Sensors, AreWeighedWithTheirDerivatives) {
    const test::Folder folder("sensor_rows");
    setup::Setup setup = tendon_beam(folder, experiment::TendonDrive::shortening, 0.002, SensorKind::tendon_tension);
    setup.trials[0].options.solver.tolerance = 1e-11;
    const ParameterValues values = declared_values(setup);
    const std::vector<ModelParameter> parameters = free_parameters(setup, {"youngs_modulus"});
    const TrialPrediction here = predict_trial(setup, 0, values, parameters);
    ASSERT_TRUE(here.ok()) << here.message;
    const inverse::ResidualEvaluation rows = weighted_residuals(setup, {0}, {here}, parameters.size());
    ASSERT_TRUE(rows.ok) << rows.message;
    const Eigen::Index last = rows.residuals.size() - 1;
    EXPECT_EQ(rows.residuals[last], here.sensor_residuals[0][0] / 0.01);
    const double step = 1e-3 * values.youngs_modulus_Pa;
    const auto at = [&](double E) {
        ParameterValues changed = values;
        changed.youngs_modulus_Pa = E;
        return predict_trial(setup, 0, changed).sensor_residuals[0][0] / 0.01;
    };
    const double difference = (at(values.youngs_modulus_Pa + step) - at(values.youngs_modulus_Pa - step)) / (2 * step);
    EXPECT_NE(difference, 0.0);
    EXPECT_NEAR(rows.jacobian(last, 0) / difference, 1.0, 1e-4);
}

TEST(Sensors, RefuseColumnsOfNone) {
    const test::Folder folder("sensor_column");
    test::swung_beam(folder, 0.1);
    Result<Experiment> experiment = experiment::read_experiment(folder.path());
    ASSERT_TRUE(experiment) << experiment.error().text();
    record(folder, *experiment, {"cell", SensorKind::reaction, "", 0.001}, "time_s,call_z_N\n0,0\n");
    const Result<setup::Setup> setup = setup::prepare_setup(*experiment, {});
    ASSERT_FALSE(setup);
    EXPECT_THAT(setup.error().text(), HasSubstr("column \"call_z_N\" belongs to no declared [[sensor]]"));
}

}  // namespace
}  // namespace myo::prediction
