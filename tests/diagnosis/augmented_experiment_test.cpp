#include "diagnosis/report/augmented_experiment.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/folder.hpp"

namespace myo::diagnosis {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(AugmentedExperiment, NamesTheSameFilesFromWhereItLies) {
    const test::Folder folder("augmented");
    folder.write("home/experiment.toml",
                 "file = \"body.stl\"\ntrace = 'take 1.csv'\nsignal = "
                 "\"beat.csv\"\nmask=\"/elsewhere/mask.csv\"\nprofile = \"name.csv\"");
    const Result<std::string> text = augmented_experiment(folder.path() / "home/experiment.toml",
                                                          {{"quadratic_drag", {{"coefficient_kg_m3", 900.0}}, false}},
                                                          folder.path() / "out");
    ASSERT_TRUE(text) << text.error().text();
    EXPECT_THAT(*text, HasSubstr("file = \"../home/body.stl\""));
    EXPECT_THAT(*text, HasSubstr("trace = \"../home/take 1.csv\""));
    EXPECT_THAT(*text, HasSubstr("signal = \"../home/beat.csv\""));
    EXPECT_THAT(*text, HasSubstr("mask=\"/elsewhere/mask.csv\""));
    EXPECT_THAT(*text, HasSubstr("profile = \"name.csv\""));
    EXPECT_THAT(*text, HasSubstr("# Found by `myoloop diagnose`. Modulus and damping stay as declared"));
    EXPECT_THAT(*text, HasSubstr("[[effect]]\nid = \"quadratic_drag\"\ncoefficient_kg_m3 = 900.0\ncalibrate = true\n"));
    const Result<std::string> same = augmented_experiment(folder.path() / "home/experiment.toml", {},
                                                          folder.path() / "out");
    ASSERT_TRUE(same);
    EXPECT_THAT(*same, Not(HasSubstr("Found")));
}

}  // namespace
}  // namespace myo::diagnosis
