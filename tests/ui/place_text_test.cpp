#include <gtest/gtest.h>

#include "commands/place_text.hpp"

namespace myo::ui::commands {
namespace {

TEST(PlaceText, HasNoDigitsOfSinglePrecision) {
    const auto single = [](float value) { return static_cast<double>(value); };
    EXPECT_EQ(place_text({single(0.015f), single(-0.001f), single(0.099f)}), "[0.015, -0.001, 0.099]");
    EXPECT_EQ(place_text({-0.0, 0.0, 1.0}), "[0.0, 0.0, 1.0]");
    EXPECT_EQ(place_text({0.0123456, 0.1, 0.0}), "[0.0123456, 0.1, 0.0]") << "a tenth of a micrometre is kept";
}

}  // namespace
}  // namespace myo::ui::commands
