#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "commands/field_store.hpp"
#include "ui/driver.hpp"
#include "viewport/color_map.hpp"

namespace myo::ui {
namespace {

using test::Driver;

/// A beam that has been run, at the end of its trial.
void run_beam(Driver& driver) {
    driver.open_beam();
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    driver.workbench->execute(commands::SetTime{0.4});
    driver.settle();
}

void open_options(Driver& driver) {
    if (!driver.has("view/field")) driver.click("view/options");
}

void choose(Driver& driver, const std::string& field) {
    open_options(driver);
    driver.click("view/field");
    driver.click("view/field/" + field);
    while (driver.window->waits_for_field()) driver.frame();
    driver.settle();
}

TEST(Fields, ColourTheBodyOverTheRangeOfTheTrial) {
    Driver driver;
    ASSERT_NO_FATAL_FAILURE(run_beam(driver));
    EXPECT_FALSE(driver.window->scene().field);
    choose(driver, "height");
    ASSERT_TRUE(driver.window->scene().field);
    const viewport::DrawnField now = *driver.window->scene().field;
    EXPECT_EQ(now.unit, "mm");
    const Eigen::VectorXd
        expected = 1e3 * (driver.window->scene().positions - driver.state().body->mesh.nodes).row(2).transpose();
    EXPECT_NEAR((now.values - expected).cwiseAbs().maxCoeff(), 0.0, 1.0) << "of the nearest frame";
    EXPECT_DOUBLE_EQ(now.lowest, -now.highest) << "even to both sides of zero";
    EXPECT_GE(now.highest, now.values.cwiseAbs().maxCoeff() * 0.98);
    // In time the values change, the colours' meaning does not.
    driver.workbench->execute(commands::SetTime{1.3});
    driver.settle();
    while (driver.window->waits_for_field()) driver.frame();
    driver.settle();
    EXPECT_NE(driver.window->scene().field->values, now.values);
    EXPECT_DOUBLE_EQ(driver.window->scene().field->highest, now.highest);
    choose(driver, "none");
    EXPECT_FALSE(driver.window->scene().field);
}

TEST(Fields, TheRangeCanBeFixedByHandAndIsKeptForEach) {
    Driver driver;
    ASSERT_NO_FATAL_FAILURE(run_beam(driver));
    choose(driver, "height");
    const double reach = driver.window->scene().field->highest;
    open_options(driver);
    driver.click("view/field/fixed");
    EXPECT_NEAR(driver.state().view.field_ranges.at("height")[1], 1e-3 * reach, 1e-9) << "it begins as it is shown";
    commands::ViewOptions view = driver.state().view;
    view.field_ranges["height"] = {-0.002, 0.004};
    driver.workbench->execute(commands::ChangeView{view});
    driver.settle();
    EXPECT_DOUBLE_EQ(driver.window->scene().field->lowest, -2.0);
    EXPECT_DOUBLE_EQ(driver.window->scene().field->highest, 4.0);
    choose(driver, "place");
    EXPECT_NEAR(driver.window->scene().field->lowest, 0.0, 1e-12);
    EXPECT_FALSE(driver.window->scene().field->diverging);
    choose(driver, "height");
    EXPECT_DOUBLE_EQ(driver.window->scene().field->highest, 4.0);
    open_options(driver);
    driver.click("view/field/fixed");
    EXPECT_TRUE(driver.state().view.field_ranges.empty());
}

TEST(Fields, TheColoursOfValuesWithoutASignCanBeChosen) {
    Driver driver;
    ASSERT_NO_FATAL_FAILURE(run_beam(driver));
    choose(driver, "place");
    open_options(driver);
    driver.click("view/color_map");
    driver.click("view/color_map/grey");
    EXPECT_EQ(viewport::color_maps()[static_cast<std::size_t>(driver.window->scene().field->color_map)].id, "grey");
    choose(driver, "height");
    open_options(driver);
    EXPECT_FALSE(driver.has("view/color_map")) << "it has a sign";
}

TEST(Fields, TheResidualForceSaysWhatItNeeds) {
    Driver driver;
    ASSERT_NO_FATAL_FAILURE(run_beam(driver));
    choose(driver, "effect_force");
    EXPECT_TRUE(driver.state().view.field.empty()) << "it cannot be chosen after a run alone";
    const std::vector<commands::FieldKind> kinds = commands::field_kinds(driver.workbench->backend());
    EXPECT_NE(commands::needed_for(kinds.back(), driver.state()).find("Diagnose"), std::string::npos);
    EXPECT_EQ(commands::needed_for(kinds.front(), driver.state()), "");
    const platform::Rectangle view = driver.item("view");
    for (int i = 0; i < 2; ++i) driver.click_at({view.lowest.x + 4.0f, view.highest.y - 4.0f});  // closes the lists
    driver.workbench->execute(commands::Diagnose{});
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_EQ(commands::needed_for(kinds.back(), driver.state()), "");
    choose(driver, "effect_force");
    EXPECT_EQ(driver.state().view.field, "effect_force");
    ASSERT_TRUE(driver.window->scene().field);
    EXPECT_NE(driver.window->scene().field->name.find("Residual force"), std::string::npos);
}

TEST(ColorMap, EachSaysWhatItIsGoodFor) {
    for (const viewport::ColorMap& map : viewport::color_maps()) EXPECT_FALSE(map.explanation.empty()) << map.id;
}

/// Values that take long come from beside the drawing: frames go on meanwhile, with what was known.
TEST(Fields, SlowValuesDoNotHoldTheWindowUp) {
    Driver driver;
    ASSERT_NO_FATAL_FAILURE(run_beam(driver));
    driver.backend->field_delay_s = 0.2;
    commands::ViewOptions view = driver.state().view;
    view.field = "height";
    driver.workbench->execute(commands::ChangeView{view});
    driver.frame();
    driver.frame();
    EXPECT_TRUE(driver.window->waits_for_field());
    EXPECT_FALSE(driver.window->scene().field);
    EXPECT_TRUE(driver.window->must_draw());
    while (!driver.window->scene().field) driver.frame();
    driver.backend->field_delay_s = 0.0;
    while (driver.window->waits_for_field()) driver.frame();
}

/// The window rests once nothing that it shows is being computed.
TEST(Fields, NothingIsAwaitedOfAFieldThatWasGivenUp) {
    Driver driver;
    ASSERT_NO_FATAL_FAILURE(run_beam(driver));
    commands::WorkbenchState state = driver.state();
    const commands::Backend& backend = driver.workbench->backend();
    for (const std::string next : {"", "effect_force"}) {
        commands::FieldStore store;
        const auto update = [&] {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
            return store.update(state, backend);
        };
        driver.backend->field_delay_s = 0.02;
        state.view.field = "height";
        std::shared_ptr<const commands::FieldFrame> shown;
        while (!shown) shown = update();
        ASSERT_FALSE(shown->trial_range) << "it takes far longer";
        state.view.field = next;
        driver.backend->field_delay_s = 0.0;
        for (int i = 0; i < 1000 && (i == 0 || store.waits()); ++i) shown = update();
        EXPECT_FALSE(store.waits()) << next;
        EXPECT_FALSE(shown) << next;
    }
}

TEST(ColorMap, OfSignedValuesIsEquallyLightOnBothSides) {
    for (int i = 0; i <= 20; ++i) {
        const Eigen::Vector3f low = viewport::diverging_color_map(0.5 - i / 40.0),
                              high = viewport::diverging_color_map(0.5 + i / 40.0);
        const Eigen::Vector3f luma{0.2126f, 0.7152f, 0.0722f};
        EXPECT_NEAR(std::sqrt(luma.dot(low.cwiseProduct(low))), std::sqrt(luma.dot(high.cwiseProduct(high))), 0.06)
            << i;
        if (i > 5) {
            EXPECT_GT(low.z(), low.x()) << "blue below";
            EXPECT_GT(high.x(), high.z()) << "red above";
        }
    }
}

}  // namespace
}  // namespace myo::ui
