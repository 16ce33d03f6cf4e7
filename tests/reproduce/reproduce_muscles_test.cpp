#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "reproduce/pressure_map.hpp"
#include "reproduce/real_robots.hpp"
#include "reproduce/reproduction.hpp"
#include "reproduce/tip_response.hpp"
#include "support/figures.hpp"
#include "support/folder.hpp"
#include "support/shared_data.hpp"

namespace myo::reproduce {
namespace {

using ::testing::HasSubstr;

bool has_data() {
    return !test::shared_data("data/mocap/arm_pressure_sweep").empty() &&
           !test::shared_data("data/mocap/fish").empty() && !test::shared_data("data/geometry").empty();
}

ReproduceSettings coarse_with_data() {
    ReproduceSettings settings;
    settings.data = test::shared_data("data/geometry") / "../..";
    settings.coarse = true;
    settings.threads = 2;
    return settings;
}

report::Json values_of(const std::string& id) {
    const Result<Reproduction> result = find_reproduction(id)->run(coarse_with_data(), {});
    EXPECT_TRUE(result) << result.error().text();
    EXPECT_TRUE(result->warnings.empty());
    EXPECT_FALSE(result->findings.empty());
    return result->values;
}

double number(const report::Json& json, const char* key) { return json.at(key).get<double>(); }

TEST(ReproduceArm, PressuresLeftOutArePredicted) {
    if (!has_data()) GTEST_SKIP() << "skipped: no data";
    const report::Json values = values_of("arm-static");
    const report::Json &published = values.at("models").at(1), &single = values.at("models").at(2),
                       &tied = values.at("models").at(3), &own = values.at("models").at(4);
    for (const char* key : {"every_second_0.7_s", "every_second_end"}) {
        test::record(key, number(own, key));
        EXPECT_LT(number(own, key), 0.04) << key;
        EXPECT_LT(number(single, key), 0.05) << key << ": the chamber lengthens one side";
        EXPECT_GT(number(tied, key), 1.5 * number(single, key)) << key << ": its antagonist lifts the tip";
        EXPECT_GT(number(published, key), 2.0 * number(own, key)) << key;
    }
    EXPECT_LT(number(own, "one_out_0.7_s"), 0.04);
    // Another day, other markers.
    test::record("others_in_plane_0.7_s", number(values, "others_in_plane_0.7_s"));
    EXPECT_LT(number(values, "others_in_plane_0.7_s"), 0.06);
    // More pressure lengthens the one muscle, shortens the other, and moves the tip farther.
    for (std::size_t i = 1; i < values.at("signals").size(); ++i) {
        EXPECT_GT(values.at("signals").at(i).at(0), values.at("signals").at(i - 1).at(0));
        EXPECT_LT(values.at("signals").at(i).at(1), values.at("signals").at(i - 1).at(1));
    }
    for (std::size_t k = 1; k < values.at("map").size(); ++k)
        for (const char* when : {"at_0.7_s", "at_end"})
            EXPECT_LT(number(values.at("map").at(k).at(when), "x_m"),
                      number(values.at("map").at(k - 1).at(when), "x_m"));
}

TEST(ReproduceArm, ASignalFollowsTheRecordedMotion) {
    if (!has_data()) GTEST_SKIP() << "skipped: no data";
    const report::Json fits = values_of("arm-dynamic").at("fits");
    for (const report::Json& fit : fits) {
        test::record(fit.at("name").get<std::string>() + " x, m", number(fit, "rms_x_m"));
        test::record(fit.at("name").get<std::string>() + " z, m", number(fit, "rms_z_m"));
        EXPECT_EQ(fit.at("at_bounds"), 0) << fit.at("name");
        EXPECT_LT(number(fit, "rms_x_m"), 0.04 * number(fit, "way_m")) << fit.at("name");
        EXPECT_LT(number(fit, "largest_jump"), 0.6 * number(fit, "range")) << fit.at("name");
    }
    const report::Json &published = fits.at(0), &single = fits.at(1), &tied = fits.at(2), &both = fits.at(3);
    EXPECT_LT(number(both, "rms_z_m"), 0.2 * number(tied, "rms_z_m"))
        << "a signal for each can lengthen the arm while it bends";
    EXPECT_LT(number(single, "rms_z_m"), 0.4 * number(tied, "rms_z_m"));
    EXPECT_LT(number(both, "rms_y_m"), 0.3 * number(published, "rms_y_m"));
}

TEST(ReproduceFish, SignalsFollowTheTail) {
    if (!has_data()) GTEST_SKIP() << "skipped: no data";
    const report::Json fits = values_of("fish").at("fits");
    for (const report::Json& fit : fits) {
        test::record(fit.at("name").get<std::string>() + " x, m", number(fit, "rms_x_m"));
        test::record(fit.at("name").get<std::string>() + " z, m", number(fit, "rms_z_m"));
        EXPECT_LT(number(fit, "rms_x_m"), 0.08 * number(fit, "way_m")) << fit.at("name");
    }
    EXPECT_NEAR(number(fits.at(2), "way_m"), 19.2e-3, 0.3e-3);
    EXPECT_LT(number(fits.at(2), "rms_x_m"), 0.04 * number(fits.at(2), "way_m"));
    EXPECT_LT(number(fits.at(2), "rms_z_m"), 0.4 * number(fits.at(1), "rms_z_m"));
}

TEST(ReproduceMuscles, WithoutDataTheySayWhatToFetch) {
    const test::Folder folder("reproduce_muscles");
    ReproduceSettings settings;
    settings.data = folder.path();
    settings.coarse = true;
    for (const char* id : {"arm-static", "arm-dynamic", "fish"}) {
        const Result<Reproduction> result = find_reproduction(id)->run(settings, {});
        ASSERT_TRUE(result) << result.error().text();
        ASSERT_GE(result->warnings.size(), 2u) << id;
        for (const std::string& warning : result->warnings)
            EXPECT_THAT(warning, HasSubstr("srl-ethz/diffPD_sim2real")) << id;
        EXPECT_THAT(result->warnings.back(), HasSubstr("data/geometry")) << id;
    }
}

TEST(ReproduceMuscles, DamagedRecordingsAreNamed) {
    const test::Folder folder("reproduce_muscles_damaged");
    folder.write("data/mocap/arm_pressure_sweep/100mbar.csv", "time_s\n0\n");
    folder.write("data/mocap/arm_pressure_sweep/notes.csv", "not one");
    ReproduceSettings settings;
    settings.data = folder.path();
    const Result<std::vector<RobotTrial>> sweep = read_arm_sweep(settings);
    ASSERT_FALSE(sweep);
    EXPECT_THAT(sweep.error().text(), HasSubstr("100mbar.csv"));
}

TEST(RealRobots, TheArmBendsInOnePlaneAndFartherWithPressure) {
    if (!has_data()) GTEST_SKIP() << "skipped: no data";
    const Result<std::vector<RobotTrial>> sweep = read_arm_sweep(coarse_with_data()),
                                          steps = read_arm_steps(coarse_with_data());
    ASSERT_TRUE(sweep) << sweep.error().text();
    ASSERT_TRUE(steps) << steps.error().text();
    ASSERT_GE(sweep->size(), 3u);
    double last = 0.0;
    for (const RobotTrial& trial : *sweep) {
        const Eigen::Matrix3Xd pose = mean_between(trial, 1.2, 1.4);
        EXPECT_GT(pose.col(0).norm(), last) << trial.name;
        EXPECT_NEAR(bending_direction({pose}), 0.05, 0.03) << trial.name;
        EXPECT_LT(trial.frame_rms_m, 1.6e-3);
        last = pose.col(0).norm();
    }
    // The same pressures again, with other markers and another chamber: as far, elsewhere.
    for (const RobotTrial& one : *steps)
        for (const RobotTrial& other : *steps) {
            if (one.pressure_mbar != other.pressure_mbar) continue;
            const Eigen::Matrix3Xd a = mean_between(one, 0.68, 0.72), b = mean_between(other, 0.68, 0.72);
            EXPECT_NEAR(a.col(0).norm() / b.col(0).norm(), 1.0, 0.1) << one.name << " " << other.name;
            EXPECT_TRUE(one.stepped);
        }
}

TEST(PressureMap, FindsPolynomialsAndBeginsAtRest) {
    const std::vector<double> pressures{75, 125, 175, 225, 275, 325, 375};
    Eigen::MatrixXd signals(2, 7);
    std::vector<double> lengths;
    const auto first = [](double p) { return 1.0 + 0.4 * p - 0.3 * p * p + 5.0 * p * p * p * p; };
    const auto second = [](double p) { return 1.0 - 0.1 * p * p * p; };
    for (Eigen::Index i = 0; i < 7; ++i) {
        const double p = 1e-3 * pressures[static_cast<std::size_t>(i)];
        signals.col(i) << first(p), second(p);
        lengths.push_back(p);
    }
    for (const PressureMap& map : {polynomial_map(pressures, signals), map_from_rest(pressures, signals, lengths)})
        for (const double p : {0.0, 100.0, 250.0, 400.0}) {
            EXPECT_NEAR(map.at(p)(0), first(1e-3 * p), 1e-10);
            EXPECT_NEAR(map.at(p)(1), second(1e-3 * p), 1e-10);
        }
    // One pressure is enough for a line from rest.
    EXPECT_NEAR(map_from_rest({200.0}, Eigen::MatrixXd::Constant(1, 1, 1.5), {1.0}).at(100.0)(0), 1.25, 1e-12);
    EXPECT_NEAR(polynomial_map({200.0}, Eigen::MatrixXd::Constant(1, 1, 1.5)).at(100.0)(0), 1.5, 1e-12);
}

TEST(TipResponse, HasTheDerivativeOfItsPoses) {
    if (!has_data()) GTEST_SKIP() << "skipped: no data";
    Result<MuscleBody> body = make_muscle_body(coarse_with_data(), paper_arm(), {.edge_m = 12e-3});
    ASSERT_TRUE(body) << body.error().text();
    EXPECT_NEAR(model::mass_matrix(body->model).isotropic.sum(), 1070.0 * 126.675e-6, 1e-6) << "the plus with its hole";
    const TipResponse response(*body, free_muscles());
    const Eigen::Vector2d signals(1.2, 0.95), step(1e-4, 0.0);
    const TipPose pose = response.at(signals);
    ASSERT_TRUE(pose.ok) << pose.message;
    EXPECT_LT(pose.tracked_m()(0), -5e-3) << "away from the muscle that lengthens";
    for (std::size_t s = 0; s < 2; ++s) {
        const Eigen::Vector2d d = s == 0 ? step : Eigen::Vector2d(0.0, 1e-4);
        const Eigen::Matrix3Xd difference = (response.at(signals + d).displacement_m -
                                             response.at(signals - d).displacement_m) /
                                            2e-4;
        EXPECT_GT(difference.norm(), 1e-2);
        EXPECT_LT((difference - pose.by_signal_m[s]).norm(), 1e-4 * difference.norm());
    }
}

TEST(TipResponse, FindsTheSignalsOfItsOwnPose) {
    if (!has_data()) GTEST_SKIP() << "skipped: no data";
    Result<MuscleBody> body = make_muscle_body(coarse_with_data(), paper_fish(), {.edge_m = 10e-3});
    ASSERT_TRUE(body) << body.error().text();
    const TipResponse response(*body, free_muscles());
    const Eigen::Vector2d signals(1.3, 0.9);
    const TipPose pose = response.at(signals);
    ASSERT_TRUE(pose.ok) << pose.message;
    EXPECT_GT(pose.tracked_m()(0), 1e-3);
    const Result<PoseFit> fit = fit_pose(response, pose.displacement_m, unmoved(response), {});
    ASSERT_TRUE(fit) << fit.error().text();
    EXPECT_LT((fit->signals - signals).norm(), 1e-4);
}

}  // namespace
}  // namespace myo::reproduce
