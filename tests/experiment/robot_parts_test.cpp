#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/actuators.hpp"
#include "experiment/check_body.hpp"
#include "experiment/read_experiment.hpp"
#include "experiment/read_trial.hpp"
#include "support/experiment_folder.hpp"
#include "support/good_experiment.hpp"
#include "support/robot_folder.hpp"
#include "support/shared_data.hpp"

namespace myo::experiment {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using namespace testing_support;
using test::robot_toml;
using test::write_robot;

Result<void> read_and_check(const Folder& folder) {
    const Result<Experiment> read = read_experiment(folder.path());
    if (!read) return read.error();
    const Result<mesh::SurfaceMesh> body = read_body_surface(*read);
    if (!body) return body.error();
    if (const Result<void> fits = check_on_body(*read, *body); !fits) return fits;
    for (const TrialDeclaration& trial : read->trials)
        if (const auto table = read_trial_actuation(*read, trial); !table) return table.error();
    return {};
}

/// The file of a mask need not be there yet: the window writes it with the experiment.
TEST(RobotParts, AMaskIsNamedFromTheFolder) {
    const Folder folder("robot_mask");
    std::string text = robot_toml;
    const std::string file = "file = \"core.stl\"";
    text.replace(text.find(file), file.size(), "mask = \"parts/core.csv\"");
    write_robot(folder, text);
    const Result<Experiment> read = read_experiment(folder.path());
    ASSERT_TRUE(read) << read.error().text();
    const auto& painted = std::get<PartDeclaration::Painted>(read->parts[1].place);
    EXPECT_EQ(std::get<std::filesystem::path>(painted.mask), folder.path() / "parts" / "core.csv");
}

TEST(RobotParts, EveryKeyIsRead) {
    const Folder folder("robot");
    write_robot(folder, robot_toml);
    const Result<Experiment> read = read_experiment(folder.path());
    ASSERT_TRUE(read) << read.error().text();
    const Experiment& e = *read;
    EXPECT_EQ(std::get<StlGeometry>(e.geometry).metres_per_unit, 1e-2);
    ASSERT_EQ(e.chambers.size(), 1u);
    EXPECT_EQ(e.chambers[0].inside_m, Eigen::Vector3d(0.03, 0.015, 0.015));
    ASSERT_EQ(e.tendons.size(), 2u);
    EXPECT_EQ(e.tendons[0].path_m.cols(), 3);
    EXPECT_EQ(e.tendons[0].friction, 0.2);
    EXPECT_EQ(e.tendons[1].drive, TendonDrive::shortening);
    EXPECT_EQ(e.tendons[1].stiffness_N_m, 4000.0);
    EXPECT_FALSE(e.tendons[0].stiffness_N_m);
    ASSERT_EQ(e.parts.size(), 2u);
    EXPECT_EQ(e.parts[0].youngs_modulus_Pa, 2e6);
    EXPECT_EQ(e.parts[0].calibrate, std::vector<std::string>{"youngs_modulus"});
    EXPECT_EQ(std::get<std::filesystem::path>(e.parts[1].place), folder.path() / "core.stl");
    // What a part leaves out is the material's.
    EXPECT_EQ(e.parts[1].youngs_modulus_Pa, 2.6e5);
    EXPECT_EQ(e.parts[1].youngs_modulus_tolerance, 0.25);
    EXPECT_EQ(e.parts[1].poissons_ratio, 0.49);
    EXPECT_EQ(e.parts[1].density_kg_m3, 1070);
    EXPECT_EQ(e.parts[1].damping_s, 0.01);
    EXPECT_EQ(e.mount, MountMotion::markers);
    ASSERT_EQ(e.obstacles.size(), 3u);
    EXPECT_EQ(std::get<ObstacleDeclaration::Plane>(e.obstacles[0].shape).normal, Eigen::Vector3d::UnitZ());
    EXPECT_EQ(e.obstacles[0].friction, 0.4);
    EXPECT_EQ(std::get<ObstacleDeclaration::Sphere>(e.obstacles[1].shape).radius_m, 0.05);
    EXPECT_EQ(std::get<Box>(e.obstacles[2].shape).lowest, Eigen::Vector3d(0.2, 0.0, 0.0));
    ASSERT_EQ(e.sensors.size(), 4u);
    EXPECT_EQ(e.sensors[1].kind, SensorKind::chamber_volume);
    EXPECT_EQ(e.sensors[1].of, "upper");
    EXPECT_EQ(e.sensors[2].noise, 0.1);
    EXPECT_EQ(e.limits.pressure_Pa, 3e4);
    EXPECT_EQ(e.limits.tension_N, 12.0);
    EXPECT_EQ(e.limits.shortening_m, 0.02);
    EXPECT_EQ(e.limits.activation, 0.7);
    EXPECT_EQ(e.limits.force_N, 2.0);
    EXPECT_EQ(e.limits.mass_kg, 0.1);
    EXPECT_EQ(e.limits.duration_s, 5.0);
    EXPECT_TRUE(e.trials[0].hold);
    EXPECT_EQ(e.trials[0].constant_commands.size(), 4u);
    EXPECT_EQ(e.trials[0].sensor_values, (std::map<std::string, double>{{"cell_x_N", 0.2}, {"volume_m3", 2e-6}}));
    EXPECT_EQ(e.trials[1].sensors, folder.path() / "driven_sensors.csv");
    EXPECT_EQ(e.trials[2].actuation_steps.size(), 4u);
    EXPECT_FALSE(e.trials[2].hold);
    const Result<void> fits = read_and_check(folder);
    EXPECT_TRUE(fits) << fits.error().text();
}

TEST(RobotParts, ActuatorsAreInTheOrderOfDeclaration) {
    const Folder folder("robot_actuators");
    write_robot(folder, robot_toml);
    const Result<Experiment> read = read_experiment(folder.path());
    ASSERT_TRUE(read) << read.error().text();
    std::vector<std::string> columns;
    for (const Actuator& actuator : actuators(*read)) columns.push_back(actuator.column);
    EXPECT_EQ(columns, (std::vector<std::string>{"belly", "back", "upper_Pa", "left_N", "right_m"}));
    EXPECT_EQ(find_actuator(*read, "left"), 3u);
    EXPECT_FALSE(find_actuator(*read, "left_N"));

    const auto held = read_trial_actuation(*read, read->trials[0]);
    ASSERT_TRUE(held) << held.error().text();
    ASSERT_EQ(held->values.cols(), 1);
    EXPECT_NEAR(held->values(1, 0), 1.1, 1e-15);  // the follower of a constant
    EXPECT_EQ(held->values(2, 0), -500);
    EXPECT_EQ(held->values(3, 0), 3.08);
    EXPECT_EQ(held->values(4, 0), 0.002);
    const auto driven = read_trial_actuation(*read, read->trials[1]);
    ASSERT_TRUE(driven) << driven.error().text();
    EXPECT_EQ(driven->muscles, (std::vector<std::string>{"belly", "back", "upper", "left", "right"}));
    Eigen::MatrixXd values(5, 2);
    values << 1, 0.8, 1, 1.1, 0, 2e4, 1, 1, 0, 0.01;
    EXPECT_TRUE(driven->values.isApprox(values, 1e-14)) << driven->values;
    const auto stepped = read_trial_actuation(*read, read->trials[2]);
    ASSERT_TRUE(stepped);
    EXPECT_EQ(Eigen::VectorXd(stepped->values.col(0)), (Eigen::VectorXd(5) << 1, 1, 0, 0, 0).finished());
}

struct Spoiled {
    std::string from, to, line, key, word;
};

void PrintTo(const Spoiled& s, std::ostream* out) { *out << s.from << " -> " << s.to; }

class SpoiledRobot : public testing::TestWithParam<Spoiled> {};

TEST_P(SpoiledRobot, IsReportedWithKeyAndLine) {
    const Spoiled& s = GetParam();
    const Folder folder("spoiled_robot");
    const std::string toml = replaced(robot_toml, s.from, s.to);
    write_robot(folder, toml);
    const Result<void> read = read_and_check(folder);
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().where, testing::EndsWith("experiment.toml:" + std::to_string(line_of(toml, s.line))))
        << read.error().what;
    EXPECT_THAT(read.error().what, StartsWith(s.key));
    EXPECT_THAT(read.error().what, HasSubstr(s.word));
}

