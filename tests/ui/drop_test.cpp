#include <gtest/gtest.h>

#include "ui/driver.hpp"

namespace myo::ui {
namespace {

using test::Driver;

TEST(Drop, ARecordingIsImportedAndNotOpenedAsAMesh) {
    for (const char* const file : {"/takes/drop.c3d", "/takes/drop.TSV", "/takes/drop.csv"}) {
        Driver driver;
        driver.open_beam();
        const auto scene = driver.state().scene;
        driver.window->drop({file});
        ASSERT_TRUE(driver.wait_for_job());
        EXPECT_FALSE(driver.state().unit_question) << file;
        ASSERT_TRUE(driver.state().import) << file;
        EXPECT_EQ(driver.state().import->file.path, file);
        EXPECT_EQ(driver.state().scene, scene);
    }
}

TEST(Drop, ABodyIsOpenedBeforeTheRecordingThatCameWithIt) {
    Driver driver;
    driver.window->drop({"/takes/drop.c3d", "/takes/again.c3d", "/beam"});
    ASSERT_TRUE(driver.wait_for_job());
    ASSERT_TRUE(driver.state().body);
    ASSERT_TRUE(driver.state().import);
    EXPECT_EQ(driver.state().import->file.path, "/takes/drop.c3d");
    EXPECT_EQ(driver.state().import->choices.markers[2].name, "tip_top") << "it was read with the body in place";
}

TEST(Drop, TheRecordingWaitsForTheUnitOfTheBody) {
    Driver driver;
    driver.window->drop({"/body.stl", "/takes/drop.c3d"});
    driver.settle();
    EXPECT_FALSE(driver.state().busy());
    driver.click("unit/mm");
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_TRUE(driver.state().import);
    // Given up, it is not read with the next body.
    Driver other;
    other.window->drop({"/body.stl", "/takes/drop.c3d"});
    other.settle();
    other.click("unit/cancel");
    other.open_beam();
    EXPECT_FALSE(other.state().import);
}

TEST(Drop, WithoutABodyItSaysWhatIsMissing) {
    Driver driver;
    driver.window->drop({"/takes/drop.c3d"});
    driver.settle();
    ASSERT_FALSE(driver.state().log.empty());
    EXPECT_EQ(driver.state().log.back().level, commands::LogLevel::warning);
    EXPECT_FALSE(driver.state().busy());
}

TEST(Drop, WhileAJobRunsARecordingIsTakenAndABodyIsNot) {
    Driver driver;
    driver.open_beam();
    driver.backend->step_delay_s = 0.005;
    driver.workbench->execute(commands::Run{});
    ASSERT_TRUE(driver.state().busy());
    driver.window->drop({"/body.stl"});
    EXPECT_EQ(driver.state().log.back().level, commands::LogLevel::warning);
    EXPECT_NE(driver.state().log.back().text.find("still running"), std::string::npos);
    EXPECT_FALSE(driver.state().unit_question);
    driver.window->drop({"/takes/drop.c3d"});
    EXPECT_EQ(driver.state().queue.size(), 1u);
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_TRUE(driver.state().run);
    EXPECT_TRUE(driver.state().import);
}

}  // namespace
}  // namespace myo::ui
