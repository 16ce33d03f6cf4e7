#include "diagnosis/report/augmented_experiment.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "experiment/read_experiment.hpp"
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
                 "[[effect]]\nid = \"actuation_lag\"\nsignal = \"upper\"\n[[muscle]]\nsignal = \"late.csv\"\n");
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
