#include "panels/wrapped_text.hpp"

#include <gtest/gtest.h>

namespace myo::ui {
namespace {

std::string broken(const std::string& text, float width) {
    return panels::broken_at_spaces(text, width,
                                    [](const std::string& line) { return static_cast<float>(line.size()); });
}

TEST(WrappedText, BreaksAtSpacesAndKeepsNumbersWhole) {
    EXPECT_EQ(broken("from 0.13 to 0.0986 mm", 16.0f), "from 0.13 to\n0.0986 mm");
    EXPECT_EQ(broken("from 0.13 to 0.0986 mm", 22.0f), "from 0.13 to 0.0986 mm");
}

TEST(WrappedText, KeepsItsLinesAndWordsThatAreTooWide) {
    EXPECT_EQ(broken("a\n\nb c", 9.0f), "a\n\nb c");
    EXPECT_EQ(broken("see /a/very/long/path now", 6.0f), "see\n/a/very/long/path\nnow");
    EXPECT_EQ(broken("", 6.0f), "");
}

}  // namespace
}  // namespace myo::ui
