#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "backend/workbench_backend.hpp"
#include "support/figures.hpp"
#include "support/folder.hpp"
#include "support/shared_data.hpp"
#include "ui/driver.hpp"
#include "workbench/by_hand.hpp"

// A person with a body and a recording of their own: everything is set by widgets, no file is edited by hand.

namespace myo {
namespace {

namespace fs = std::filesystem;
using Eigen::Vector3d;
using test::Driver;

class OwnRobot : public testing::Test {
protected:
    Driver driver{backend::make_core_backend(), 1400, 1500};

    const ui::commands::WorkbenchState& state() const { return driver.state(); }
    void wait(int seconds) {
        ASSERT_TRUE(driver.wait_for_job(seconds));
        ASSERT_NE(state().log.back().level, ui::commands::LogLevel::failure) << state().log.back().text;
    }
    void type_into(const std::string& item, const std::string& text, bool enter = true) {
        test::type_into(driver, item, text, enter);
    }
    void choose(const std::filesystem::path& path) { test::choose_file(driver, path); }
    void pick(const std::string& list, const std::string& choice) {
        driver.click(list);
        driver.click(list + "/" + choice);
        driver.settle();
    }
    void panel(const std::string& name) {
        driver.window->show_panel(name);
        driver.settle();
    }
    /// Opens a mesh in millimetres and makes an experiment of it.
    void open_body(const fs::path& stl, const test::Folder& folder) {
        driver.click("start/open");
        choose(stl);
        driver.click("unit/mm");
        ASSERT_NO_FATAL_FAILURE(wait(60));
        panel("support");
        driver.click("support/make");
        type_into("browser/path", folder.path().string());
        type_into("browser/name", "robot", false);
        driver.click("browser/open");
        ASSERT_NO_FATAL_FAILURE(wait(120));
        ASSERT_TRUE(state().scene->is_experiment) << state().log.back().text;
    }
    void mesh(const std::string& edge_mm) {
        driver.click("task/mesh");
        pick("body/element", "hex8");
        type_into("body/edge_length", edge_mm);
        driver.click("body/build");
        ASSERT_NO_FATAL_FAILURE(wait(120));
        ASSERT_TRUE(state().body) << state().log.back().text;
    }
    /// A marker by a click on the surface, then at its measured place beside it.
    void add_marker(const std::string& name, const Vector3d& on_surface, const Vector3d& place_mm) {
        driver.click("probe/place");
        type_into("probe/next", name, false);
        driver.click_at(test::pixel_of(driver, on_surface));
        driver.settle();
        driver.click("probe/place");
        ASSERT_EQ(state().scene->markers.back().name, name) << state().refused;
        for (const int k : {0, 1, 2})
            type_into("probe/place/" + name + "/" + std::string(1, "xyz"[k]), std::to_string(place_mm(k)) + " mm");
        EXPECT_LT((state().scene->markers.back().rest_m - 1e-3 * place_mm).norm(), 1e-6) << state().refused;
    }
};

/// The silicone beam: its STL, held at one end, gravity along an axis, three markers on stalks, its recording, two
/// unknown values, and a calibrated model.
TEST_F(OwnRobot, ABeamFromItsMeshAndRecordingToACalibratedModel) {
    const fs::path stl = test::shared_data("data/geometry/beam.stl"),
                   take = test::shared_data("data/mocap/beam/beam_gravity_V2_a.c3d");
    if (stl.empty() || take.empty()) GTEST_SKIP() << "skipped: no data";
    const test::Folder folder("own_robot");
    ASSERT_NO_FATAL_FAILURE(open_body(stl, folder));
    // The frame of the file: the tip at z = 0, up along x.
    panel("support");
    pick("support/end", "z_high");
    pick("support/gravity", "x_low");
    EXPECT_NEAR(state().scene->gravity_m_s2.x(), -9.81, 1e-9);
    EXPECT_GT(state().scene->clamp_m->highest.z(), 0.1);
    ASSERT_NO_FATAL_FAILURE(mesh("10"));

    panel("probe");
    type_into("probe/standoff", "12 mm");
    ASSERT_NO_FATAL_FAILURE(add_marker("tip_top", {0.015, 0.015, 0.0}, {36.0, 15.0, 0.0}));
    ASSERT_NO_FATAL_FAILURE(add_marker("tip_left", {0.024, 0.004, 0.0}, {24.0, -6.0, 0.0}));
    ASSERT_NO_FATAL_FAILURE(add_marker("tip_right", {0.006, 0.026, 0.0}, {6.0, 36.0, 0.0}));

    driver.click("menu/file");
    driver.click("menu/file.import");
    choose(take);
    ASSERT_NO_FATAL_FAILURE(wait(60));
    ASSERT_TRUE(state().import);
    const char* const labels[] = {"Tip - 1", "Tip - 2", "Tip - 3", "Base - 1", "Base - 2", "Base - 3"};
    const char* const names[] = {"tip_top", "tip_left", "tip_right", "none", "none", "none"};
    for (int i = 0; i < 6; ++i) pick(std::string("import/marker/") + labels[i], names[i]);
    driver.click("import/first_motion");
    EXPECT_LT(state().import->view.rms_m, 2e-3) << state().import->view.placed_by;
    driver.click("import/add");
    ASSERT_NO_FATAL_FAILURE(wait(120));
    ASSERT_FALSE(state().import) << state().log.back().text;

    panel("unknown");
    for (const char* name : {"youngs_modulus", "damping"})
        if (std::count(state().scene->unknowns.begin(), state().scene->unknowns.end(), name) == 0)
            driver.click(std::string("unknown/") + name);
    driver.click("run/run");
    ASSERT_NO_FATAL_FAILURE(wait(200));
    const double before = state().run->rms_m;
    driver.click("task/fit");
    driver.click("fit/calibrate");
    ASSERT_NO_FATAL_FAILURE(wait(500));
    ASSERT_TRUE(state().found) << state().log.back().text;
    test::record("rms_m", std::vector<double>{before, state().found->rms_after_m});
    test::record("youngs_modulus_Pa", state().settings.youngs_modulus_Pa);
    // The published value is 263,824 Pa; markers placed by hand leave a millimetre.
    EXPECT_NEAR(state().settings.youngs_modulus_Pa, 2.64e5, 0.25 * 2.64e5);
    EXPECT_LT(state().found->rms_after_m, 3e-3);
    EXPECT_LE(state().found->rms_after_m, before);
    EXPECT_TRUE(fs::exists(folder.path() / "robot" / "experiment.toml")) << "the command line reads it, too";
}

}  // namespace
}  // namespace myo
