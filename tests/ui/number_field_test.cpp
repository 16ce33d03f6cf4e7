#include <gtest/gtest.h>
#include <imgui_internal.h>

#include "ui/driver.hpp"

// Typing into number fields. What they accept is in typed_quantity_test.cpp.

namespace myo::ui {
namespace {

using test::Driver;

class NumberFields : public ::testing::Test {
protected:
    NumberFields() { driver.open_beam(); }

    double modulus() const { return driver.state().settings.youngs_modulus_Pa; }
    /// Opens a field and replaces its text.
    void type_into(const std::string& name, const std::string& text) {
        driver.double_click(name);
        replace(text);
    }
    void replace(const std::string& text) {
        driver.key(ImGuiKey_A, {.ctrl = true});
        driver.type(text);
    }
    /// Text of the field that has the keyboard.
    std::string typed() {
        const ImGuiInputTextState& state = ImGui::GetCurrentContext()->InputTextState;
        return ImGui::GetActiveID() == state.ID ? std::string(state.TextA.begin()) : "no field";
    }
    /// The sentence that is shown beside a field.
    std::string sentence(const std::string& name) {
        for (const auto& [item, place] : driver.window->items().all())
            if (item.rfind(name + ": ", 0) == 0) return item.substr(name.size() + 2);
        return "";
    }
    bool is_red(const std::string& name) {
        const platform::Rectangle place = driver.item(name);
        const ImVec2 frame{place.lowest.x + 0.5f * place.width(), place.lowest.y};
        const platform::Theme theme = platform::make_theme(platform::ThemeName::dark, 1.0f);
        return test::color_near(driver.picture(), frame, theme.failure, 1);
    }
    int undo_count() {
        int count = 0;
        for (; driver.state().can_undo && count < 100; ++count) driver.workbench->execute(commands::Undo{});
        for (int i = 0; i < count; ++i) driver.workbench->execute(commands::Redo{});
        return count;
    }

