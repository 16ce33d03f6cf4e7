#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "base/files.hpp"
#include "experiment/new_trial.hpp"
#include "experiment/read_experiment.hpp"
#include "experiment/read_trial.hpp"
#include "mesh/surface_mesh.hpp"
#include "support/experiment_folder.hpp"
#include "support/robot_folder.hpp"

namespace myo::experiment {
namespace {

using testing_support::Folder;

NewTrial released(const std::string& name) {
    NewTrial trial;
    trial.name = name;
    trial.origin = "from take\n3.c3d";
    trial.recording.labels = {"tip", "side"};
    trial.recording.time_s = Eigen::VectorXd::LinSpaced(21, -0.1, 0.1);
    trial.recording.rate_Hz = 100.0;
    trial.recording.tracks = {Eigen::Matrix3Xd::Constant(3, 21, 0.05), Eigen::Matrix3Xd::Constant(3, 21, 0.02)};
    return trial;
}

Experiment beam() {
    Experiment beam;
    beam.name = "a \"beam\"";
    beam.clamp_box_m = {{-1e-3, -1e-3, -1e-3}, {1e-3, 0.031, 0.031}};
    beam.material.model = "neo_hookean";
    beam.material.youngs_modulus_Pa = 2.6e5;
    beam.material.poissons_ratio = 0.49;
    beam.material.density_kg_m3 = 1070.0;
    beam.gravity_m_s2 = {0.0, -9.81, 0.0};
    beam.markers.on_body = {{"tip", {0.1, 0.03, 0.01}, "tip"}, {"side", {0.05, 0.03, 0.02}, "side"}};
    return beam;
}

TEST(NewTrial, MakesAnExperimentThatReadsAsItWasMeant) {
    Folder folder("new_trial");
    const auto place = folder.path() / "new";
    ASSERT_TRUE(
        write_experiment(place, beam(), mesh::box_surface({{0.0, 0.0, 0.0}, {0.1, 0.03, 0.03}}), released("drop 1")));
    const Result<Experiment> read = read_experiment(place);
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_EQ(read->name, "a \"beam\"");
    EXPECT_EQ(read->gravity_m_s2, beam().gravity_m_s2);
    EXPECT_EQ(read->clamp_box_m.highest, beam().clamp_box_m.highest);
    ASSERT_EQ(read->markers.on_body.size(), 2u);
    EXPECT_EQ(read->markers.on_body[0].rest_m, beam().markers.on_body[0].rest_m);
    ASSERT_EQ(read->trials.size(), 1u);
    EXPECT_EQ(*read->trials[0].start_s, 0.0);
    const Result<measurement::Recording> recording = read_trial_recording(*read, read->trials[0]);
    ASSERT_TRUE(recording);
    EXPECT_EQ(recording->tracks[0], released("").recording.tracks[0]);
    // A second one goes beside it.
    NewTrial second = released("drop 2");
    second.role = TrialRole::validate;
    second.start = StartState::equilibrium;
    ASSERT_TRUE(add_trial(place, second));
    const Result<Experiment> both = read_experiment(place);
    ASSERT_TRUE(both) << both.error().text();
    ASSERT_EQ(both->trials.size(), 2u);
    EXPECT_EQ(both->trials[1].role, TrialRole::validate);
    EXPECT_EQ(both->trials[1].start, StartState::equilibrium);
}

TEST(NewTrial, ChangesNothingWhereItCannotBeRead) {
    Folder folder("new_trial");
    const auto place = folder.path() / "new";
    ASSERT_TRUE(
        write_experiment(place, beam(), mesh::box_surface({{0.0, 0.0, 0.0}, {0.1, 0.03, 0.03}}), released("drop")));
    const std::string before = *read_file(place / "experiment.toml");
    EXPECT_NE(add_trial(place, released("drop")).error().what.find("already"), std::string::npos);
    EXPECT_FALSE(add_trial(place, released("../drop")));
    EXPECT_FALSE(add_trial(folder.path(), released("other")));
    EXPECT_FALSE(write_experiment(place, beam(), mesh::box_surface({}), released("other"))) << "the folder is taken";
    EXPECT_EQ(*read_file(place / "experiment.toml"), before);
    // A declaration that does not read leaves no files behind.
    Experiment unclamped = beam();
    unclamped.markers.on_body.clear();
    EXPECT_FALSE(write_experiment(folder.path() / "bad", unclamped,
                                  mesh::box_surface({{0.0, 0.0, 0.0}, {0.1, 0.03, 0.03}}), released("drop")));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "bad"));
}

