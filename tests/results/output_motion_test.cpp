#include "results/output_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support/known_run.hpp"
#include "support/swung_beam.hpp"

namespace myo::results {
namespace {

class OutputMotion : public testing::Test {
protected:
    OutputMotion() : folder_("output_motion"), setup_(test::swung_beam(folder_, 1.0)) {}

    test::Folder folder_;
    setup::Setup setup_;
};

TEST_F(OutputMotion, OfPositionsIsInTheCameraFrame) {
    const Eigen::Vector3d miss(1e-3, -2e-3, 3e-3);
    prediction::ParameterValues values = prediction::declared_values(setup_);
    values.translation_m = {0.01, 0.0, -0.02};
    // A quarter turn about z: x becomes y.
    values.rotation_rad = {0.0, 0.0, 0.5 * std::numbers::pi};
    const ComparedMotion motion = compared_motion(setup_, 0, values, test::missed_by(setup_, 0, miss));
    ASSERT_EQ(motion.simulated_m.size(), 4u);
    EXPECT_EQ(motion.time_s, setup_.trials[0].measured.time_s);
    EXPECT_EQ(motion.measured_m[0], setup_.trials[0].measured.tracks[0]);
    // tip_left rests at (0.1, 0, 0.03).
    const Eigen::Vector3d expected(0.01 + 2e-3, 0.1 + 1e-3, 0.03 + 3e-3 - 0.02);
    EXPECT_LT((motion.simulated_m[0].col(7) - expected).norm(), 1e-15);
}

TEST_F(OutputMotion, OfDisplacementsStartsAtZero) {
    setup_.experiment.markers.compare = experiment::Comparison::displacement;
    for (const Eigen::Matrix3Xd& track : setup_.trials[0].measured.tracks)
        setup_.trials[0].reference_m.push_back(track.col(0));
    prediction::TrialPrediction prediction = test::missed_by(setup_, 0, {0.0, 0.0, 5e-3});
    prediction.positions_m[1].col(4).x() += 7e-3;
    const ComparedMotion motion = compared_motion(setup_, 0, prediction::declared_values(setup_), prediction);
    for (std::size_t m = 0; m < motion.simulated_m.size(); ++m) {
        EXPECT_LT(motion.measured_m[m].cwiseAbs().maxCoeff(), 1e-15);
        EXPECT_LT(motion.simulated_m[m].col(0).norm(), 1e-15);
    }
    EXPECT_NEAR(motion.simulated_m[1](0, 4), 7e-3, 1e-15);
    EXPECT_NEAR(motion.simulated_m[1](2, 4), 0.0, 1e-15);
}

TEST_F(OutputMotion, OfTheSimulationHasTheSamplesOfTheRecording) {
    const prediction::TrialPrediction prediction = test::missed_by(setup_, 0, {0.0, 1e-3, 0.0});
    const measurement::Recording recording = simulated_recording(setup_, 0, prediction);
    EXPECT_EQ(recording.labels, setup_.marker_names);
    EXPECT_EQ(recording.time_s, setup_.trials[0].measured.time_s);
    EXPECT_EQ(recording.rate_Hz, setup_.trials[0].measured.rate_Hz);
    EXPECT_EQ(recording.tracks, prediction.positions_m);
}

TEST_F(OutputMotion, HasTheFrequencyOfItsLargestVibration) {
    prediction::TrialPrediction prediction = test::missed_by(setup_, 0, Eigen::Vector3d::Zero());
    const Eigen::VectorXd& t = setup_.trials[0].measured.time_s;
    // The mean of the samples is rounded unless the number is short in binary.
    for (const double rest_m : {0.1, 1.0 / 3.0, 0.125}) {
        for (Eigen::Matrix3Xd& track : prediction.positions_m) track.setConstant(rest_m);
        EXPECT_EQ(main_frequency(setup_, 0, prediction), 0.0) << rest_m;
    }
    for (Eigen::Index k = 0; k < t.size(); ++k) {
        prediction.positions_m[2](2, k) += 2e-3 * std::sin(2.0 * std::numbers::pi * 6.0 * t(k));
        // A smaller and faster one at another marker.
        prediction.positions_m[0](1, k) += 1e-3 * std::sin(2.0 * std::numbers::pi * 17.0 * t(k));
    }
    // The scan has steps of a quarter of the resolution of one second.
    EXPECT_NEAR(main_frequency(setup_, 0, prediction), 6.0, 0.13);
    for (Eigen::Index k = 0; k < t.size(); ++k)
        prediction.positions_m[0](1, k) += 3e-3 * std::sin(2.0 * std::numbers::pi * 17.0 * t(k));
    EXPECT_NEAR(main_frequency(setup_, 0, prediction), 17.0, 0.13);
}

TEST_F(OutputMotion, HasNoFrequencyInAFewSamples) {
    prediction::TrialPrediction prediction = test::missed_by(setup_, 0, Eigen::Vector3d::Zero());
    for (Eigen::Index k = 0; k < prediction.positions_m[0].cols(); ++k)
        prediction.positions_m[0](2, k) += 1e-3 * std::sin(40.0 * setup_.trials[0].measured.time_s(k));
    EXPECT_GT(main_frequency(setup_, 0, prediction), 0.0);
    setup_.trials[0].first_sample = setup_.trials[0].measured.sample_count() - 7;
    EXPECT_EQ(main_frequency(setup_, 0, prediction), 0.0);
}

}  // namespace
}  // namespace myo::results
