#include "measurement/units.hpp"

#include <gtest/gtest.h>

#include <string>

namespace myo::measurement {
namespace {

/// Exact by definition: 1 in = 25.4 mm, 1 ft = 12 in.
TEST(MetresPerUnit, AreThoseOfTheirDefinition) {
    for (const char* name : {"m", "meter", "meters", "metre", "metres"}) EXPECT_EQ(metres_per_unit(name), 1.0) << name;
    for (const char* name : {"dm"}) EXPECT_EQ(metres_per_unit(name), 0.1) << name;
    for (const char* name : {"cm", "centimeter", "centimetres"}) EXPECT_EQ(metres_per_unit(name), 0.01) << name;
    for (const char* name : {"mm", "millimeter", "millimetres"}) EXPECT_EQ(metres_per_unit(name), 1e-3) << name;
    for (const char* name : {"um", "µm"}) EXPECT_EQ(metres_per_unit(name), 1e-6) << name;
    for (const char* name : {"in", "inch", "inches"}) EXPECT_EQ(metres_per_unit(name), 0.0254) << name;
    for (const char* name : {"ft", "foot", "feet"}) EXPECT_NEAR(*metres_per_unit(name), 12.0 * 0.0254, 1e-16) << name;
}

TEST(MetresPerUnit, IgnoreCaseAndRefuseOtherWords) {
    EXPECT_EQ(metres_per_unit("MM"), 1e-3);
    EXPECT_EQ(metres_per_unit("Metres"), 1.0);
    for (const char* name : {"", "k", "km", "mmm", "m ", "yard", "s"}) EXPECT_FALSE(metres_per_unit(name)) << name;
}

}  // namespace
}  // namespace myo::measurement