const std::string stl = "kind = \"stl\"\nfile = \"body.stl\"\nunit = \"cm\"";

INSTANTIATE_TEST_SUITE_P(
    RobotParts, SpoiledRobot,
    testing::Values(
        Spoiled{"unit = \"cm\"", "unit = \"inch\"", "unit", "geometry.unit: ", "mm, um"},
        Spoiled{stl, "kind = \"box\"\nsize_m = [0.1, 0.03, 0.03]", "[[chamber]]", "chamber[0]: ", "no cavity"},
        Spoiled{"inside_m", "inside", "inside =", "chamber[0].inside: unknown key", "\"inside_m\""},
        Spoiled{"[0.03, 0.015, 0.015]", "[0.05, 0.015, 0.015]", "inside_m", "chamber[0].inside_m: ", "in the material"},
        Spoiled{"[0.03, 0.015, 0.015]", "[0.03, 0.015, 0.5]", "inside_m", "chamber[0].inside_m: ", "outside"},
        Spoiled{"[[tendon]]", "[[chamber]]\nname = \"lower\"\ninside_m = [0.031, 0.015, 0.015]\n[[tendon]]", "[0.031",
                "chamber[1].inside_m: ", "\"upper\""},
        Spoiled{"name = \"upper\"", "name = \"belly\"", "name = \"belly\"\ninside_m", "chamber[0].name: ", "duplicate"},
        Spoiled{"name = \"left\"", "name = \"upper\"", "name = \"upper\"\npath_m", "tendon[0].name: ", "duplicate"},
        Spoiled{"[[0.0, 0.03, 0.01], [0.1, 0.03, 0.01]]", "[[0.0, 0.03, 0.01]]", "[[0.0, 0.03",
                "tendon[1].path_m: ", "at least two guides"},
        Spoiled{"[[0.0, 0.03, 0.01], [0.1, 0.03, 0.01]]", "[[0.0, 0.03, 0.01], [0.1, 0.5, 0.01]]", "[[0.0, 0.03",
                "tendon[1].path_m: ", "stand still"},
        Spoiled{"drive = \"tension\"", "drive = \"tension\"\nstiffness_N_m = 1", "stiffness_N_m",
                "tendon[0].stiffness_N_m: ", "shortening"},
        Spoiled{"friction = 0.2", "friction = -0.2", "friction", "tendon[0].friction: ", "negative"},
        Spoiled{"box_m = [[0.0, 0.0, 0.0], [0.1, 0.03, 0.002]]", "box_m = [[0.2, 0.0, 0.0], [0.3, 0.03, 0.002]]",
                "[[0.2", "part[0].box_m: ", "no material"},
        Spoiled{"file = \"core.stl\"", "region = 3", "region", "part[1].region: ", "volume"},
        Spoiled{"file = \"core.stl\"", "file = \"core.stl\"\nregion = 3", "region", "part[1].region: ", "exactly one"},
        Spoiled{"file = \"core.stl\"", "file = \"core.stl\"\nmask = \"core.csv\"", "mask",
                "part[1].mask: ", "exactly one"},
        Spoiled{"base_2 = [-0.09, 0.01, 0.0]\n", "", "motion", "mount.motion: ", "three markers"},
        Spoiled{"base_3 = [-0.09, 0.01, 0.03]", "base_3 = [-0.09, 0.02, 0.0]", "motion", "mount.motion: ", "one line"},
        Spoiled{"[mount]",
                "[[effect]]\nid = \"base_vibration\"\namplitude_m = 1e-3\nfrequency_Hz = 5\ndirection = [0, 0, 1]\n"
                "phase_rad = [0.1]\n[mount]",
                "phase_rad", "effect[0].phase_rad: ", "numbers"},
        Spoiled{"point_m = [0.0, 0.0, -0.01]", "point_m = [0.0, 0.0, 0.01]", "[[obstacle]]",
                "obstacle[0]: ", "at rest"},
        Spoiled{"radius_m = 0.05", "radius_m = 0.08", "[[obstacle]]\nkind = \"sphere\"", "obstacle[1]: ", "at rest"},
        Spoiled{"radius_m = 0.05", "radius_m = 0.05\nbox_m = [[0, 0, 0], [1, 1, 1]]", "box_m = [[0, 0",
                "obstacle[1].box_m: ", "belongs to"},
        Spoiled{"of = \"upper\"", "of = \"uper\"", "of = ", "sensor[1].of: ", "\"upper\""},
        Spoiled{"noise = 0.005\n", "", "[[sensor]]", "sensor[0].noise: ", "missing"},
        Spoiled{"cell_x_N = 0.2", "cell = 0.2", "sensor = {", "trial[0].sensor.cell: ", "cell_x_N"},
        Spoiled{"tension_N = 12", "tension = 12", "tension = 12", "limits.tension: unknown key", "\"tension_N\""},
        Spoiled{"pressure_Pa = 3e4", "pressure_Pa = -3e4", "pressure_Pa = -3e4", "limits.pressure_Pa: ", "positive"},
        Spoiled{"activation = 0.7", "activation = 1.2", "activation = 1.2", "limits.activation: ", "below 1"},
        Spoiled{"hold = true", "hold = true\nstart = \"straight\"", "start = ", "trial[0].start: ", "hold"},
        Spoiled{"hold = true", "hold = true\nactuation = \"driven_actuation.csv\"",
                "actuation = ", "trial[0].actuation: ", "hold"},
        Spoiled{"tension_N = { left = 3.08 }", "tension_N = { left = -1 }", "tension_N",
                "trial[0].tension_N.left: ", "negative"},
        Spoiled{"tension_N = { left = 3.08 }", "tension_N = { right = 1 }",
                "shortening_m = ", "trial[0].shortening_m.right: ", "tension_N already"},
        Spoiled{"belly = 0.8 }", "back = 0.8 }", "back = 0.8", "trial[0].activation.back: ", "follows"},
        Spoiled{"belly = 0.8 }", "bely = 0.8 }", "bely = 0.8", "trial[0].activation.bely: ", "\"belly\""},
        Spoiled{"tension_N = { left = 1.0 }", "pressure_Pa = { upper = 1.0 }",
                "actuation = ", "trial[1].actuation: ", "pressure_Pa as well"},
        Spoiled{"right = 0.01, belly", "left_N = 0.01, belly", "actuation_step",
                "trial[2].actuation_step.left_N: ", "\"left\""}));

