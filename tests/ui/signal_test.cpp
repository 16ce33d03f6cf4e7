#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "panels/signal_panel.hpp"
#include "support/folder.hpp"
#include "ui/driver.hpp"

namespace myo::ui {
namespace {

using test::Driver;

TEST(SignalShapes, AreWhatTheirNamesSay) {
    commands::SignalRecipe recipe;
    recipe.level = 0.7;
    recipe.start_s = 0.5;
    recipe.rise_s = 1.0;
    EXPECT_DOUBLE_EQ(commands::make_signal(recipe).value(1.0), 0.85);
    EXPECT_EQ(commands::make_signal(recipe).value(0.4), 1.0);
    EXPECT_EQ(commands::make_signal(recipe).value(9.0), 0.7);
    recipe.shape = commands::SignalShape::step;
    EXPECT_EQ(commands::make_signal(recipe).value(0.5), 1.0);
    EXPECT_EQ(commands::make_signal(recipe).value(0.502), 0.7);
    recipe.shape = commands::SignalShape::constant;
    EXPECT_EQ(commands::make_signal(recipe).value(-3.0), 0.7);
    recipe.shape = commands::SignalShape::sine;
    recipe.frequency_Hz = 3.0;
    const fibre::Signal sine = commands::make_signal(recipe);
    for (double t = 0.5; t < 2.0; t += 0.013)
        EXPECT_NEAR(sine.value(t), 1.0 - 0.15 * (1.0 - std::cos(6.0 * std::numbers::pi * (t - 0.5))), 0.3 * 0.005) << t;
    for (std::size_t k = 1; k < sine.times_s.size(); ++k) EXPECT_GT(sine.times_s[k], sine.times_s[k - 1]);
}

TEST(SignalShapes, KnotsStayInOrder) {
    const fibre::Signal signal{{0.0, 1.0, 2.0}, {1.0, 0.8, 1.0}};
    EXPECT_NEAR(commands::with_knot_moved(signal, 1, 5.0, 0.7).times_s[1], 2.0, 1.01e-4);
    EXPECT_NEAR(commands::with_knot_moved(signal, 1, -5.0, 0.7).times_s[1], 0.0, 1.01e-4);
    const fibre::Signal added = commands::with_knot_added(signal, 1.5, 0.6);
    EXPECT_EQ(added.times_s, (std::vector<double>{0.0, 1.0, 1.5, 2.0}));
    EXPECT_EQ(added.values[2], 0.6);
    EXPECT_EQ(commands::with_knot_added(signal, 1.0, 0.6), signal) << "two knots at one time would be a jump";
    EXPECT_EQ(commands::with_knot_removed(added, 2), signal);
    EXPECT_EQ(commands::with_knot_removed(fibre::Signal::constant(1.0), 0), fibre::Signal::constant(1.0));
}

class SignalPanelTest : public testing::Test {
protected:
    void SetUp() override {
        driver.open_beam();
        driver.window->show_panel("fibres");
        driver.settle();
        driver.click("fibres/add");
        driver.window->show_panel("signals");
        driver.settle();
    }
    const fibre::Signal& signal() const { return *driver.state().settings.muscles[0].signal; }