    Driver driver;
    const std::string field = "model/youngs_modulus";
};

TEST_F(NumberFields, ATextWithAUnitIsOneEdit) {
    type_into(field, "1,5 MPa");
    EXPECT_NE(modulus(), 1.5e6) << "not before it is tried";
    driver.key(ImGuiKey_Enter);
    EXPECT_EQ(modulus(), 1.5e6);
    EXPECT_EQ(undo_count(), 1);
    EXPECT_EQ(sentence(field), "");
    EXPECT_FALSE(is_red(field));
    // The text that it opens with is the whole value.
    driver.double_click(field);
    EXPECT_EQ(typed(), "1500 kPa");
}

TEST_F(NumberFields, WhatIsRefusedStaysRedUntilItIsCorrected) {
    const double before = modulus();
    type_into(field, "abc");
    EXPECT_EQ(sentence(field), "") << "not while it is typed for the first time";
    driver.key(ImGuiKey_Enter);
    EXPECT_EQ(modulus(), before);
    EXPECT_EQ(sentence(field), "'abc' is not a number");
    EXPECT_TRUE(is_red(field));
    EXPECT_EQ(typed(), "abc") << "it can be corrected at once";
    replace("9 GPa");
    EXPECT_EQ(sentence(field), "9 GPa is above the highest Young's modulus, 1000000 kPa");
    driver.key(ImGuiKey_Tab);
    EXPECT_EQ(modulus(), before);
    EXPECT_TRUE(is_red(field));
    EXPECT_EQ(sentence(field), "9 GPa is above the highest Young's modulus, 1000000 kPa");
    EXPECT_EQ(undo_count(), 0);
    // Tab went on to the next field, which can be filled.
    EXPECT_EQ(typed(), "0.49");
    replace("48 %");
    driver.key(ImGuiKey_Enter);
    EXPECT_EQ(driver.state().settings.poissons_ratio, 0.48);
    EXPECT_EQ(undo_count(), 1);
    EXPECT_TRUE(is_red(field));
    // One click opens the text that was kept.
    driver.click(field);
    EXPECT_EQ(typed(), "9 GPa");
    replace("0,9 GPa");
    EXPECT_EQ(sentence(field), "");
    EXPECT_FALSE(is_red(field)) << "it would be accepted now";
    driver.key(ImGuiKey_Enter);
    EXPECT_EQ(modulus(), 9e8);
    EXPECT_EQ(undo_count(), 2);
}

TEST_F(NumberFields, EscapeRestoresTheValue) {
    const double before = modulus();
    type_into(field, "1 MPa");
    driver.key(ImGuiKey_Escape);
    EXPECT_EQ(modulus(), before);
    type_into(field, "abc");
    driver.key(ImGuiKey_Tab);
    EXPECT_TRUE(is_red(field));
    driver.click(field);
    driver.key(ImGuiKey_Escape);
    EXPECT_FALSE(is_red(field));
    EXPECT_EQ(sentence(field), "");
    driver.double_click(field);
    EXPECT_NE(typed(), "abc");
    EXPECT_EQ(modulus(), before);
    EXPECT_EQ(undo_count(), 0);
}

TEST_F(NumberFields, LeavingTriesTheTextAndKeepsAnUntouchedValue) {
    const double before = modulus();
    driver.double_click(field);
    driver.click("panel/material");
    EXPECT_EQ(modulus(), before);
    EXPECT_FALSE(driver.state().can_undo);
    type_into(field, "400");
    driver.click("panel/material");
    EXPECT_EQ(modulus(), 4e5);
    type_into(field, "4oo kPa");
    driver.click("panel/material");
    EXPECT_EQ(modulus(), 4e5);
    EXPECT_EQ(sentence(field), "'4oo kPa' is not a number");
    // Another value from elsewhere ends the attempt.
    driver.click("bar/undo");
    EXPECT_EQ(modulus(), before);
    EXPECT_EQ(sentence(field), "");
    EXPECT_FALSE(is_red(field));
}

TEST_F(NumberFields, CtrlAndAClickOpensAndADragStaysWithinTheLimits) {
    const ImVec2 at = driver.item("model/poissons_ratio").center();
    driver.window->input().push(platform::MouseMoved{at.x, at.y});
    for (const bool down : {true, false}) driver.window->input().push(platform::MouseButton{0, down, {.ctrl = true}});
    driver.settle();
    EXPECT_EQ(typed(), "0.49");
    driver.key(ImGuiKey_Escape);
    driver.frame(1.0);  // the next press is no double click
    driver.drag(at, {at.x + 300.0f, at.y});
    EXPECT_EQ(driver.state().settings.poissons_ratio, commands::poissons_ratio_limits.highest);
    EXPECT_EQ(undo_count(), 1);
}

/// Rows below a refused field stay where they are, and its sentence is within the window, beside the panel.
TEST_F(NumberFields, ASentenceMovesAndCoversNothing) {
    const platform::Rectangle below = driver.item("model/density"), own = driver.item(field);
    type_into(field, "9 GPa");
    driver.key(ImGuiKey_Enter);
    EXPECT_EQ(driver.item("model/density").lowest.y, below.lowest.y);
    EXPECT_EQ(driver.item(field).lowest.y, own.lowest.y);
    EXPECT_EQ(driver.item(field).highest.y, own.highest.y);
    const platform::Rectangle shown = driver.item(field + ": " + sentence(field));
    EXPECT_GT(shown.lowest.x, own.highest.x);
    EXPECT_LT(shown.highest.x, static_cast<float>(driver.width));
    EXPECT_LT(shown.lowest.y, own.highest.y);
}

TEST_F(NumberFields, EscapeInAFieldLeavesItsDialogOpen) {
    driver.key(ui::platform::key_k, {.ctrl = true});
    driver.type("save picture");
    driver.key(ImGuiKey_Enter);
    driver.settle();
    ASSERT_TRUE(driver.has("picture/size"));
    driver.click("picture/size");
    driver.click("picture/size/other");
    type_into("picture/width", "10");
    driver.key(ImGuiKey_Enter);
    EXPECT_EQ(sentence("picture/width"), "10 is below the lowest width, 64");
    driver.key(ImGuiKey_Escape);
    EXPECT_EQ(sentence("picture/width"), "");
    EXPECT_TRUE(driver.has("picture/size"));
    driver.key(ImGuiKey_Escape);
    EXPECT_FALSE(driver.has("picture/size"));
}

TEST_F(NumberFields, TheFrequencyOfTheDampingIsAFieldLikeOthers) {
    driver.click("task/run");
    driver.click("model/integrator");
    driver.click("model/integrator/implicit_euler");
    type_into("model/damping_frequency", "-3");
    driver.key(ImGuiKey_Enter);
    EXPECT_EQ(driver.state().damping_frequency_Hz, 7.75);
    EXPECT_EQ(sentence("model/damping_frequency"), "-3 is below the lowest frequency, 0.01 Hz");
    replace("0,02 kHz");
    driver.key(ImGuiKey_Enter);
    EXPECT_EQ(driver.state().damping_frequency_Hz, 20.0);
}

}  // namespace
}  // namespace myo::ui
