#include "measurement/marker_labels.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "measurement/units.hpp"

namespace myo::measurement {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(MarkerLabels, ANameMeansALabelOrThatOfASubject) {
    const std::vector<std::string> labels{"left:tip", "right:tip", "left:root", "root", "a:b:c"};
    EXPECT_EQ(without_subject("left:tip"), "tip");
    EXPECT_EQ(without_subject("tip"), "tip");
    EXPECT_THAT(find_labels(labels, "left:tip"), ElementsAre(0));
    EXPECT_THAT(find_labels(labels, "tip"), ElementsAre(0, 1)) << "ambiguous";
    EXPECT_THAT(find_labels(labels, "root"), ElementsAre(3)) << "the label itself comes first";
    EXPECT_THAT(find_labels(labels, "c"), ElementsAre(4));
    EXPECT_THAT(find_labels(labels, "ti"), IsEmpty());
}

TEST(MarkerLabels, BecomeUnique) {
    std::vector<std::string> labels{"a", "a", "a (2)", "a"};
    make_unique(labels);
    EXPECT_THAT(labels, ElementsAre("a", "a (2)", "a (2) (2)", "a (3)"));
}

TEST(RecordingUnit, IsThatOfTheFileOrTheDeclaredOne) {
    EXPECT_EQ(*recording_unit("UNITS", "mm", std::nullopt, "f"), 1e-3);
    EXPECT_EQ(*recording_unit("UNITS", "", 1e-2, "f"), 1e-2);
    EXPECT_EQ(*recording_unit("UNITS", "mete", 1.0, "f"), 1.0) << "an unknown word leaves it to the key";
    EXPECT_EQ(*recording_unit("UNITS", "Millimeters", 1e-3, "f"), 1e-3);
    EXPECT_THAT(recording_unit("UNITS", "mete", std::nullopt, "f").error().text(),
                HasSubstr("f: UNITS is 'mete', which is no known unit of length; state the trial's key unit"));
    EXPECT_THAT(recording_unit("UNITS", "m", 1e-3, "f").error().text(), HasSubstr("says mm, but UNITS is 'm'"));
    EXPECT_EQ(unit_word(1.3e-3, 2.0), "mm");
    EXPECT_EQ(unit_word(1.3e-3), "");
}

}  // namespace
}  // namespace myo::measurement
