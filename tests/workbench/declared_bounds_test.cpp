#include <gtest/gtest.h>

#include "workbench/opened_beam.hpp"

// Bounds and tolerances of unknown values, edited in rows.

namespace myo {
namespace {

using test::Driver;
using test::OpenedBeam;

void set_number(Driver& driver, const std::string& item, const std::string& text) {
    driver.double_click(item);
    driver.key(ImGuiKey_A, {.ctrl = true});
    driver.type(text);
    driver.key(ImGuiKey_Enter);
    driver.settle();
}

TEST(BoundsInWindow, AValueGetsBoundsAndATolerance) {
    OpenedBeam beam("bounds");
    Driver& driver = beam.driver;
    const auto modulus = [&]() { return driver.state().scene->fitted.at(0); };
    ASSERT_EQ(modulus().name, "youngs_modulus_Pa");
    const double usual = modulus().highest;
    driver.window->show_panel("unknown");
    driver.settle();
    const std::string item = "unknown/bounds/youngs_modulus_Pa";
    driver.click(item + "/kind");
    driver.click(item + "/kind/bounds");
    driver.settle();
    ASSERT_TRUE(modulus().declared_highest) << driver.state().refused;
    EXPECT_NEAR(modulus().highest, usual, 1e-6 * usual) << "begins with the usual bounds";
    set_number(driver, item + "/highest", "1 MPa");
    EXPECT_NEAR(modulus().highest, 1e6, 1e-6);
    driver.click(item + "/kind");
    driver.click(item + "/kind/tolerance");
    driver.settle();
    ASSERT_TRUE(modulus().declared_tolerance) << driver.state().refused;
    set_number(driver, item + "/tolerance", "20 kPa");
    EXPECT_NEAR(modulus().highest - modulus().lowest, 40e3, 1e-3);
    driver.click(item + "/kind");
    driver.click(item + "/kind/usual");
    driver.settle();
    EXPECT_EQ(modulus().declared, -1);
    EXPECT_NEAR(modulus().highest, usual, 1e-6 * usual);
}

}  // namespace
}  // namespace myo
