#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "commands/settings_difference.hpp"
#include "ui/driver.hpp"

// Effects of a mesh alone, which the settings hold. Those of an experiment: tests/workbench/effect_panel_test.cpp.

namespace myo::ui {
namespace {

using test::Driver;
using testing::HasSubstr;

/// The beam with its panel of effects, in a window that shows all of it.
struct EffectWindow {
    Driver driver{1280, 1400};

    EffectWindow() {
        driver.open_beam();
        driver.window->show_panel("effect");
        driver.settle();
    }
    const std::vector<commands::AddedEffect>& effects() const { return driver.state().settings.effects; }
    void add(const std::string& id) {
        driver.click("effect/add");
        driver.settle();
        driver.click("effect/add/" + id);
        driver.settle();
    }
    void type(const std::string& item, const std::string& text) {
        driver.double_click(item);
        driver.key(ImGuiKey_A, {.ctrl = true});
        driver.type(text);
        driver.key(ImGuiKey_Enter);
    }
};

TEST(EffectPanel, FindsAnEffectByItsWordsAndAddsIt) {
    EffectWindow window;
    Driver& driver = window.driver;
    driver.click("effect/add");
    driver.settle();
    EXPECT_TRUE(driver.has("effect/add/linear_drag"));
    driver.click("effect/find");
    driver.type("mass");
    driver.settle();
    EXPECT_FALSE(driver.has("effect/add/linear_drag"));
    driver.click("effect/add/point_mass");
    driver.settle();
    ASSERT_EQ(window.effects().size(), 1u);
    EXPECT_EQ(std::get<double>(window.effects()[0].declaration.parameters.at("mass_kg")), 0.005);
    EXPECT_EQ(window.effects()[0].value, "mass 5 g; position 100, 15, 30 mm");
    EXPECT_FALSE(driver.has("effect/find")) << "the catalogue closes";
    EXPECT_TRUE(driver.has("effect/added/0/mass_kg")) << "the new effect is open";
    driver.workbench->execute(commands::Undo{});
    EXPECT_TRUE(window.effects().empty());
}

TEST(EffectPanel, DoesNotAddWhatCannotAct) {
    EffectWindow window;
    window.add("actuation_lag");
    EXPECT_TRUE(window.effects().empty());
}

TEST(EffectPanel, EditsValuesInTheirUnitsEachAsOneUndoStep) {
    EffectWindow window;
    window.add("point_mass");
    window.type("effect/added/0/mass_kg", "20 g");
    ASSERT_EQ(window.effects().size(), 1u);
    const auto value = [&](const char* key) { return window.effects()[0].declaration.parameters.at(key); };
    EXPECT_EQ(std::get<double>(value("mass_kg")), 0.02);
    window.type("effect/added/0/position_m/x", "5 cm");
    EXPECT_EQ(std::get<Eigen::VectorXd>(value("position_m")), Eigen::VectorXd(Eigen::Vector3d(0.05, 0.015, 0.03)));
    EXPECT_EQ(window.effects()[0].value, "mass 20 g; position 50, 15, 30 mm");
    window.type("effect/added/0/mass_kg", "-1");
    EXPECT_EQ(std::get<double>(value("mass_kg")), 0.02) << "values outside the range of the catalogue are refused";
    window.driver.key(ImGuiKey_Escape);
    window.driver.workbench->execute(commands::Undo{});
    EXPECT_EQ(std::get<Eigen::VectorXd>(value("position_m"))[0], 0.1);
    window.driver.workbench->execute(commands::Undo{});
    EXPECT_EQ(std::get<double>(value("mass_kg")), 0.005);
}

/// Angles in degrees are plain numbers with the unit in the label: fields count angles in radians.
TEST(EffectPanel, KeepsDegrees) {
    EffectWindow window;
    window.add("gravity_tilt");
    window.type("effect/added/0/tilt_deg", "7");
    ASSERT_EQ(window.effects().size(), 1u);
    EXPECT_EQ(std::get<double>(window.effects()[0].declaration.parameters.at("tilt_deg")), 7.0);
}

TEST(EffectPanel, SwitchesAnEffectOffAndKeepsItsValues) {
    EffectWindow window;
    window.add("linear_drag");
    const commands::Settings with = window.driver.state().settings;
    window.driver.click("effect/added/0/on");
    ASSERT_EQ(window.effects().size(), 1u);
    EXPECT_TRUE(window.effects()[0].off);
    EXPECT_EQ(window.effects()[0].declaration, with.effects[0].declaration);
    const std::vector<commands::SettingDifference> rows = commands::settings_differences(
        {&with, &window.driver.state().settings}, {}, {});
    ASSERT_EQ(rows.size(), 1u);
    EXPECT_THAT(rows[0].values[1], HasSubstr("(off)"));
    window.driver.workbench->execute(commands::Undo{});
    EXPECT_EQ(window.driver.state().settings, with);
    window.driver.click("effect/added/0/remove");
    EXPECT_TRUE(window.effects().empty());
}

TEST(SwitchedOff, FollowsTheDeclarationAndDropsWhatIsRemoved) {
    const std::vector<effect::EffectDeclaration> declared{{"a", {}}, {"b", {}}, {"c", {}}};
    std::vector<commands::SwitchedOff> off = commands::switched({}, {2, "c"}, false);
    off = commands::switched(off, {0, "a"}, false);
    EXPECT_EQ(off, (std::vector<commands::SwitchedOff>{{0, "a"}, {2, "c"}}));
    ASSERT_EQ(commands::effects_on(declared, off).size(), 1u);
    EXPECT_EQ(commands::effects_on(declared, off)[0].id, "b");
    const std::vector<commands::SwitchedOff> moved = commands::moved_by(
        off, {commands::RemoveDeclared{{"effect", std::size_t{0}}}});
    EXPECT_EQ(moved, (std::vector<commands::SwitchedOff>{{1, "c"}}));
    EXPECT_EQ(commands::moved_by(off, {commands::RemoveDeclared{{"effect", std::size_t{0}, "trial"}},
                                       commands::RemoveDeclared{{"trial", std::size_t{0}}}}),
              off)
        << "a removed key or another table moves nothing";
    EXPECT_FALSE(commands::is_off({{1, "a"}}, declared, 1)) << "another effect stands there now";
    EXPECT_TRUE(commands::switched(moved, {1, "c"}, true).empty());
}

}  // namespace
}  // namespace myo::ui
