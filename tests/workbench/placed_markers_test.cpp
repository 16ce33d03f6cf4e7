#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/read_experiment.hpp"
#include "mesh/vtk_writer.hpp"
#include "workbench/beam_take.hpp"
#include "workbench/own_robot.hpp"

// A recording comes to an experiment that was just made of a surface and has no markers yet.

namespace myo {
namespace {

using PlacedMarkers = test::OwnRobot;

TEST_F(PlacedMarkers, ARecordingBringsItsMarkersToAnExperimentWithoutAny) {
    const test::Folder folder("placed_markers");
    const std::filesystem::path beam = test::beam_in(folder);
    driver.workbench->execute(ui::commands::Open{beam, std::nullopt});
    ASSERT_NO_FATAL_FAILURE(wait(60));
    const std::vector<ui::commands::SceneMarker> known = state().scene->markers;
    std::filesystem::create_directories(folder.path() / "files");
    ASSERT_TRUE(mesh::write_stl(folder.path() / "files" / "body.stl", state().scene->surface, 1e-3));
    const std::filesystem::path take = folder.path() / "files" / "take.csv";
    std::filesystem::rename(test::take_of(folder, beam / "gravity_release.csv"), take);

    driver.workbench->execute(ui::commands::Open{folder.path() / "files" / "body.stl", 1e-3});
    ASSERT_NO_FATAL_FAILURE(wait(60));
    driver.workbench->execute(ui::commands::MakeExperiment{folder.path() / "made"});
    ASSERT_NO_FATAL_FAILURE(wait(60));
    ASSERT_TRUE(state().scene->markers.empty());
    driver.workbench->execute(ui::commands::ReadRecording{take});
    ASSERT_NO_FATAL_FAILURE(wait(30));
    ASSERT_TRUE(state().import) << state().log.back().text;
    // Three labels are placed on the body; take_of turned their order round. The others follow.
    ui::commands::ImportChoices choices = state().import->choices;
    for (const std::size_t i : {0u, 1u, 2u})
        choices.markers[i] = {"m" + std::to_string(i), known[known.size() - 1 - i].rest_m};
    driver.workbench->execute(ui::commands::ChangeImport{choices});
    driver.workbench->execute(ui::commands::ProposeMarkers{});
    ASSERT_EQ(state().import->view.problem, "") << "no other folder is asked for";
    driver.settle();
    driver.click("import/add");
    ASSERT_NO_FATAL_FAILURE(wait(120));
    ASSERT_FALSE(state().import) << state().log.back().text;
    EXPECT_EQ(state().scene->path, folder.path() / "made");
    EXPECT_EQ(state().scene->markers.size(), known.size());
    EXPECT_EQ(state().scene->trials.size(), 2u);
    const Result<experiment::Experiment> read = experiment::read_experiment(folder.path() / "made");
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->markers.on_body.size(), known.size());
}

/// The folder of an experiment that was just made holds no recordings.
TEST_F(PlacedMarkers, RecordingsAreLookedForWhereTheBodyWas) {
    const test::Folder folder("placed_dialog");
    std::filesystem::create_directories(folder.path() / "files");
    ASSERT_TRUE(mesh::write_stl(folder.path() / "files" / "body.stl",
                                mesh::box_surface({{0.0, 0.0, 0.0}, {0.08, 0.02, 0.02}}), 1e-3));
    folder.write("files/take.csv", "time_s,a_x_m,a_y_m,a_z_m\n0,0,0,0\n0.01,0,0,0\n");
    ASSERT_NO_FATAL_FAILURE(open_body(folder.path() / "files" / "body.stl", folder));
    panel("measure");
    driver.click("measure/import");
    driver.settle();
    EXPECT_TRUE(driver.has("browser/entry/take.csv"));
}

}  // namespace
}  // namespace myo
