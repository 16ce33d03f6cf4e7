#include "diagnosis/report/augmented_experiment.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/read_experiment.hpp"
#include "support/robot_folder.hpp"
#include "support/swung_beam.hpp"

namespace myo::diagnosis {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(AugmentedExperiment, NamesTheSameFilesFromWhereItLies) {
    const test::Folder folder("augmented");
    folder.write("home/experiment.toml",
                 "file = \"body.stl\"\ntrace = 'take 1.csv'\nsignal = "
                 "\"beat.csv\"\nmask=\"/elsewhere/mask.csv\"\nprofile = \"name.csv\"\n"
                 "[[effect]]\nid = \"actuation_lag\"\nsignal = \"upper\"\n[[muscle]]\nsignal = \"late.csv\"\n"
                 "[[trial.goal]]\npath = \"goal.csv\"\n");
    const Result<std::string> text = augmented_experiment(folder.path() / "home/experiment.toml",
                                                          {{"quadratic_drag", {{"coefficient_kg_m3", 900.0}}, false}},
                                                          folder.path() / "out");
    ASSERT_TRUE(text) << text.error().text();
    EXPECT_THAT(*text, HasSubstr("file = \"../home/body.stl\""));
    EXPECT_THAT(*text, HasSubstr("trace = \"../home/take 1.csv\""));
    EXPECT_THAT(*text, HasSubstr("signal = \"../home/beat.csv\""));
    EXPECT_THAT(*text, HasSubstr("mask=\"/elsewhere/mask.csv\""));
    EXPECT_THAT(*text, HasSubstr("profile = \"name.csv\""));
    EXPECT_THAT(*text, HasSubstr("signal = \"upper\"")) << "an actuator, not a file";
    EXPECT_THAT(*text, HasSubstr("signal = \"../home/late.csv\""));
    EXPECT_THAT(*text, HasSubstr("path = \"../home/goal.csv\""));
    EXPECT_THAT(*text, HasSubstr("# Found by `myoloop diagnose`. Modulus and damping stay as declared"));
    EXPECT_THAT(*text, HasSubstr("[[effect]]\nid = \"quadratic_drag\"\ncoefficient_kg_m3 = 900.0\ncalibrate = true\n"));
    const Result<std::string> same = augmented_experiment(folder.path() / "home/experiment.toml", {},
                                                          folder.path() / "out");
    ASSERT_TRUE(same);
    EXPECT_THAT(*same, Not(HasSubstr("Found")));
}

/// What is written is read again with the same values, whatever their type.
TEST(AugmentedExperiment, IsReadAgainWithTheSameEffects) {
    const test::Folder folder("augmented");
    static_cast<void>(test::swung_beam(folder, 0.1));
    const Eigen::VectorXd place = Eigen::Vector3d(0.1, 0.015, -3e-9);
    const std::vector<effect::EffectDeclaration> effects{
        {"point_mass", {{"mass_kg", 2.0}, {"position_m", place}}, false},
        {"marker_swap",
         {{"markers", std::vector<std::string>{"tip_left", "tip_right"}},
          {"time_s", 0.125},
          {"trial", std::string("swing")}},
         false},
        {"clock_offset", {{"offset_s", -1.25e-3}}, false}};
    const Result<std::string> text = augmented_experiment(folder.path() / "experiment.toml", effects, folder.path());
    ASSERT_TRUE(text) << text.error().text();
    folder.write("experiment.toml", *text);
    const Result<experiment::Experiment> read = experiment::read_experiment(folder.path());
    ASSERT_TRUE(read) << read.error().text();
    ASSERT_EQ(read->effects.size(), effects.size());
    for (std::size_t i = 0; i < effects.size(); ++i) {
        EXPECT_EQ(read->effects[i].id, effects[i].id);
        EXPECT_TRUE(read->effects[i].calibrate);
        EXPECT_EQ(read->effects[i].parameters.size(), effects[i].parameters.size()) << effects[i].id;
    }
    const auto& mass = read->effects[0].parameters;
    EXPECT_EQ(effect::number(mass, "mass_kg"), 2.0);
    EXPECT_LT((effect::vector(mass, "position_m") - place).norm(), 1e-16);
    EXPECT_EQ(std::get<std::vector<std::string>>(read->effects[1].parameters.at("markers")),
              (std::vector<std::string>{"tip_left", "tip_right"}));
    EXPECT_EQ(effect::number(read->effects[2].parameters, "offset_s"), -1.25e-3);
    EXPECT_EQ(effect::text(read->effects[1].parameters, "trial"), "swing");
    EXPECT_EQ(read->trials.size(), 2u) << "what was written before is kept";
}

/// Files of a trial, seen from anywhere.
std::vector<std::filesystem::path> files_of(const experiment::TrialDeclaration& trial) {
    std::vector<std::filesystem::path> files{std::filesystem::weakly_canonical(trial.trace)};
    for (const auto& file : {trial.actuation, trial.sensors})
        if (file) files.push_back(std::filesystem::weakly_canonical(*file));
    return files;
}

/// Chambers, tendons, parts, mount, obstacles, sensors, limits, holds and commands are the same from another folder.
TEST(AugmentedExperiment, KeepsEveryTableOfARobot) {
    const test::Folder folder("augmented_robot");
    test::write_robot(folder, test::robot_toml);
    const Result<experiment::Experiment> before = experiment::read_experiment(folder.path());
    ASSERT_TRUE(before) << before.error().text();
    const Result<std::string> text = augmented_experiment(
        folder.path() / "experiment.toml",
        {{"actuation_lag", {{"time_constant_s", 0.02}, {"signal", std::string("upper")}}, false},
         {"tendon_friction", {{"coefficient", 0.1}, {"tendon", std::string("left")}}, false}},
        folder.path() / "out");
    ASSERT_TRUE(text) << text.error().text();
    folder.write("out/experiment.toml", *text);
    const Result<experiment::Experiment> after = experiment::read_experiment(folder.path() / "out");
    ASSERT_TRUE(after) << after.error().text();
    ASSERT_EQ(after->effects.size(), 2u);
    EXPECT_EQ(effect::text(after->effects[0].parameters, "signal"), "upper");
    ASSERT_EQ(after->chambers.size(), 1u);
    EXPECT_EQ(after->chambers[0].inside_m, before->chambers[0].inside_m);
    ASSERT_EQ(after->tendons.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(after->tendons[i].path_m, before->tendons[i].path_m);
        EXPECT_EQ(after->tendons[i].drive, before->tendons[i].drive);
        EXPECT_EQ(after->tendons[i].stiffness_N_m, before->tendons[i].stiffness_N_m);
        EXPECT_EQ(after->tendons[i].friction, before->tendons[i].friction);
    }
    ASSERT_EQ(after->parts.size(), 2u);
    const auto file = [](const experiment::PartDeclaration& part) {
        return std::filesystem::weakly_canonical(std::get<std::filesystem::path>(part.place));
    };
    EXPECT_EQ(file(after->parts[1]), file(before->parts[1]));
    EXPECT_EQ(after->parts[0].calibrate, before->parts[0].calibrate);
    EXPECT_EQ(after->mount, before->mount);
    EXPECT_EQ(after->obstacles.size(), before->obstacles.size());
    EXPECT_EQ(after->sensors.size(), before->sensors.size());
    EXPECT_EQ(after->limits.tension_N, 12.0);
    EXPECT_EQ(after->limits.activation, 0.7);
    ASSERT_EQ(after->trials.size(), before->trials.size());
    for (std::size_t t = 0; t < after->trials.size(); ++t) {
        const experiment::TrialDeclaration &was = before->trials[t], &is = after->trials[t];
        EXPECT_EQ(files_of(is), files_of(was));
        EXPECT_EQ(is.hold, was.hold);
        EXPECT_EQ(is.sensor_values, was.sensor_values);
        EXPECT_EQ(is.constant_commands.size(), was.constant_commands.size());
        EXPECT_EQ(is.actuation_steps.size(), was.actuation_steps.size());
    }
}

TEST(AugmentedExperiment, WritesNumbersAndNamesAsToml) {
    EXPECT_EQ(
        effect_tables({{"an_effect", {{"axis", 2.0}, {"name", std::string("a \"quoted\" \\ name")}}, false}}, false),
        "\n[[effect]]\nid = \"an_effect\"\naxis = 2.0\nname = \"a \\\"quoted\\\" \\\\ name\"\n");
    EXPECT_EQ(effect_tables({{"e", {{"x", 1e-12}}, false}}, true),
              "\n[[effect]]\nid = \"e\"\nx = 1e-12\ncalibrate = true\n");
    EXPECT_EQ(effect_tables({}, true), "");
    EXPECT_FALSE(augmented_experiment("/nowhere/experiment.toml", {}, "/nowhere"));
}

}  // namespace
}  // namespace myo::diagnosis