    Driver driver{1280, 900};
};

TEST_F(SignalPanelTest, AKnotIsDraggedInOneStepOfUndo) {
    const fibre::Signal before = signal();
    ASSERT_EQ(before.times_s.size(), 2u);
    const ImVec2 knot = driver.item("signals/knot/1").center();
    driver.drag(knot, {knot.x + 80.0f, knot.y - 30.0f});
    EXPECT_GT(signal().times_s[1], before.times_s[1] + 0.05);
    EXPECT_GT(signal().values[1], before.values[1] + 0.01);
    EXPECT_EQ(signal().values[0], before.values[0]);
    driver.key(ImGuiKey_Z, {.ctrl = true});
    EXPECT_EQ(signal(), before);
}

TEST_F(SignalPanelTest, ADoubleClickAddsAKnotAndItsMenuTakesIt) {
    const ImVec2 knot = driver.item("signals/knot/1").center();
    const ImVec2 place{knot.x + 150.0f, knot.y - 20.0f};
    driver.window->input().push(platform::MouseMoved{place.x, place.y});
    for (const bool down : {true, false, true, false}) driver.window->input().push(platform::MouseButton{0, down, {}});
    driver.settle();
    ASSERT_EQ(signal().times_s.size(), 3u);
    EXPECT_GT(signal().times_s[2], signal().times_s[1]);
    driver.click("signals/knot/2", 1);
    driver.click("signals/menu/remove");
    EXPECT_EQ(signal().times_s.size(), 2u);
    driver.key(ImGuiKey_Z, {.ctrl = true});
    ASSERT_EQ(signal().times_s.size(), 3u);
    driver.click("signals/knot/2");
    driver.key(ImGuiKey_Delete);
    EXPECT_EQ(signal().times_s.size(), 2u);
}

TEST_F(SignalPanelTest, ABoxThatEndsOnAKnotTakesNone) {
    const fibre::Signal before = signal();
    const ImVec2 knot = driver.item("signals/knot/1").center();
    driver.drag({knot.x - 60.0f, knot.y - 60.0f}, knot, 1);
    EXPECT_EQ(signal(), before);
    EXPECT_GT(driver.item("signals/knot/1").center().x, knot.x + 60.0f) << "it zooms instead";
}

TEST_F(SignalPanelTest, ADragBesideTheKnotsMovesTheView) {
    const fibre::Signal before = signal();
    for (const int button : {0, 2}) {
        const ImVec2 knot = driver.item("signals/knot/1").center();
        const ImVec2 beside{knot.x + 100.0f, knot.y - 40.0f};
        driver.drag(beside, {beside.x - 30.0f, beside.y + 12.0f}, button);
        const ImVec2 moved = driver.item("signals/knot/1").center();
        EXPECT_NEAR(moved.x, knot.x - 30.0f, 8.0f) << button;
        EXPECT_NEAR(moved.y, knot.y + 12.0f, 4.0f) << button;
    }
    EXPECT_EQ(signal(), before);
}

TEST_F(SignalPanelTest, GeneratesASine) {
    driver.click("signals/generate");
    driver.click("signals/shape");
    driver.click("signals/shape/sine");
    driver.click("signals/use");
    EXPECT_EQ(signal().times_s.size(), 65u);  // two swings
    EXPECT_NEAR(*std::min_element(signal().values.begin(), signal().values.end()), 0.8, 1e-12);
}

TEST_F(SignalPanelTest, GoesToAFileAndBack) {
    const fibre::Signal before = signal();
    driver.workbench->execute(commands::ExportSignal{"muscle 1", before, "/signals/one.csv"});
    driver.click("signals/generate");
    driver.click("signals/use");
    driver.workbench->execute(commands::ImportSignal{0, "/signals/one.csv"});
    EXPECT_EQ(signal(), before);
    driver.workbench->execute(commands::ImportSignal{0, "/signals/none.csv"});
    EXPECT_EQ(driver.state().log.back().level, commands::LogLevel::failure);
    EXPECT_EQ(signal(), before);
}

TEST_F(SignalPanelTest, FilesAreChosenInTheBrowser) {
    const test::Folder folder("signals");
    const fibre::Signal before = signal();
    const auto go_to = [&](const std::filesystem::path& path) {
        driver.double_click("browser/path");
        driver.key(ImGuiKey_A, {.ctrl = true});
        driver.type(path.string());
        driver.key(ImGuiKey_Enter);
    };
    driver.click("signals/file");
    driver.click("signals/export");
    go_to(folder.path());
    driver.click("browser/open");
    const std::filesystem::path file = folder.path() / "muscle 1.csv";
    ASSERT_EQ(driver.backend->signals.count(file), 1u) << "under the muscle's name";
    EXPECT_EQ(driver.backend->signals[file], before);
    folder.write("muscle 1.csv", "");  // the list shows what is on the disk
    folder.write("notes.md", "");
    driver.click("signals/generate");
    driver.click("signals/shape");
    driver.click("signals/shape/sine");
    driver.click("signals/use");
    ASSERT_NE(signal(), before);
    driver.click("signals/file");
    driver.click("signals/import");
    go_to(folder.path());
    EXPECT_FALSE(driver.has("browser/entry/notes.md"));
    driver.click("browser/entry/muscle 1.csv");
    driver.click("browser/open");
    EXPECT_EQ(signal(), before);
    // What is there is replaced only after it was said, and Cancel leaves it.
    driver.backend->signals[file] = fibre::Signal::constant(0.5);
    driver.click("signals/file");
    driver.click("signals/export");
    go_to(folder.path());
    EXPECT_TRUE(driver.has("browser/is_there"));
    driver.click("browser/cancel");
    EXPECT_EQ(driver.backend->signals[file], fibre::Signal::constant(0.5));
}

TEST_F(SignalPanelTest, AnAntagonistFollows) {
    commands::Settings settings = driver.state().settings;
    commands::Muscle other = settings.muscles[0];
    other.name = "other";
    other.follows = "muscle 1";
    other.ratio = -0.5;
    settings.muscles.push_back(other);
    driver.workbench->execute(commands::ChangeSettings{settings, "two", false});
    const fibre::Signal follower = commands::signal_of(driver.state(), driver.state().settings.muscles[1]);
    EXPECT_DOUBLE_EQ(follower.value(10.0), 1.1) << "half as far the other way as 0.8";
    driver.workbench->execute(commands::ChooseMuscle{1});
    driver.settle();
    EXPECT_FALSE(driver.has("signals/generate")) << "it has no signal of its own to edit";
}

}  // namespace
}  // namespace myo::ui
