#include <gtest/gtest.h>

#include "ui/driver.hpp"

namespace myo::ui {
namespace {

using test::Driver;

TEST(Log, GivesTheOldestLinesUpAndShowsTheNewest) {
    Driver driver;
    driver.open_beam();
    driver.window->show_panel("messages");
    for (int i = 0; i < 5000; ++i)
        driver.workbench->execute(commands::LogMessage{commands::LogLevel::information, "Line " + std::to_string(i)});
    driver.settle();
    const auto& log = driver.state().log;
    EXPECT_LE(log.size(), commands::max_log_lines);
    EXPECT_GT(log.size(), commands::max_log_lines / 2);
    EXPECT_EQ(log.back().text, "Line 4999");
    EXPECT_TRUE(driver.has("messages/line/" + std::to_string(log.size() - 1)));
    EXPECT_FALSE(driver.has("messages/line/0"));
    // One more scrolls it to the foot, though the log is full.
    driver.wheel(driver.item("messages/line/" + std::to_string(log.size() - 1)).center(), 2000.0f);
    EXPECT_TRUE(driver.has("messages/line/0"));
    driver.workbench->execute(commands::LogMessage{commands::LogLevel::information, "The last"});
    driver.settle();
    EXPECT_TRUE(driver.has("messages/line/" + std::to_string(log.size() - 1)));
}

}  // namespace
}  // namespace myo::ui
