#include "commands/window_title.hpp"

#include <gtest/gtest.h>

#include "platform/input_queue.hpp"
#include "ui/driver.hpp"

namespace myo {
namespace {

using test::Driver;
using ui::commands::window_title;

TEST(WindowTitle, NamesWhatIsOpenAndMarksWhatIsUnsaved) {
    Driver driver;
    EXPECT_EQ(window_title(driver.state()), "Myoloop");
    driver.open_beam();
    const std::string name = driver.state().scene->name;
    EXPECT_EQ(window_title(driver.state()), name + " \xe2\x80\x93 Myoloop");
    ui::commands::Settings settings = driver.state().settings;
    settings.youngs_modulus_Pa *= 2.0;
    driver.workbench->execute(ui::commands::ChangeSettings{settings, "modulus"});
    EXPECT_EQ(window_title(driver.state()), "\xe2\x80\xa2 " + name + " \xe2\x80\x93 Myoloop");
    driver.workbench->execute(ui::commands::SaveAs{"/kept/arm.myoloop"});
    EXPECT_EQ(window_title(driver.state()), "arm \xe2\x80\x93 Myoloop");
}

TEST(Look, SmallerAndLargerGoThroughRoundScales) {
    Driver driver;
    driver.open_beam();
    driver.workbench->execute(ui::commands::SetTheme{driver.state().preferences.theme, 1.0f});
    const auto press = [&](int key) {
        driver.key(key, {.ctrl = true});
        return driver.state().scale();
    };
    EXPECT_FLOAT_EQ(press(ui::platform::key_minus), 0.9f);
    EXPECT_FLOAT_EQ(press(ui::platform::key_minus), 0.75f);
    EXPECT_FLOAT_EQ(press(ui::platform::key_minus), 0.75f);
}

TEST(AnotherBody, BeginsWithItsFirstTask) {
    Driver driver;
    driver.open_beam();
    driver.window->show_panel("live");
    driver.settle();
    EXPECT_EQ(driver.window->task(), ui::commands::Task::run);
    driver.window->open("/beam");
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_EQ(driver.window->task(), ui::commands::Task::run) << "the same one, read again";
    driver.window->open("/other beam");
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_EQ(driver.window->task(), ui::commands::Task::body);
}

}  // namespace
}  // namespace myo