/// Supports hold a body without a clamp; a body that nothing holds is refused, with no folder left.
TEST(NewTrial, WritesWhatHoldsTheBody) {
    Folder folder("new_trial_held");
    const mesh::SurfaceMesh surface = mesh::box_surface({{0.0, 0.0, 0.0}, {0.1, 0.03, 0.03}});
    Experiment lying = beam();
    lying.clamp_box_m = {Eigen::Vector3d::Ones(), -Eigen::Vector3d::Ones()};
    const Result<void> planned = write_planned_experiment(folder.path() / "none", lying, surface);
    ASSERT_FALSE(planned);
    EXPECT_NE(planned.error().what.find("clamp: is missing"), std::string::npos) << planned.error().what;
    EXPECT_FALSE(write_experiment(folder.path() / "none", lying, surface, released("drop")));
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "none"));
    lying.supports = {{{{0.0, 0.0, 0.0}, {0.0, 0.03, 0.0}}},
                      {{{0.1, 0.0, 0.0}, {0.1, 0.03, 0.0}}, {false, true, true}}};
    ASSERT_TRUE(write_planned_experiment(folder.path() / "planned", lying, surface));
    ASSERT_TRUE(write_experiment(folder.path() / "recorded", lying, surface, released("drop")));
    for (const char* name : {"planned", "recorded"}) {
        const Result<Experiment> read = read_experiment(folder.path() / name);
        ASSERT_TRUE(read) << read.error().text();
        EXPECT_FALSE(has_clamp(*read));
        ASSERT_EQ(read->supports.size(), 2u);
        EXPECT_TRUE(read->supports[0].clamps());
        EXPECT_EQ(read->supports[1].box_m.lowest, lying.supports[1].box_m.lowest);
        EXPECT_EQ(read->supports[1].held, lying.supports[1].held);
    }
}

TEST(NewTrial, CopiesAnExperimentOutsideOfItself) {
    Folder folder("new_trial");
    const auto place = folder.path() / "one";
    ASSERT_TRUE(
        write_experiment(place, beam(), mesh::box_surface({{0.0, 0.0, 0.0}, {0.1, 0.03, 0.03}}), released("drop")));
    EXPECT_FALSE(copy_experiment(place, place / "inner"));
    EXPECT_FALSE(copy_experiment(place, place));
    ASSERT_TRUE(copy_experiment(place, folder.path() / "two"));
    EXPECT_TRUE(read_experiment(folder.path() / "two"));
}

/// A robot with every table, copied and with one more trial.
TEST(NewTrial, LeavesEveryTableOfARobot) {
    Folder folder("new_trial_robot");
    test::write_robot(folder, test::robot_toml + std::string("[[trial.goal]]\nmarker = \"tip\"\nplace_m = [0.1, 0, "
                                                             "0]\ntime_s = 0.2\n"));
    const auto copy = folder.path().parent_path() / (folder.path().filename().string() + "_copy");
    ASSERT_TRUE(copy_experiment(folder.path(), copy));
    NewTrial trial = released("one more");
    trial.recording.labels = {"tip", "base_1", "base_2", "base_3"};
    trial.recording.tracks.resize(4, trial.recording.tracks[0]);
    const Result<void> added = add_trial(copy, trial);
    ASSERT_TRUE(added) << added.error().text();
    const Result<Experiment> before = read_experiment(folder.path()), after = read_experiment(copy);
    ASSERT_TRUE(before);
    ASSERT_TRUE(after) << after.error().text();
    EXPECT_EQ(after->trials.size(), before->trials.size() + 1);
    EXPECT_EQ(after->chambers.size(), 1u);
    EXPECT_EQ(after->tendons.size(), 2u);
    EXPECT_EQ(after->parts.size(), 2u);
    EXPECT_EQ(after->obstacles.size(), 3u);
    EXPECT_EQ(after->sensors.size(), 4u);
    EXPECT_EQ(after->mount, MountMotion::markers);
    EXPECT_EQ(after->limits.pressure_Pa, 3e4);
    EXPECT_EQ(after->trials[0].constant_commands.size(), 4u);
    EXPECT_EQ(after->trials[2].goals.size(), 1u);
    EXPECT_EQ(after->trials[1].sensors, copy / "driven_sensors.csv");
    std::filesystem::remove_all(copy);
}

}  // namespace
}  // namespace myo::experiment