// A tendon that is driven the other way than the constant says.
TEST(RobotParts, AThreadIsStraightUnlessItRunsInAChannel) {
    const Folder folder("channel");
    write_robot(folder, testing_support::replaced(robot_toml, "friction = 0.2", "friction = 0.2\nchannel = true"));
    const Result<Experiment> read = read_experiment(folder.path());
    ASSERT_TRUE(read) << read.error().text();
    EXPECT_TRUE(read->tendons[0].channel);
    EXPECT_FALSE(read->tendons[1].channel);
    write_robot(folder, testing_support::replaced(robot_toml, "friction = 0.2", "channel = 1"));
    const Result<Experiment> refused = read_experiment(folder.path());
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().text().find("tendon[0].channel"), std::string::npos) << refused.error().text();
}

TEST(RobotParts, ConstantsOfTheOtherDriveAreRefused) {
    for (const auto& [from, to, key] :
         {std::tuple<std::string, std::string, std::string>{"drive = \"shortening\"\nstiffness_N_m = 4000.0",
                                                            "drive = \"tension\"", "trial[0].shortening_m.right: "},
          {"drive = \"tension\"\n", "drive = \"shortening\"\n", "trial[0].tension_N.left: "}}) {
        const Folder folder("robot_drive");
        write_robot(folder, replaced(robot_toml, from, to));
        const Result<Experiment> read = read_experiment(folder.path());
        ASSERT_FALSE(read);
        EXPECT_THAT(read.error().what, StartsWith(key));
    }
}

