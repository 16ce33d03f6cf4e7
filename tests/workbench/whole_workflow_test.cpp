#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "backend/workbench_backend.hpp"
#include "support/folder.hpp"
#include "ui/driver.hpp"

namespace myo {
namespace {

using test::Driver;

class Person : public ::testing::Test {
protected:
    Driver driver{make_core_backend(), 1400, 900};

    const WorkbenchState& state() const { return driver.state(); }
    StepState step(Step which) const { return step_status(state(), which).state; }

    void wait(int seconds) {
        ASSERT_TRUE(driver.wait_for_job(seconds));
        ASSERT_NE(state().log.back().level, LogLevel::failure) << state().log.back().text;
    }
    void type_into(const std::string& item, const std::string& text) {
        driver.double_click(item);
        driver.key(ImGuiKey_A, {.ctrl = true});
        driver.type(text);
        driver.key(ImGuiKey_Enter);
    }
    void stroke(double y) {
        driver.drag(test::pixel_of(driver, {0.03, y, 0.02}), test::pixel_of(driver, {0.095, y, 0.02}));
    }
    double painted_cm3() const { return 1e6 * amount_of(*state().chosen_paint(), state().ground->volumes_m3).volume_m3; }
};

/// From an empty window to a saved project, as a person would go, by what is written on the widgets.
TEST_F(Person, GoesTheWholeWay) {
    const test::Folder folder("whole_workflow");
    // Open an example.
    ASSERT_EQ(step(Step::mesh), StepState::missing);
    driver.workbench->execute(command::Open{std::string(MYOLOOP_SOURCE_DIR) + "/assets/examples/silicone_beam", std::nullopt});
    ASSERT_NO_FATAL_FAILURE(wait(60));
    ASSERT_TRUE(state().body);
    EXPECT_EQ(step(Step::mesh), StepState::done);
    const Eigen::Index cells = state().body->mesh.cell_count();

    // Remesh, coarser.
    driver.click("step/mesh");
    const Rectangle slider = driver.item("body/resolution");
    driver.click_at({slider.lowest.x + 0.55f * slider.width(), slider.center().y});
    EXPECT_EQ(step(Step::mesh), StepState::stale);
    driver.click("body/build");
    ASSERT_NO_FATAL_FAILURE(wait(60));
    EXPECT_EQ(step(Step::mesh), StepState::done);
    EXPECT_LT(state().body->mesh.cell_count(), cells);

    // Paint three strokes, take one back and do it again.
    driver.click("step/fibres");
    driver.click("fibres/add");
    EXPECT_EQ(step(Step::fibres), StepState::ready);
    driver.click("fibres/tool/paint");
    std::vector<double> volumes;
    for (const double y : {0.004, 0.015, 0.026}) {
        stroke(y);
        volumes.push_back(painted_cm3());
    }
    EXPECT_TRUE(std::is_sorted(volumes.begin(), volumes.end()));
    EXPECT_GT(volumes.back(), volumes.front());
    EXPECT_EQ(step(Step::fibres), StepState::done);
    driver.key(ImGuiKey_Z, {.ctrl = true});
    EXPECT_NEAR(painted_cm3(), volumes[1], 1e-9);
    driver.key(ImGuiKey_Y, {.ctrl = true});
    EXPECT_NEAR(painted_cm3(), volumes[2], 1e-9);
    driver.click("fibres/tool/view");

    // Run and scrub: the body has left its rest shape, and the error is told.
    driver.key(key_r, {.ctrl = true});
    ASSERT_NO_FATAL_FAILURE(wait(120));
    ASSERT_TRUE(state().run_is_current());
    EXPECT_EQ(step(Step::run), StepState::done);
    const Rectangle track = driver.item("timeline/track");
    driver.click_at({track.lowest.x + 0.5f * track.width(), track.center().y});
    EXPECT_GT((driver.window->scene().positions - state().body->mesh.nodes).colwise().norm().maxCoeff(), 1e-3);
    driver.click("step/measure");
    EXPECT_TRUE(driver.has("measure/marker/tip_left"));

    // Calibrate and change one's mind.
    driver.click("step/fit");
    const Settings before = state().settings;
    driver.click("fit/calibrate");
    ASSERT_TRUE(state().busy());
    driver.click("run/cancel");
    ASSERT_TRUE(driver.wait_for_job(30));
    EXPECT_TRUE(!state().found || state().found->stopped);
    EXPECT_TRUE(state().found || state().settings == before);

    // Look for the muscle's signal instead, as far as ten evaluations go. The best plays while the search works.
    OptimizeRequest request = state().optimize;
    request.max_evaluations = 6;
    request.frequency_Hz = 5.0;
    driver.workbench->execute(command::ChangeOptimize{request});
    driver.settle();
    driver.click("fit/optimize");
    bool played = false;
    while (state().busy()) {
        driver.frame();
        played = played || (state().searching() && state().search && state().search->best && !state().simulated_trial()->frames.empty());
    }
    driver.settle();
    ASSERT_TRUE(state().found) << state().log.back().text;
    EXPECT_TRUE(played);
    EXPECT_EQ(state().found->title, "Optimised");
    EXPECT_LE(state().found->rms_after_m, state().found->rms_before_m);
    EXPECT_GE(state().search->log.size(), 3u);
    EXPECT_GT(state().settings.muscles[0].signal->times_s.size(), 3u);

    // Without the muscle, ask what the model lacks, and add it.
    driver.click("step/fibres");
    driver.click("fibres/remove");
    ASSERT_TRUE(state().settings.muscles.empty());
    driver.click("step/diagnose");
    driver.click("diagnose/diagnose");
    ASSERT_TRUE(state().diagnosing());
    ASSERT_NO_FATAL_FAILURE(wait(300));
    ASSERT_TRUE(state().diagnosis && state().diagnosis->complete) << state().log.back().text;
    const auto& rows = state().diagnosis->rows;
    const auto fitted = std::find_if(rows.begin(), rows.end(), [](const DiagnosisRow& row) { return row.fitted && row.kind == DiagnosisRow::Kind::effects; });
    ASSERT_NE(fitted, rows.end());
    driver.click("diagnose/row/" + fitted->key);
    driver.click("diagnose/add");
    ASSERT_FALSE(state().settings.effects.empty());
    driver.click("step/material");
    EXPECT_TRUE(driver.has("model/effect/" + state().settings.effects.front().id));

    // Save and open again, in another window.
    driver.workbench->execute(command::SaveAs{folder.path() / "beam"});
    driver.settle();
    ASSERT_TRUE(std::filesystem::exists(folder.path() / "beam.myoloop")) << state().log.back().text;
    EXPECT_FALSE(state().unsaved());
    EXPECT_GE(state().history.size(), 3u);
    driver.workbench->execute(command::Open{folder.path() / "beam.myoloop", std::nullopt});
    ASSERT_NO_FATAL_FAILURE(wait(60));
    EXPECT_EQ(state().project, folder.path() / "beam.myoloop");
    ASSERT_EQ(state().settings.effects.size(), 1u);
    EXPECT_NEAR(state().settings.youngs_modulus_Pa, state().saved_settings.youngs_modulus_Pa, 0.0);
    EXPECT_EQ(step(Step::mesh), StepState::done);
    EXPECT_EQ(step(Step::run), StepState::ready);
}

/// The README's way from an example to a painted, optimised and compared muscle, click by click: the muscles of a filmed tail are not
/// known; two are painted, and a signal is found with which the tail follows what was filmed.
TEST_F(Person, PaintsTheMusclesOfAFishTailAndFindsTheirSignal) {
    driver.workbench->execute(command::Open{std::string(MYOLOOP_SOURCE_DIR) + "/assets/examples/fish_tail", std::nullopt});
    ASSERT_NO_FATAL_FAILURE(wait(60));
    driver.click("step/mesh");
    driver.click("body/element");
    driver.click("body/element/hex8");
    Settings coarse = state().settings;
    coarse.resolution_m = 0.008;
    driver.workbench->execute(command::ChangeSettings{coarse, "resolution"});
    driver.click("body/build");
    ASSERT_NO_FATAL_FAILURE(wait(60));

    driver.click("step/fibres");
    driver.click("fibres/add");
    driver.click("fibres/tool/paint");
    type_into("fibres/radius", "30");
    driver.click("view/y");
    const auto paint_side = [&](double side) { driver.drag(test::pixel_of(driver, {0.02, side * 0.0077, 0.0}), test::pixel_of(driver, {0.066, side * 0.0049, 0.0})); };
    paint_side(-1.0);
    EXPECT_GT(painted_cm3(), 3.0);
    driver.click("fibres/add");
    driver.click("fibres/follows");
    driver.click("fibres/follows/" + state().settings.muscles[0].name);
    EXPECT_EQ(state().settings.muscles[1].ratio, -1.0);
    driver.click("view/y");
    paint_side(1.0);
    EXPECT_GT(painted_cm3(), 3.0);
    driver.click("fibres/tool/view");

    driver.click("run/run");
    ASSERT_NO_FATAL_FAILURE(wait(120));
    driver.click("step/fit");
    type_into("fit/evaluations", "12");
    driver.click("fit/optimize");
    ASSERT_NO_FATAL_FAILURE(wait(300));
    ASSERT_TRUE(state().found) << state().log.back().text;
    RecordProperty("rms_before_um", static_cast<int>(1e6 * state().found->rms_before_m));
    RecordProperty("rms_after_um", static_cast<int>(1e6 * state().found->rms_after_m));
    EXPECT_LT(state().found->rms_after_m, 0.25 * state().found->rms_before_m);
    EXPECT_TRUE(state().run_is_current());
    driver.click("step/measure");
    EXPECT_TRUE(driver.has("measure/marker/fin_top"));
}

}  // namespace
}  // namespace myo
