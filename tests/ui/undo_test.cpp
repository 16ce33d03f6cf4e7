#include <gtest/gtest.h>

#include "ui/driver.hpp"

namespace myo::ui {
namespace {

using test::Driver;

TEST(Undo, ThatIsRefusedCanBeTriedAgain) {
    Driver driver;
    driver.backend->as_experiment = true;
    driver.open_beam();
    const commands::Settings before = driver.state().settings;
    driver.workbench->execute(
        commands::EditDeclaration{{commands::SetDeclared{{"gravity", "acceleration_m_s2"}, "1.6"}}, "test", false});
    const commands::Settings after = driver.state().settings;
    ASSERT_FALSE(after == before);
    const auto execute_refused = [&](const commands::Command& command) {
        driver.backend->refuses_declarations = true;
        driver.workbench->execute(command);
        driver.backend->refuses_declarations = false;
    };
    execute_refused(commands::Undo{});
    EXPECT_EQ(driver.state().settings, after);
    EXPECT_TRUE(driver.state().can_undo);
    EXPECT_FALSE(driver.state().can_redo);
    driver.workbench->execute(commands::Undo{});
    EXPECT_EQ(driver.state().settings, before);
    execute_refused(commands::Redo{});
    EXPECT_EQ(driver.state().settings, before);
    EXPECT_FALSE(driver.state().can_undo);
    EXPECT_TRUE(driver.state().can_redo);
    driver.workbench->execute(commands::Redo{});
    EXPECT_EQ(driver.state().settings, after);
}

}  // namespace
}  // namespace myo::ui
