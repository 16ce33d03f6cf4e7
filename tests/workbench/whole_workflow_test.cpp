#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>

#include "backend/workbench_backend.hpp"
#include "base/files.hpp"
#include "support/folder.hpp"
#include "ui/driver.hpp"
#include "workbench/beam_take.hpp"
#include "workbench/by_hand.hpp"

namespace myo {
namespace {

using test::Driver;

class Person : public ::testing::Test {
protected:
    Driver driver{backend::make_core_backend(), 1400, 1100};

    const ui::commands::WorkbenchState& state() const { return driver.state(); }
    ui::commands::TaskState task(ui::commands::Task which) const {
        return ui::commands::task_status(state(), which).state;
    }

    void wait(int seconds) {
        ASSERT_TRUE(driver.wait_for_job(seconds));
        ASSERT_FALSE(state().log.empty()) << "nothing was opened";
        ASSERT_NE(state().log.back().level, ui::commands::LogLevel::failure) << state().log.back().text;
    }
    void type_into(const std::string& item, const std::string& text, bool enter = true) {
        test::type_into(driver, item, text, enter);
    }
    /// In the dialog that is open: goes to a folder by typing where it is.
    void browse_to(const std::filesystem::path& folder) { type_into("browser/path", folder.string()); }
    void choose(const std::filesystem::path& path) { test::choose_file(driver, path); }
    void from_menu(const std::string& menu, const std::string& item) {
        driver.click("menu/" + menu);
        driver.click("menu/" + item);
    }
    void stroke(double y) {
        driver.drag(test::pixel_of(driver, {0.03, y, 0.02}), test::pixel_of(driver, {0.095, y, 0.02}));
    }
    /// Of the 3D view with the mouse elsewhere.
    ui::platform::Image view() {
        driver.click_at({driver.item("panel/markers").center()});
        for (int i = 0; i < 3; ++i) driver.frame();
        return driver.picture();
    }
    /// Share of the view's pixels in which two pictures differ.
    double differing(const ui::platform::Image& a, const ui::platform::Image& b) {
        return test::differing_share(a, b, driver.window->viewport().pixels);
    }
    double painted_cm3() const {
        return 1e6 * fibre::amount_of(*state().chosen_paint(), state().ground->volumes_m3).volume_m3;
    }
};

/// The bundled beam, whose file says that gravity pulls 3 degrees sideways: as one has it whose mount was not level.
std::filesystem::path tilted_beam_in(const test::Folder& folder) {
    const std::filesystem::path beam = test::beam_in(folder);
    std::string text = *read_file(beam / "experiment.toml");
    const std::string level = "[0.0, 0.0, -9.81]";
    folder.write("beam/experiment.toml", text.replace(text.find(level), level.size(), "[0.0, 0.5134, -9.7966]"));
    return beam;
}

/// From an empty window to a saved project, as a person would go, by what is written on the widgets.
TEST_F(Person, GoesTheWholeWay) {
    const test::Folder folder("whole_workflow");
    // Open an example.
    ASSERT_EQ(task(ui::commands::Task::mesh), ui::commands::TaskState::missing);
    const std::filesystem::path beam = tilted_beam_in(folder);
    driver.click("start/open");
    choose(beam);
    ASSERT_NO_FATAL_FAILURE(wait(60));
    ASSERT_TRUE(state().body);
    EXPECT_EQ(task(ui::commands::Task::mesh), ui::commands::TaskState::done);
    const Eigen::Index cells = state().body->mesh.cell_count();

    // Remesh, coarser.
    driver.click("task/mesh");
    const ui::platform::Rectangle slider = driver.item("body/resolution");
    driver.click_at({slider.lowest.x + 0.63f * slider.width(), slider.center().y});
    EXPECT_EQ(task(ui::commands::Task::mesh), ui::commands::TaskState::stale);
    driver.click("body/build");
    ASSERT_NO_FATAL_FAILURE(wait(60));
    EXPECT_EQ(task(ui::commands::Task::mesh), ui::commands::TaskState::done);
    EXPECT_LT(state().body->mesh.cell_count(), cells);

    // Paint three strokes, take one back and do it again.
    driver.click("task/fibres");
    driver.click("fibres/add");
    EXPECT_EQ(task(ui::commands::Task::fibres), ui::commands::TaskState::ready);
    driver.click("fibres/tool/paint");
    std::vector<double> volumes;
    std::vector<ui::platform::Image> pictures{view()};
    for (const double y : {0.004, 0.015, 0.026}) {
        stroke(y);
        volumes.push_back(painted_cm3());
        pictures.push_back(view());
        EXPECT_GT(differing(pictures[pictures.size() - 2], pictures.back()), 0.002) << "the stroke is seen";
    }
    EXPECT_TRUE(std::is_sorted(volumes.begin(), volumes.end()));
    EXPECT_GT(volumes.back(), volumes.front());
    EXPECT_EQ(task(ui::commands::Task::fibres), ui::commands::TaskState::done);
    driver.key(ImGuiKey_Z, {.ctrl = true});
    EXPECT_NEAR(painted_cm3(), volumes[1], 1e-9);
    EXPECT_LT(differing(view(), pictures[2]), 2e-4);
    driver.key(ImGuiKey_Y, {.ctrl = true});
    EXPECT_NEAR(painted_cm3(), volumes[2], 1e-9);
    EXPECT_LT(differing(view(), pictures[3]), 2e-4);
    driver.click("fibres/tool/view");

    // Run and scrub: the body has left its rest shape, and the error is told.
    driver.key(ui::platform::key_r, {.ctrl = true});
    ASSERT_NO_FATAL_FAILURE(wait(120));
    ASSERT_TRUE(state().run_is_current());
    EXPECT_EQ(task(ui::commands::Task::run), ui::commands::TaskState::done);
    const ui::platform::Rectangle track = driver.item("timeline/track");
    driver.click_at({track.lowest.x + 0.5f * track.width(), track.center().y});
    EXPECT_GT((driver.window->scene().positions - state().body->mesh.nodes).colwise().norm().maxCoeff(), 1e-3);
    driver.click("task/measure");
    EXPECT_TRUE(driver.has("measure/marker/tip_left"));

    // Another recording of the same motion, by cameras that stood elsewhere, is to be predicted.
    const std::filesystem::path take = test::take_of(folder, beam / "gravity_release.csv");
    from_menu("file", "file.import");
    choose(take);
    ASSERT_NO_FATAL_FAILURE(wait(30));
    ASSERT_TRUE(state().import);
    EXPECT_LT(state().import->view.rms_m, 5e-4);
    driver.click("import/first_motion");
    driver.click("import/role/second");
    driver.click("import/add");
    ASSERT_NO_FATAL_FAILURE(wait(60));
    ASSERT_FALSE(state().import);
    EXPECT_EQ(state().scene->trials.back().name, "take_7");
    EXPECT_EQ(state().scene->trials.back().role, "validate");
    EXPECT_NEAR(painted_cm3(), volumes[2], 1e-9) << "the muscle is still there";

    // Calibrate and change one's mind.
    driver.click("task/fit");
    const ui::commands::Settings before = state().settings;
    driver.click("fit/calibrate");
    ASSERT_TRUE(state().busy());
    driver.click("run/cancel");
    ASSERT_TRUE(driver.wait_for_job(30));
    EXPECT_TRUE(!state().found || state().found->stopped);
    EXPECT_TRUE(state().found || state().settings == before);

    // Look for the muscle's signal instead, as far as six evaluations go. The best plays while the search works.
    type_into("fit/evaluations", "6");
    type_into("fit/frequency", "5");
    EXPECT_EQ(state().optimize.max_evaluations, 6);
    driver.click("fit/optimize");
    bool played = false;
    while (state().busy()) {
        driver.frame_beside_job();
        played = played || (state().searching() && state().search && state().search->best &&
                            !state().simulated_trial()->frames.empty());
    }
    driver.settle();
    ASSERT_TRUE(state().found) << state().log.back().text;
    EXPECT_TRUE(played);
    EXPECT_EQ(state().found->title, "Optimised");
    EXPECT_LE(state().found->rms_after_m, state().found->rms_before_m);
    EXPECT_GE(state().search->log.size(), 3u);
    EXPECT_GT(state().settings.muscles[0].signal->times_s.size(), 3u);

    // Without the muscle, ask what the model lacks, and add it.
    driver.click("task/fibres");
    driver.click("fibres/remove");
    ASSERT_TRUE(state().settings.muscles.empty());
    driver.click("task/diagnose");
    driver.click("diagnose/diagnose");
    ASSERT_TRUE(state().diagnosing());
    ASSERT_NO_FATAL_FAILURE(wait(300));
    ASSERT_TRUE(state().diagnosis && state().diagnosis->complete) << state().log.back().text;
    EXPECT_EQ(state().diagnosis->verdict, ui::commands::DiagnosisVerdict::effects);
    ASSERT_TRUE(state().diagnosis->row("gravity_tilt")) << state().diagnosis->headline;
    driver.click("diagnose/row/gravity_tilt");
    driver.click("diagnose/add");
    ASSERT_EQ(state().settings.effects.size(), 1u);
    const auto& parameters = state().settings.effects.front().declaration.parameters;
    // About the beam's own axis; about the others, half a degree more or less is not seen.
    EXPECT_NEAR(std::get<double>(parameters.at("tilt_deg")) * std::get<Eigen::VectorXd>(parameters.at("axis"))[0], -3.0,
                0.5);
    driver.click("task/fit");
    EXPECT_TRUE(driver.has("effect/added/0"));

    // Save and open again, in another window.
    driver.key(ui::platform::key_r, {.ctrl = true});
    ASSERT_NO_FATAL_FAILURE(wait(120));
    driver.click("view/options");
    driver.click("view/effect_force");  // of the diagnosis, which a project does not keep
    driver.key(ImGuiKey_Escape);
    EXPECT_FALSE(driver.has("view/effect_force"));
    const auto in_the_swing = [&] {
        driver.click("timeline/trial");
        driver.click("timeline/trial/" + state().scene->trials[0].name);
        const ui::platform::Rectangle line = driver.item("timeline/track");
        driver.click_at({line.lowest.x + 0.3f * line.width(), line.center().y});
        return view();
    };
    const ui::platform::Image before_saving = in_the_swing();
    from_menu("file", "file.save_as");
    browse_to(folder.path());
    type_into("browser/name", "model.myoloop", false);
    driver.click("browser/open");
    ASSERT_TRUE(std::filesystem::exists(folder.path() / "model.myoloop")) << state().log.back().text;
    EXPECT_FALSE(state().unsaved());
    EXPECT_GE(state().history.size(), 3u);
    driver.key(ui::platform::key_o, {.ctrl = true});
    choose(folder.path() / "model.myoloop");
    ASSERT_NO_FATAL_FAILURE(wait(60));
    EXPECT_EQ(state().project, folder.path() / "model.myoloop");
    ASSERT_EQ(state().settings.effects.size(), 1u);
    EXPECT_NEAR(state().settings.youngs_modulus_Pa, state().saved_settings.youngs_modulus_Pa, 0.0);
    EXPECT_EQ(task(ui::commands::Task::mesh), ui::commands::TaskState::done);
    EXPECT_EQ(task(ui::commands::Task::run), ui::commands::TaskState::ready);
    driver.key(ui::platform::key_r, {.ctrl = true});
    ASSERT_NO_FATAL_FAILURE(wait(120));
    EXPECT_LT(differing(in_the_swing(), before_saving), 1e-3) << "the same model moves in the same way";
}

/// The README's way from an example to a painted, optimised and compared muscle, click by click: the muscles of a
/// filmed tail are not known; two are painted, and a signal is found with which the tail follows what was filmed.
Eigen::Vector3d middle_of(const mesh::VolumeMesh& mesh, Eigen::Index cell) {
    return mesh.nodes(Eigen::all, mesh.cells.col(cell)).rowwise().mean();
}

TEST_F(Person, PaintsTheMusclesOfAFishTailAndFindsTheirSignal) {
    from_menu("file", "examples");
    driver.click("menu/example/fish_tail");
    ASSERT_NO_FATAL_FAILURE(wait(60));
    driver.click("task/mesh");
    driver.click("body/element");
    driver.click("body/element/hex8");
    type_into("body/edge_length", "3.6");
    EXPECT_NEAR(state().settings.resolution_m, 3.6e-3, 1e-12);
    driver.click("body/build");
    ASSERT_NO_FATAL_FAILURE(wait(60));
    EXPECT_NEAR(state().body->mesh.nodes.row(0).maxCoeff(), 0.12, 1e-3) << "the fin is there";

    driver.click("task/fibres");
    driver.click("fibres/add");
    driver.click("fibres/tool/paint");
    type_into("fibres/radius", "30");
    driver.click("view/y");
    const auto paint_side = [&](double side) {
        driver.drag(test::pixel_of(driver, {0.02, side * 0.0077, 0.0}),
                    test::pixel_of(driver, {0.066, side * 0.0049, 0.0}));
    };
    paint_side(-1.0);
    EXPECT_GT(painted_cm3(), 3.0);
    // No muscle of one side comes out on the other.
    const auto& weights = state().paint.front()->weights;
    for (Eigen::Index c = 0; c < weights.size(); ++c)
        if (weights(c) > 0.0) {
            EXPECT_LT(middle_of(state().body->mesh, c).y(), 2e-3);
        }
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
    RecordProperty("rms_at_rest_um", static_cast<int>(1e6 * state().run->rms_m));
    driver.click("task/fit");
    type_into("fit/evaluations", "12");
    driver.click("fit/optimize");
    const auto start = std::chrono::steady_clock::now();
    ASSERT_NO_FATAL_FAILURE(wait(300));
    RecordProperty(
        "search_ms",
        static_cast<int>(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count()));
    ASSERT_TRUE(state().found) << state().log.back().text;
    RecordProperty("rms_before_um", static_cast<int>(1e6 * state().found->rms_before_m));
    RecordProperty("rms_after_um", static_cast<int>(1e6 * state().found->rms_after_m));
    EXPECT_LT(state().found->rms_after_m, 0.25 * state().found->rms_before_m);
    EXPECT_TRUE(state().run_is_current());
    driver.click("task/measure");
    EXPECT_TRUE(driver.has("measure/marker/fin_top"));
}

}  // namespace
}  // namespace myo
