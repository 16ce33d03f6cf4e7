#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "backend/workbench_backend.hpp"
#include "base/files.hpp"
#include "support/folder.hpp"
#include "ui/driver.hpp"
#include "workbench/example_copy.hpp"

namespace myo::test {

/// A copy of the bundled beam, coarsely meshed, in a window.
struct OpenedBeam {
    Folder folder;
    Driver driver;
    std::filesystem::path copy;

    explicit OpenedBeam(const std::string& name)
        : folder(name), driver(backend::make_core_backend(), 1280, 1400), copy(example_copy(folder, "silicone_beam")) {
        driver.window->open(copy);
        EXPECT_TRUE(driver.wait_for_job(60));
        ui::commands::Settings coarse = driver.state().settings;
        coarse.resolution_m = 0.01;
        driver.workbench->execute(ui::commands::ChangeSettings{coarse, "resolution"});
        driver.workbench->execute(ui::commands::BuildMesh{});
        EXPECT_TRUE(driver.wait_for_job(60));
    }
    std::string text() const { return *read_file(copy / "experiment.toml"); }
    void run() {
        driver.workbench->execute(ui::commands::Run{});
        ASSERT_TRUE(driver.wait_for_job(120));
        ASSERT_TRUE(driver.state().run) << driver.state().log.back().text;
        ASSERT_TRUE(driver.state().run->problem.empty()) << driver.state().run->problem;
    }
    /// Keeps the time step of the settings, so that runs differ by what is edited only.
    void keep_step() {
        ui::commands::Settings settings = driver.state().settings;
        settings.own_step = true;
        driver.workbench->execute(ui::commands::ChangeSettings{settings, "step"});
    }
    /// Height of the first marker at the end of the shown trial [m].
    double last_height_m() const {
        const Eigen::Matrix3Xd& tip = driver.state().simulated_trial()->markers.front();
        return tip(2, tip.cols() - 1);
    }
};

}  // namespace myo::test
