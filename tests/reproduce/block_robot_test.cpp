#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <atomic>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "app/small_experiment.hpp"
#include "model/mass_matrix.hpp"
#include "reproduce/arm_maps.hpp"
#include "reproduce/muscle_body.hpp"
#include "reproduce/tip_response.hpp"
#include "support/folder.hpp"

// Poses and maps of a robot whose geometry is made here: a block of 20 x 10 x 40 mm that hangs from its top, with a
// muscle in either half. The measured robots need data that not every machine has.

namespace myo::reproduce::block_robot_test {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector2d;
using Eigen::Vector3d;
using testing::HasSubstr;

MuscleRobot block() {
    return {"block",
            "block.stl",
            {{-0.001, -0.001, 0.0395}, {0.021, 0.011, 0.0405}},
            {{0.01, 0.0, 0.0}, {0.02, 0.01, 0.04}},
            {{0.0, 0.0, 0.0}, {0.01, 0.01, 0.04}},
            5e-3,
            -9.81,
            {{0.0, 0.005, 0.0}, {0.02, 0.005, 0.0}},
            {{0.0, 0.005, 0.0}, {0.02, 0.005, 0.0}, {0.01, 0.0, 0.01}},
            -1.0};
}

Result<MuscleBody> body_of(const MuscleRobot& robot, const MuscleBodyOptions& options = {}) {
    const test::Folder folder("block_robot");
    folder.write("data/geometry/block.stl", test::box_stl(20.0, 10.0, 40.0));
    ReproduceSettings settings;
    settings.data = folder.path();
    return make_muscle_body(settings, robot, options);
}

/// The block with a signal for each muscle.
const TipResponse& free_block() {
    static const TipResponse response(*body_of(block()), free_muscles());
    return response;
}

TEST(BlockRobot, HasItsMassMusclesAndPoints) {
    const Result<MuscleBody> body = body_of(block());
    ASSERT_TRUE(body) << body.error().text();
    EXPECT_NEAR(model::mass_matrix(body->model).isotropic.sum(), 1070.0 * 0.02 * 0.01 * 0.04, 1e-9);
    ASSERT_EQ(body->model.fibres->size(), 2u);
    for (std::size_t muscle = 0; muscle < 2; ++muscle) {
        double volume = 0.0;
        for (const auto& point : (*body->model.fibres)[muscle].points) volume += point.volume;
        EXPECT_NEAR(volume, 0.01 * 0.01 * 0.04, 1e-12) << "half of the block";
    }
    ASSERT_EQ(body->points.bindings.size(), 4u);
    const Matrix3Xd& X = body->model.body->mesh.nodes;
    // The tracked point is the mean of its points; the weights of a binding are a partition of one.
    const measurement::MarkerBinding& tracked = body->points.bindings[0];
    EXPECT_NEAR(tracked.weights.sum(), 1.0, 1e-12);
    EXPECT_LT((measurement::marker_position(tracked, X(Eigen::all, tracked.nodes)) - Vector3d(0.01, 0.005, 0.0)).norm(),
              1e-12);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < body->points.bindings[i].nodes.size(); ++k)
            EXPECT_EQ(body->points.nodes[static_cast<std::size_t>(body->points.positions[i][k])],
                      body->points.bindings[i].nodes[k]);
    EXPECT_EQ(body_of(block(), {.muscles = 1})->model.fibres->size(), 1u);
}

TEST(BlockRobot, WithoutGeometryOrCellsItIsRefused) {
    MuscleRobot robot = block();
    robot.second = {{0.03, 0.0, 0.0}, {0.04, 0.01, 0.04}};
    const Result<MuscleBody> no_cells = body_of(robot);
    ASSERT_FALSE(no_cells);
    EXPECT_EQ(no_cells.error().text(), "block: muscle 2 has no cells of the mesh; choose a finer one");
    EXPECT_TRUE(body_of(robot, {.muscles = 1})) << "the second is not asked for";
    robot.geometry = "absent.stl";
    EXPECT_FALSE(body_of(robot));
    const ReproduceSettings settings{.data = "somewhere"};
    EXPECT_EQ(geometry_file(settings, robot), std::filesystem::path("somewhere/data/geometry/absent.stl"));
    EXPECT_THAT(missing_geometry(settings, robot), HasSubstr("fetch absent.stl"));
}

/// Exchanging the signals of the halves mirrors the block.
TEST(BlockRobot, BendsAwayFromTheLongerHalfAndMirrored) {
    const TipResponse& response = free_block();
    ASSERT_TRUE(response.rest().ok) << response.rest().message;
    EXPECT_EQ(response.rest().displacement_m.norm(), 0.0);
    const TipPose one = response.at(Vector2d(1.1, 0.97)), other = response.at(Vector2d(0.97, 1.1)),
                  both = response.at(Vector2d(1.05, 1.05));
    ASSERT_TRUE(one.ok && other.ok && both.ok);
    EXPECT_LT(one.tracked_m()(0), -1e-4);
    EXPECT_NEAR(one.tracked_m()(0), -other.tracked_m()(0), 1e-7);
    EXPECT_NEAR(one.tracked_m()(2), other.tracked_m()(2), 1e-7);
    EXPECT_NEAR(one.tracked_m()(1), 0.0, 1e-7);
    // Equal signals lengthen the block, downwards.
    EXPECT_NEAR(both.tracked_m()(0), 0.0, 1e-7);
    EXPECT_LT(both.tracked_m()(2), -1e-4);
}

