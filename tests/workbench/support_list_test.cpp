#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "workbench/opened_beam.hpp"

// Supports besides the clamp: added, held along some axes, removed in the window.

namespace myo {
namespace {

using test::OpenedBeam;
using testing::HasSubstr;
using ui::commands::Undo;

TEST(SupportsInWindow, ASupportUnderTheFreeEndCarriesIt) {
    OpenedBeam beam("support_list");
    beam.keep_step();
    ASSERT_NO_FATAL_FAILURE(beam.run());
    const double falls = beam.last_height_m();
    beam.driver.window->show_panel("support");
    beam.driver.settle();
    beam.driver.click("support/more/add");
    ASSERT_EQ(beam.driver.state().scene->supports.size(), 1u) << beam.driver.state().refused;
    EXPECT_EQ(beam.driver.state().view.edited, "support/more/0") << "what was added is open";
    EXPECT_FALSE(beam.driver.state().mesh_is_current()) << "the mesh meets the box";
    const std::size_t lines = beam.driver.window->scene().lines.size();
    beam.driver.settle();
    beam.driver.click("support/more/0/x");
    EXPECT_EQ(beam.driver.state().scene->supports[0].held, (std::array<bool, 3>{false, true, true}))
        << beam.driver.state().refused;
    EXPECT_LT(beam.driver.window->scene().lines.size(), lines) << "the bar along x is gone";
    beam.driver.workbench->execute(ui::commands::BuildMesh{});
    ASSERT_TRUE(beam.driver.wait_for_job(60));
    ASSERT_NO_FATAL_FAILURE(beam.run());
    EXPECT_GT(beam.last_height_m(), falls + 0.002);
    beam.driver.window->show_panel("support");
    beam.driver.settle();
    beam.driver.click("support/save");
    EXPECT_THAT(beam.text(), HasSubstr("held = [\"y\", \"z\"]"));
    beam.driver.workbench->execute(Undo{});
    EXPECT_EQ(beam.driver.state().scene->supports[0].held, (std::array<bool, 3>{true, true, true}));
    beam.driver.window->show_panel("support");
    beam.driver.settle();
    beam.driver.click("support/more/0/remove");
    EXPECT_TRUE(beam.driver.state().scene->supports.empty());
}

TEST(SupportsInWindow, TheLastAxisStays) {
    OpenedBeam beam("support_last_axis");
    beam.driver.window->show_panel("support");
    beam.driver.settle();
    beam.driver.click("support/more/add");
    beam.driver.settle();
    for (const char* axis : {"x", "y", "z"}) {
        beam.driver.click(std::string("support/more/0/") + axis);
        beam.driver.settle();
    }
    EXPECT_EQ(beam.driver.state().scene->supports[0].held, (std::array<bool, 3>{false, false, true}));
    EXPECT_THAT(beam.driver.state().refused, HasSubstr("names no axis"));
}

}  // namespace
}  // namespace myo
