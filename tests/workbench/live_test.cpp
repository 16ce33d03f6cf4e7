#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "backend/workbench_backend.hpp"
#include "ui/driver.hpp"

// Playing live on the core: the bundled bodies under a hand and under their actuators.

namespace myo {
namespace {

using test::Driver;
using ui::commands::LiveControls;
using ui::commands::LiveFrame;
using ui::commands::LiveModel;

/// A bundled example, meshed as it opens, with the model that plays its first trial.
struct LiveExample {
    Driver driver{backend::make_core_backend(), 1280, 800};
    std::shared_ptr<ui::commands::Backend> core = backend::make_core_backend();
    std::unique_ptr<LiveModel> model;

    explicit LiveExample(const std::string& name) {
        driver.window->open(std::string(MYOLOOP_SOURCE_DIR) + "/assets/examples/" + name);
        EXPECT_TRUE(driver.wait_for_job(60));
        model = made(nullptr);
    }
    std::unique_ptr<LiveModel> made(const LiveModel* before) {
        auto result = core->live(*driver.state().scene, *driver.state().body, driver.state().settings, 0, before, {});
        EXPECT_TRUE(result) << (result ? "" : result.error().text());
        return result ? std::move(*result) : nullptr;
    }
    LiveControls controls(double h_s) const {
        LiveControls result;
        result.time_step_s = h_s;
        result.damping_s = driver.state().settings.damping_s;
        result.spring_N_m = model->spring_N_m();
        for (const ui::commands::LiveActuator& actuator : model->actuators()) result.levels.push_back(actuator.level);
        return result;
    }
    /// The last of a number of steps.
    LiveFrame after(const LiveControls& told, int steps) const {
        LiveFrame frame;
        for (int k = 0; k < steps; ++k) {
            Result<LiveFrame> stepped = model->step(told, {});
            EXPECT_TRUE(stepped) << (stepped ? "" : stepped.error().text());
            if (!stepped) break;
            frame = std::move(*stepped);
        }
        return frame;
    }
};

/// A hand on one node.
ui::commands::LiveGrip grip_of(Eigen::Index node, const Eigen::Vector3d& place) {
    ui::commands::LiveGrip grip;
    grip.nodes = {static_cast<int>(node)};
    grip.shares = Eigen::VectorXd::Ones(1);
    grip.offsets_m = Eigen::Matrix3Xd::Zero(3, 1);
    grip.place_m = place;
    return grip;
}

TEST(LiveCore, AnUntouchedModelMovesAsTheRecordedRun) {
    LiveExample beam("silicone_beam");
    beam.driver.workbench->execute(ui::commands::Run{});
    ASSERT_TRUE(beam.driver.wait_for_job(120));
    const ui::commands::SimulatedTrial& run = beam.driver.state().run->trials[0];
    const double h = run.frame_time_s[1] - run.frame_time_s[0];
    beam.model = beam.made(nullptr);
    const LiveFrame frame = beam.after(beam.controls(h), 20);
    const Eigen::Matrix3Xd& live = frame.run->trials[0].frames.front();
    const auto same = std::min_element(run.frame_time_s.begin(), run.frame_time_s.end(), [&](double a, double b) {
        return std::abs(a - frame.time_s) < std::abs(b - frame.time_s);
    });
    const auto k = static_cast<std::size_t>(same - run.frame_time_s.begin());
    ASSERT_NEAR(*same, frame.time_s, 1e-9);
    const double moved = (run.frames[k] - beam.driver.state().body->mesh.nodes).cwiseAbs().maxCoeff();
    EXPECT_LT((live - run.frames[k]).cwiseAbs().maxCoeff(), 0.01 * moved);
    ASSERT_EQ(frame.markers_m.size(), beam.driver.state().scene->markers.size());
}

TEST(LiveCore, AHandPullsTheEndTowardsItAndAnotherModulusGoesOnFromThere) {
    LiveExample beam("silicone_beam");
    const ui::commands::MeshedBody& body = *beam.driver.state().body;
    Eigen::Index tip = 0;
    body.mesh.nodes.row(0).maxCoeff(&tip);
    LiveControls told = beam.controls(0.01);
    const Eigen::Vector3d hand = body.mesh.nodes.col(tip) + Eigen::Vector3d(0.0, 0.04, 0.0);
    told.grip = grip_of(tip, hand);
    const LiveFrame frame = beam.after(told, 200);
    EXPECT_GT(frame.pulled_m.y() - body.mesh.nodes(1, tip), 0.005);
    EXPECT_NEAR(frame.force_N, told.spring_N_m * (hand - frame.pulled_m).norm(), 1e-9 + 1e-6 * frame.force_N);
    ui::commands::Settings stiffer = beam.driver.state().settings;
    stiffer.youngs_modulus_Pa *= 2.0;
    beam.driver.workbench->execute(ui::commands::ChangeSettings{stiffer, "modulus"});
    beam.model = beam.made(beam.model.get());
    LiveControls shortly = told;
    shortly.time_step_s = 0.001;
    const LiveFrame next = beam.after(shortly, 1);
    EXPECT_LT((next.pulled_m - frame.pulled_m).norm(), 0.2 * (frame.pulled_m - body.mesh.nodes.col(tip)).norm())
        << "it begins where the softer one was";
    EXPECT_LT(beam.after(told, 200).pulled_m.y(), frame.pulled_m.y() - 0.001);
}

TEST(LiveCore, PressureOfTheSliderBendsTheFinger) {
    LiveExample finger("pneumatic_finger");
    ASSERT_EQ(finger.model->actuators().size(), 1u);
    const ui::commands::LiveActuator chamber = finger.model->actuators().front();
    EXPECT_EQ(chamber.unit, "kPa");
    EXPECT_GT(chamber.highest, 20e3);
    LiveControls told = finger.controls(0.01);
    told.levels = {0.0};
    const LiveFrame flat = finger.after(told, 150);
    told.levels = {25e3};
    const LiveFrame bent = finger.after(told, 150);
    const double
        moved = (bent.run->trials[0].frames.front() - flat.run->trials[0].frames.front()).colwise().norm().maxCoeff();
    EXPECT_GT(moved, 0.002);
}

TEST(LiveCore, AMeshWithoutAnExperimentPlaysToo) {
    Driver driver(backend::make_core_backend(), 1280, 800);
    const std::string file = std::string(MYOLOOP_SOURCE_DIR) + "/assets/examples/fish_tail/tail.stl";
    driver.workbench->execute(ui::commands::Open{file, 1e-3});
    ASSERT_TRUE(driver.wait_for_job(60));
    driver.workbench->execute(ui::commands::BuildMesh{});
    ASSERT_TRUE(driver.wait_for_job(60));
    driver.workbench->execute(ui::commands::PlayLive{});
    for (int k = 0; k < 500 && !(driver.state().live && driver.state().live->ready); ++k) {
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        driver.frame(0.01);
    }
    ASSERT_TRUE(driver.state().live && driver.state().live->ready);
    EXPECT_TRUE(driver.state().live->problem.empty()) << driver.state().live->problem;
    EXPECT_GT(driver.state().live->frame->time_s, 0.0);
}

}  // namespace
}  // namespace myo
