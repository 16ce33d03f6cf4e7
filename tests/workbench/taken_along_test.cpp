#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "backend/experiment_contents.hpp"
#include "backend/project_file.hpp"
#include "backend/workbench_backend.hpp"
#include "base/files.hpp"
#include "experiment/read_experiment.hpp"
#include "support/folder.hpp"
#include "ui/driver.hpp"
#include "workbench/beam_take.hpp"

// Projects with their files inside, copies of experiments, and what happens when something is not where it was.

namespace myo {
namespace {

namespace fs = std::filesystem;
using test::Driver;
using testing::HasSubstr;
using ui::commands::EditDeclaration;
using ui::commands::SetDeclared;

/// The bundled beam with one of its recordings beside its folder.
fs::path spread_beam(const test::Folder& folder) {
    const fs::path beam = test::beam_in(folder);
    fs::create_directories(folder.path() / "takes");
    fs::rename(beam / "tip_weight.csv", folder.path() / "takes" / "tip_weight.csv");
    std::string text = *read_file(beam / "experiment.toml");
    const std::string name = "\"tip_weight.csv\"";
    EXPECT_TRUE(write_file(beam / "experiment.toml",
                           text.replace(text.find(name), name.size(), "\"../takes/tip_weight.csv\"")));
    return beam;
}

void open_at(Driver& driver, const fs::path& path) {
    driver.workbench->execute(ui::commands::Open{path, std::nullopt});
    ASSERT_TRUE(driver.wait_for_job(60));
}

const EditDeclaration no_gravity{{SetDeclared{{"environment", "gravity_m_s2"}, "[0.0, 0.0, 0.0]"}}, "gravity"};

TEST(SelfContained, OpensFromAMovedFolderWithoutTheExperiment) {
    const test::Folder folder("self_contained");
    const fs::path beam = spread_beam(folder), home = folder.path() / "home", moved = folder.path() / "moved";
    fs::create_directories(home);
    ui::commands::Settings settings;
    {
        Driver driver(backend::make_core_backend(), 1280, 900);
        open_at(driver, beam);
        driver.workbench->execute(no_gravity);
        driver.workbench->execute(ui::commands::Run{});
        ASSERT_TRUE(driver.wait_for_job(120));
        driver.workbench->execute(ui::commands::SaveAs{home / "arm.myoloop", true});
        ASSERT_FALSE(driver.state().unsaved()) << driver.state().log.back().text;
        settings = driver.state().settings;
    }
    EXPECT_TRUE(fs::exists(home / "arm.files/experiment/outside/tip_weight.csv"));
    EXPECT_TRUE(fs::exists(home / "arm.files/results/gravity_release.csv"));
    fs::rename(home, moved);
    fs::remove_all(beam);
    fs::remove_all(folder.path() / "takes");
    Driver driver(backend::make_core_backend(), 1280, 900);
    open_at(driver, moved / "arm.myoloop");
    ASSERT_TRUE(driver.state().scene) << driver.state().log.back().text;
    EXPECT_EQ(driver.state().scene->trials.size(), 3u);
    EXPECT_TRUE(driver.state().scene->gravity_m_s2.isZero()) << "edits are in the copy";
    EXPECT_EQ(driver.state().settings.youngs_modulus_Pa, settings.youngs_modulus_Pa);
    EXPECT_TRUE(driver.state().self_contained);
    // Saved again where it is, with one more edit.
    driver.workbench->execute(
        EditDeclaration{{SetDeclared{{"environment", "gravity_m_s2"}, "[0.0, 0.0, -1.0]"}}, "gravity"});
    driver.workbench->execute(ui::commands::Save{});
    ASSERT_FALSE(driver.state().unsaved()) << driver.state().log.back().text;
    Driver again(backend::make_core_backend(), 1280, 900);
    open_at(again, moved / "arm.myoloop");
    ASSERT_TRUE(again.state().scene) << again.state().log.back().text;
    EXPECT_NEAR(again.state().scene->gravity_m_s2.z(), -1.0, 1e-12);
}

TEST(SelfContained, HoldsTheMeshOfAProjectWithoutAnExperiment) {
    const test::Folder folder("self_contained_mesh");
    folder.write("shapes/body.stl", "solid");
    ui::commands::Project project;
    project.source = folder.path() / "shapes/body.stl";
    project.metres_per_unit = 1e-3;
    project.settings.material = "neo_hookean";
    project.settings.integrator = "tr_bdf2";
    project.self_contained = true;
    const fs::path file = folder.path() / "arm.myoloop";
    ASSERT_TRUE(backend::write_project_file(file, project));
    fs::remove_all(folder.path() / "shapes");
    const Result<ui::commands::Project> read = backend::read_project_file(file);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_FALSE(read->source_missing);
    EXPECT_EQ(*read_file(read->source), "solid");
}

TEST(Locate, GoesOnWithTheExperimentThatWasMoved) {
    const test::Folder folder("locate");
    const fs::path beam = test::beam_in(folder), file = folder.path() / "arm.myoloop";
    {
        Driver driver(backend::make_core_backend(), 1280, 900);
        open_at(driver, beam);
        ui::commands::Settings settings = driver.state().settings;
        settings.youngs_modulus_Pa = 2.2e5;
        driver.workbench->execute(ui::commands::ChangeSettings{settings, "modulus"});
        driver.workbench->execute(ui::commands::SaveAs{file});
    }
    fs::rename(beam, folder.path() / "renamed");
    Driver driver(backend::make_core_backend(), 1280, 900);
    open_at(driver, file);
    EXPECT_FALSE(driver.state().scene);
    ASSERT_TRUE(driver.state().missing);
    EXPECT_EQ(driver.state().missing->source.filename(), "beam");
    driver.workbench->execute(ui::commands::Locate{folder.path() / "renamed"});
    ASSERT_TRUE(driver.wait_for_job(60));
    ASSERT_TRUE(driver.state().scene) << driver.state().log.back().text;
    EXPECT_EQ(driver.state().settings.youngs_modulus_Pa, 2.2e5);
    driver.workbench->execute(ui::commands::Save{});
    const Result<ui::commands::Project> read = backend::read_project_file(file);
    ASSERT_TRUE(read);
    EXPECT_FALSE(read->source_missing) << "the new place is kept";
}

TEST(SaveExperimentAs, CopiesTheEditsAndTheFilesFromElsewhere) {
    const test::Folder folder("experiment_copy");
    const fs::path beam = spread_beam(folder), copy = folder.path() / "deep" / "copy";
    const std::string before = *read_file(beam / "experiment.toml");
    Driver driver(backend::make_core_backend(), 1280, 900);
    open_at(driver, beam);
    driver.workbench->execute(no_gravity);
    driver.workbench->execute(ui::commands::SaveExperimentAs{copy});
    ASSERT_EQ(driver.state().log.back().level, ui::commands::LogLevel::done) << driver.state().log.back().text;
    EXPECT_EQ(*read_file(beam / "experiment.toml"), before);
    const Result<experiment::Experiment> read = experiment::read_experiment(copy);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_TRUE(read->gravity_m_s2.isZero());
    EXPECT_EQ(fs::weakly_canonical(read->trials[2].trace), fs::weakly_canonical(copy / "outside/tip_weight.csv"));
    EXPECT_EQ(*read_file(read->trials[2].trace), *read_file(folder.path() / "takes/tip_weight.csv"));
    EXPECT_THAT(*read_file(copy / "experiment.toml"), HasSubstr("# data sheet")) << "comments stay";
    driver.workbench->execute(ui::commands::SaveExperimentAs{copy});
    EXPECT_EQ(driver.state().log.back().level, ui::commands::LogLevel::failure) << "the folder is not empty now";
}

}  // namespace
}  // namespace myo
