#include <gtest/gtest.h>

#include "backend/workbench_backend.hpp"
#include "experiment/read_experiment.hpp"
#include "measurement/rigid_motion.hpp"
#include "mesh/vtk_writer.hpp"
#include "support/folder.hpp"
#include "ui/driver.hpp"
#include "workbench/beam_take.hpp"

namespace myo {
namespace {

namespace fs = std::filesystem;
using test::beam_in;
using test::camera;
using test::Driver;
using test::Folder;
using test::take_of;

TEST(CoreImport, ARecordingByOtherCamerasBecomesTheTrialThatItWas) {
    Folder folder("import");
    const fs::path beam = beam_in(folder);
    Driver driver(backend::make_core_backend(), 1400, 900);
    driver.workbench->execute(ui::commands::Open{beam, std::nullopt});
    ASSERT_TRUE(driver.wait_for_job(60));
    const ui::commands::SceneTrial known = driver.state().scene->trials[0];
    ASSERT_EQ(known.name, "gravity_release");
    driver.workbench->execute(ui::commands::Run{});
    ASSERT_TRUE(driver.wait_for_job(120));
    const double rms = driver.state().run->trials[0].rms_m;
    driver.workbench->execute(ui::commands::ReadRecording{take_of(folder, beam / "gravity_release.csv")});
    ASSERT_TRUE(driver.wait_for_job(30));
    ASSERT_TRUE(driver.state().import) << driver.state().log.back().text;
    // Markers and frame are told by their distances alone.
    const ui::commands::RecordingImport& import = *driver.state().import;
    EXPECT_EQ(import.view.problem, "");
    EXPECT_LT(import.view.rms_m, 5e-4);
    EXPECT_LT(measurement::rotation_angle(import.view.rotation * camera.rotation), 0.02);
    EXPECT_NEAR(import.choices.start_s, 0.6, 0.015);
    // By the run the start is found, too, although its modulus is not that of the beam.
    driver.workbench->execute(ui::commands::AlignImport{});
    EXPECT_NEAR(driver.state().import->choices.start_s, 0.6, 0.03);
    ui::commands::ImportChoices choices = driver.state().import->choices;
    // A name that the experiment does not declare would be dropped in silence.
    ui::commands::ImportChoices foreign = choices;
    foreign.markers[0] = {"own_name", Eigen::Vector3d::Zero()};
    driver.workbench->execute(ui::commands::ChangeImport{foreign});
    EXPECT_EQ(driver.state().import->view.problem, "The experiment has no marker own_name.");
    choices.trial = "gravity_release";
    driver.workbench->execute(ui::commands::ChangeImport{choices});
    EXPECT_EQ(driver.state().import->view.problem,
              "The experiment has a trial gravity_release already: choose another name.");
    choices.start_s = 0.6;
    choices.fit = false;
    choices.trial = "again";
    driver.workbench->execute(ui::commands::ChangeImport{choices});
    driver.workbench->execute(ui::commands::AddRecording{});
    ASSERT_TRUE(driver.wait_for_job(120));
    ASSERT_FALSE(driver.state().import) << driver.state().log.back().text;
    const ui::commands::SceneTrial* const added = driver.state().scene_trial();
    ASSERT_TRUE(added);
    EXPECT_EQ(added->name, "again");
    EXPECT_EQ(added->role, "validate");
    driver.workbench->execute(ui::commands::Run{});
    ASSERT_TRUE(driver.wait_for_job(120));
    EXPECT_NEAR(driver.state().run->trials.back().rms_m, rms, 0.05 * rms)
        << "the same motion, from another folder of files";
    // Steps are chosen anew: what they change is far below the error.
    EXPECT_NEAR(driver.state().run->trials.front().rms_m, rms, 0.005 * rms);
}

TEST(CoreImport, BundledExamplesStayAsTheyAre) {
    Folder folder("import_bundled");
    Driver driver(backend::make_core_backend(), 1400, 900);
    const fs::path beam = fs::path(MYOLOOP_SOURCE_DIR) / "assets/examples/silicone_beam";
    driver.workbench->execute(ui::commands::Open{beam, std::nullopt});
    ASSERT_TRUE(driver.wait_for_job(60));
    driver.workbench->execute(ui::commands::ReadRecording{beam / "side_pluck.csv"});
    ASSERT_TRUE(driver.wait_for_job(30));
    ASSERT_TRUE(driver.state().import);
    ui::commands::ImportChoices choices = driver.state().import->choices;
    choices.trial = "again";
    driver.workbench->execute(ui::commands::ChangeImport{choices});
    // Nothing is added unless this holds: the example belongs to the checkout.
    ASSERT_EQ(driver.state().import->view.problem,
              "Bundled examples are not changed: choose a folder for a copy of this one.");
    driver.workbench->execute(ui::commands::AddRecording{});
    EXPECT_FALSE(driver.state().busy());
    choices.folder = folder.path() / "copy";
    driver.workbench->execute(ui::commands::ChangeImport{choices});
    EXPECT_EQ(driver.state().import->view.problem, "");
    driver.workbench->execute(ui::commands::AddRecording{});
    ASSERT_TRUE(driver.wait_for_job(60));
    EXPECT_TRUE(fs::exists(folder.path() / "copy/again.csv"));
    EXPECT_FALSE(fs::exists(beam / "again.csv"));
}

TEST(CoreImport, APlainMeshBecomesAnExperiment) {
    Folder folder("import_mesh");
    const fs::path beam = beam_in(folder);
    Driver driver(backend::make_core_backend(), 1400, 900);
    driver.workbench->execute(ui::commands::Open{beam, std::nullopt});
    ASSERT_TRUE(driver.wait_for_job(60));
    const std::vector<ui::commands::SceneMarker> markers = driver.state().scene->markers;
    const fs::path mesh = folder.path() / "plain.stl";
    ASSERT_TRUE(mesh::write_stl(mesh, driver.state().scene->surface, 1e-3));
    const fs::path take = take_of(folder, beam / "gravity_release.csv");
    driver.workbench->execute(ui::commands::Open{mesh, 1e-3});
    ASSERT_TRUE(driver.wait_for_job(60));
    driver.workbench->execute(ui::commands::ReadRecording{take});
    ASSERT_TRUE(driver.wait_for_job(30));
    ASSERT_TRUE(driver.state().import);
    EXPECT_FALSE(driver.state().import->view.problem.empty());
    driver.workbench->execute(ui::commands::ProposeMarkers{});
    EXPECT_EQ(driver.state().log.back().level, ui::commands::LogLevel::warning) << "nothing has been clicked";
    // Three are clicked; take_of turned their order round.
    ui::commands::ImportChoices choices = driver.state().import->choices;
    for (const std::size_t i : {0u, 1u, 2u})
        choices.markers[i] = {"m" + std::to_string(i), markers[markers.size() - 1 - i].rest_m};
    choices.folder = folder.path() / "made";
    driver.workbench->execute(ui::commands::ChangeImport{choices});
    driver.workbench->execute(ui::commands::ProposeMarkers{});
    const ui::commands::RecordingImport& import = *driver.state().import;
    ASSERT_EQ(import.view.problem, "");
    for (std::size_t i = 0; i < markers.size(); ++i) {
        ASSERT_TRUE(import.choices.markers[i].rest_m) << i;
        EXPECT_LT((*import.choices.markers[i].rest_m - markers[markers.size() - 1 - i].rest_m).norm(), 2e-3) << i;
    }
    driver.workbench->execute(ui::commands::AddRecording{});
    ASSERT_TRUE(driver.wait_for_job(120));
    ASSERT_FALSE(driver.state().import) << driver.state().log.back().text;
    EXPECT_EQ(driver.state().scene->trials.size(), 1u);
    EXPECT_EQ(driver.state().scene->markers.size(), markers.size());
    driver.workbench->execute(ui::commands::Run{});
    ASSERT_TRUE(driver.wait_for_job(120));
    EXPECT_LT(driver.state().run->rms_m, 0.02);
}

/// A table without header says nothing of its unit, and a wrong guess would go unnoticed.
TEST(CoreImport, NoUnitIsChosenForTheUser) {
    Folder folder("import_unit");
    const fs::path beam = beam_in(folder);
    const measurement::Recording take = *measurement::read_trace_csv(take_of(folder, beam / "gravity_release.csv"));
    std::string text;
    for (Eigen::Index t = 0; t < take.sample_count(); ++t)
        for (std::size_t m = 0; m < take.tracks.size(); ++m)
            for (int axis = 0; axis < 3; ++axis)
                text += std::to_string(100.0 * take.tracks[m](axis, t)) +
                        (axis == 2 && m + 1 == take.tracks.size() ? "\n" : ";");
    folder.write("stream.txt", text);
    Driver driver(backend::make_core_backend(), 1400, 900);
    driver.workbench->execute(ui::commands::Open{beam, std::nullopt});
    ASSERT_TRUE(driver.wait_for_job(60));
    driver.workbench->execute(ui::commands::ReadRecording{folder.path() / "stream.txt"});
    ASSERT_TRUE(driver.wait_for_job(30));
    ASSERT_TRUE(driver.state().import) << driver.state().log.back().text;
    EXPECT_FALSE(driver.state().import->file.reading.metres_per_unit);
    EXPECT_EQ(driver.state().import->view.problem, "Choose the unit of the file's lengths.");
    driver.workbench->execute(ui::commands::ReadRecording{folder.path() / "stream.txt", {.metres_per_unit = 1e-2}});
    ASSERT_TRUE(driver.wait_for_job(30));
    EXPECT_EQ(driver.state().import->view.problem, "");
    EXPECT_LT(driver.state().import->view.rms_m, 5e-4) << "the markers are proposed once their distances are known";
}

/// Edits that were not saved are written with the trial, and are not taken back by opening the experiment again.
TEST(CoreImport, ARecordingIsAddedToTheEditedExperiment) {
    Folder folder("import_edited");
    const fs::path beam = beam_in(folder);
    Driver driver(backend::make_core_backend(), 1280, 900);
    driver.workbench->execute(ui::commands::Open{beam, std::nullopt});
    ASSERT_TRUE(driver.wait_for_job(60));
    driver.workbench->execute(ui::commands::EditDeclaration{
        {ui::commands::SetDeclared{{"environment", "gravity_m_s2"}, "[0.0, 0.0, 0.0]"}}, "gravity"});
    driver.workbench->execute(ui::commands::ReadRecording{take_of(folder, beam / "gravity_release.csv")});
    ASSERT_TRUE(driver.wait_for_job(30));
    ASSERT_TRUE(driver.state().import) << driver.state().log.back().text;
    ui::commands::ImportChoices choices = driver.state().import->choices;
    choices.trial = "again";
    choices.start_s = 0.6;
    driver.workbench->execute(ui::commands::ChangeImport{choices});
    driver.workbench->execute(ui::commands::AddRecording{});
    ASSERT_TRUE(driver.wait_for_job(120));
    ASSERT_FALSE(driver.state().import) << driver.state().log.back().text;
    EXPECT_EQ(driver.state().scene->trials.size(), 4u);
    EXPECT_TRUE(driver.state().scene->gravity_m_s2.isZero());
    const Result<experiment::Experiment> read = experiment::read_experiment(beam);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->trials.size(), 4u);
    EXPECT_TRUE(read->gravity_m_s2.isZero());
}

}  // namespace
}  // namespace myo