TEST(RobotParts, RecordedTensionsMustNotBeNegative) {
    const Folder folder("robot_tension");
    write_robot(folder, replaced(robot_toml, "tension_N = { left = 1.0 }\n", ""));
    folder.write("driven_actuation.csv", "time_s,belly,left_N\n0,1,0\n1,1,-2\n");
    const Result<void> read = read_and_check(folder);
    ASSERT_FALSE(read);
    EXPECT_THAT(read.error().where, testing::EndsWith("driven_actuation.csv:3"));
    EXPECT_THAT(read.error().what, HasSubstr("negative tension"));
    folder.write("driven_actuation.csv", "time_s,belly,left_m\n0,1,0\n");
    EXPECT_THAT(read_and_check(folder).error().what, HasSubstr("\"left_N\""));
}

TEST(RobotParts, ObstaclesReplaceTheClamp) {
    const Folder folder("robot_lying");
    const std::string clamp = "[clamp]\nbox_m = [[-5e-4, -1e-3, -1e-3], [5e-4, 0.031, 0.031]]\n";
    std::string toml = replaced(replaced(robot_toml, clamp, ""), "motion = \"markers\"", "motion = \"fixed\"");
    write_robot(folder, toml);
    const Result<Experiment> lying = read_experiment(folder.path());
    ASSERT_TRUE(lying) << lying.error().text();
    EXPECT_FALSE(has_clamp(*lying));
    EXPECT_FALSE(lying->clamp_box_m.contains({0, 0, 0}));
    EXPECT_TRUE(read_and_check(folder));
    const std::size_t first = toml.find("[[obstacle]]");
    toml.erase(first, toml.find("[markers.rest_m]") - first);
    write_robot(folder, toml);
    const Result<Experiment> falling = read_experiment(folder.path());
    ASSERT_FALSE(falling);
    EXPECT_THAT(falling.error().what, StartsWith("clamp: is missing"));
}

