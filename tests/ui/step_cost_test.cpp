#include <gtest/gtest.h>

#include "commands/step_cost.hpp"
#include "ui/driver.hpp"

namespace myo::ui {
namespace {

using test::Driver;

TEST(StepCost, IsForetoldFromTheBenchmarkAndThenFromRuns) {
    Driver driver;
    driver.open_beam();
    driver.click("task/mesh");
    EXPECT_TRUE(driver.has("body/step_cost"));
    const std::vector<commands::StepCost>& costs = driver.state().preferences.step_costs;
    EXPECT_TRUE(costs.empty());
    // Before any run the documented benchmark tells.
    EXPECT_FALSE(commands::predict_step(costs, mesh::CellType::hex8, 4608.0).measured);
    EXPECT_NEAR(commands::predict_step(costs, mesh::CellType::hex8, 4608.0).seconds, 6.8e-3, 1e-12);
    EXPECT_NEAR(commands::predict_step(costs, mesh::CellType::hex8, 1080.0).seconds, 1.6e-3, 1e-5)
        << "small ones cost in proportion";
    EXPECT_NEAR(commands::predict_step(costs, mesh::CellType::tet10, 4.0 * 4608.0).seconds, 8.0 * 6.8e-3, 1e-9);
    driver.workbench->execute(commands::Run{});
    ASSERT_TRUE(driver.wait_for_job());
    ASSERT_EQ(costs.size(), 1u);
    const commands::StepCost cost = costs.front();
    EXPECT_TRUE(commands::predict_step(costs, cost.element, cost.dofs).measured);
    EXPECT_NEAR(cost.seconds, 1.3 / 200.0, 1e-12);
    EXPECT_EQ(cost.dofs, driver.state().body->dofs);
    EXPECT_NEAR(commands::predict_step({cost}, cost.element, 4.0 * cost.dofs).seconds, 8.0 * cost.seconds, 1e-9);
    // Runs of two sizes tell the exponent.
    const commands::StepPrediction fitted = commands::predict_step(
        {{cost.element, 2.0 * cost.dofs, 2.0 * cost.seconds}, cost}, cost.element, 4.0 * cost.dofs);
    EXPECT_TRUE(fitted.fitted);
    EXPECT_NEAR(fitted.seconds, 4.0 * cost.seconds, 1e-9);
    driver.open_beam();
    EXPECT_EQ(costs.size(), 1u) << "they are the machine's, whatever is opened";
}

}  // namespace
}  // namespace myo::ui