TEST(BlockRobot, SlopesOfItsPosesAreThoseOfDifferences) {
    const TipResponse& response = free_block();
    const Vector2d signals(1.06, 0.98);
    const TipPose pose = response.at(signals);
    ASSERT_EQ(pose.by_signal_m.size(), 2u);
    for (std::size_t s = 0; s < 2; ++s) {
        const Vector2d step = 1e-4 * Vector2d::Unit(static_cast<Eigen::Index>(s));
        const Matrix3Xd difference = (response.at(signals + step, pose.x).displacement_m -
                                      response.at(signals - step, pose.x).displacement_m) /
                                     2e-4;
        EXPECT_GT(difference.norm(), 1e-3);
        EXPECT_LT((difference - pose.by_signal_m[s]).norm(), 1e-3 * difference.norm());
        EXPECT_NE(difference, pose.by_signal_m[s]);
    }
}

/// The second muscle takes half the opposite change of the signal.
TEST(BlockRobot, TiedMusclesAreTwoThatMoveTogether) {
    const TipResponse tied(*body_of(block()), tied_muscles());
    const TipPose pose = tied.at(Eigen::VectorXd::Constant(1, 1.08)), same = free_block().at(Vector2d(1.08, 0.96));
    ASSERT_TRUE(pose.ok && same.ok);
    EXPECT_LT((pose.displacement_m - same.displacement_m).norm(), 1e-6 * same.displacement_m.norm());
    ASSERT_EQ(pose.by_signal_m.size(), 1u);
    const Matrix3Xd chained = same.by_signal_m[0] - 0.5 * same.by_signal_m[1];
    EXPECT_LT((pose.by_signal_m[0] - chained).norm(), 1e-5 * chained.norm());
}

TEST(BlockRobot, SignalsOfAPoseAreFoundFromWhatIsCompared) {
    const TipResponse& response = free_block();
    const Vector2d signals(1.08, 0.96);
    Matrix3Xd goal = response.at(signals).displacement_m;
    // x and z of the tracked point are enough for two signals.
    goal.row(1).setConstant(std::nan(""));
    goal.rightCols(3).setConstant(std::nan(""));
    const Result<PoseFit> fit = fit_pose(response, goal, unmoved(response), {});
    ASSERT_TRUE(fit) << fit.error().text();
    EXPECT_LT((fit->signals - signals).norm(), 1e-4);
    EXPECT_GT(fit->simulations, 1);
    EXPECT_LE(fit->simulations, 30);
    EXPECT_NEAR(fit->pose.tracked_m()(0), goal(0, 0), 1e-6);
    const PoseFit start = unmoved(response);
    EXPECT_EQ(start.signals, Eigen::VectorXd::Ones(2));
    EXPECT_EQ(start.simulations, 0);
    std::atomic<bool> cancel{true};
    const Result<PoseFit> stopped = fit_pose(response, goal, start, Progress({}, &cancel));
    ASSERT_FALSE(stopped);
    EXPECT_EQ(stopped.error().text(), "stopped");
}

Vector2d signals_at(double bar) { return {1.0 + 0.3 * bar, 1.0 - 0.1 * bar}; }

/// Recordings of the block at rest under these pressures, turned about its axis.
std::vector<RobotTrial> block_trials(double angle) {
    std::vector<RobotTrial> trials;
    for (const double mbar : {100.0, 200.0, 300.0}) {
        const Matrix3Xd pose = Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix() *
                               free_block().at(signals_at(1e-3 * mbar)).displacement_m;
        RobotTrial trial;
        trial.name = "made";
        trial.pressure_mbar = mbar;
        trial.time_s = Eigen::VectorXd::LinSpaced(101, 0.0, 1.0);
        trial.tip_m = pose.col(0).replicate(1, 101);
        for (Eigen::Index i = 1; i < pose.cols(); ++i) trial.marker_m.push_back(pose.col(i).replicate(1, 101));
        trials.push_back(trial);
    }
    return trials;
}

/// The bending plane of the recordings is that of the predictions, and a linear map is found from two trials.
TEST(BlockRobot, PredictsTheTrialThatTheMapDoesNotKnow) {
    const std::shared_ptr<const TipResponse> response(&free_block(), [](const TipResponse*) {});
    const ArmVariant variant{"ours", {}, free_muscles(), false};
    const std::vector<RobotTrial> trials = block_trials(0.4);
    const Result<FittedArm> arm = fit_arm(response, variant, trials, Instant::end, {});
    ASSERT_TRUE(arm) << arm.error().text();
    ASSERT_EQ(arm->fits.size(), 3u);
    int simulations = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_LT((arm->fits[i].signals - signals_at(0.1 * static_cast<double>(i + 1))).norm(), 1e-3) << i;
        EXPECT_LT(arm->marker_rms_m[i], 2e-5);
        simulations += arm->fits[i].simulations;
    }
    EXPECT_EQ(arm->simulations(), simulations);
    const ArmPrediction middle = predict_arm(*arm, {0, 2}, 200.0);
    EXPECT_LT((middle.signals - signals_at(0.2)).norm(), 1e-3);
    EXPECT_LT(relative_error(middle.tip_m, trials[1].tip_m.col(0)), 0.01);
    std::vector<RobotTrial> unseen = block_trials(0.0);
    unseen[1].tip_m.setConstant(std::numeric_limits<double>::quiet_NaN());
    const Result<FittedArm> refused = fit_arm(response, variant, unseen, Instant::after_0_7_s, {});
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().text(), "made: the tip was not recorded at 0.7 s after the onset");
}

}  // namespace
}  // namespace myo::reproduce::block_robot_test