TEST(RobotParts, VolumeMeshHasItsOwnBoundary) {
    const Folder folder("robot_volume");
    std::string toml = replaced(good_toml, "kind = \"box\"\nsize_m = [0.1, 0.03, 0.03]\norigin_m = [0.0, 0.0, 0.0]",
                                "kind = \"volume\"\nfile = \"cell.vtk\"\nunit = \"dm\"\n"
                                "rotation = [[0, -1, 0], [1, 0, 0], [0, 0, 1]]");
    write_files(folder, toml);
    folder.write("cell.vtk",
                 "# vtk DataFile Version 3.0\none cell\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n"
                 "0 0 0  2 0 0  0 1 0  0 0 1\nCELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n");
    const Result<Experiment> read = read_experiment(folder.path());
    ASSERT_TRUE(read) << read.error().text();
    const Result<mesh::SurfaceMesh> body = read_body_surface(*read);
    ASSERT_TRUE(body) << body.error().text();
    EXPECT_EQ(body->triangles.cols(), 4);
    EXPECT_NEAR(mesh::enclosed_volume(*body), 1e-3 / 3.0, 1e-12);
    EXPECT_NEAR((body->vertices.col(1) - Eigen::Vector3d(0, 0.2, 0)).norm(), 0.0, 1e-15);
}

TEST(RobotParts, SharedRobotsAreRead) {
    int seen = 0;
    for (const auto& folder : test::shared_entries("robots", [](const std::filesystem::path& path) {
             return std::filesystem::exists(path / "experiment.toml");
         })) {
        const Result<Experiment> read = read_experiment(folder);
        ASSERT_TRUE(read) << read.error().text();
        const Result<mesh::SurfaceMesh> body = read_body_surface(*read);
        ASSERT_TRUE(body) << body.error().text();
        const Result<void> fits = check_on_body(*read, *body);
        EXPECT_TRUE(fits) << fits.error().text();
        for (const TrialDeclaration& trial : read->trials) {
            const auto table = read_trial_actuation(*read, trial);
            EXPECT_TRUE(table) << table.error().text();
        }
        ++seen;
    }
    if (seen == 0) GTEST_SKIP() << "the measured data are not there";
}

}  // namespace
}  // namespace myo::experiment
