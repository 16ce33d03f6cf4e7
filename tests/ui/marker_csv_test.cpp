#include <gtest/gtest.h>

#include <sstream>

#include "base/files.hpp"
#include "base/text.hpp"
#include "commands/marker_csv.hpp"
#include "ui/driver.hpp"

namespace myo::ui {
namespace {

using test::Driver;

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::vector<double> numbers_of(const std::string& line) {
    std::vector<double> numbers;
    std::istringstream stream(line);
    for (std::string field; std::getline(stream, field, ',');)
        EXPECT_TRUE(parse_number(field, numbers.emplace_back())) << field;
    return numbers;
}

TEST(MarkerCsv, HoldsTheCurvesOfTheRangeAndOfComparedRuns) {
    auto scene = std::make_shared<commands::Scene>();
    scene->markers = {{"tip", {}}};
    scene->trials = {{"pull", "fit", Eigen::Vector4d(0.0, 0.1, 0.2, 0.3), {Eigen::Matrix3Xd::Constant(3, 4, 1e-3)}}};
    scene->trials[0].measured[0].col(2).setConstant(std::numeric_limits<double>::quiet_NaN());
    const auto shown = std::make_shared<commands::RunResult>(), other = std::make_shared<commands::RunResult>();
    shown->trials.resize(1);
    shown->trials[0].markers = {Eigen::Matrix3Xd::Constant(3, 4, 4e-3)};
    other->trials.resize(1);
    other->trials[0].markers = {Eigen::Matrix3Xd::Constant(3, 4, 7e-3)};
    commands::WorkbenchState state;
    state.scene = scene;
    state.run = shown;
    commands::JobRecord record;
    record.name = "Run, \"soft\"";
    record.clock = "14:05:09";
    record.run = other;
    state.history = {record};
    EXPECT_EQ(numbers_of(lines_of(commands::marker_curves_csv(state, 0.0, 1.0)).at(1)).size(), 10u)
        << "a run that is not compared is left out";
    state.history[0].compared = true;
    const std::vector<std::string> lines = lines_of(commands::marker_curves_csv(state, 0.05, 0.25));
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(lines[0].substr(0, 60), "time_s,measured_x_m,measured_y_m,measured_z_m,simulated_x_m,");
    EXPECT_NE(lines[0].find(",\"Run, \"\"soft\"\" 14:05:09_x_m\","), std::string::npos) << lines[0];
    EXPECT_EQ(numbers_of(lines[1]),
              (std::vector<double>{0.1, 1e-3, 1e-3, 1e-3, 4e-3, 4e-3, 4e-3, 3e-3, 3e-3, 3e-3, 7e-3, 7e-3, 7e-3}));
    const std::vector<double> occluded = numbers_of(lines[2]);
    EXPECT_TRUE(std::isnan(occluded.at(1)) && std::isnan(occluded.at(7)));
    EXPECT_EQ(occluded.at(4), 4e-3);
}

TEST(MarkerCsv, HoldsAnotherTrialAtItsOwnTimes) {
    auto scene = std::make_shared<commands::Scene>();
    scene->markers = {{"tip", {}}};
    scene->trials = {{"pull", "fit", Eigen::Vector2d(0.0, 0.1), {Eigen::Matrix3Xd::Constant(3, 2, 1e-3)}},
                     {"drop", "validate", Eigen::Vector3d(0.0, 0.05, 0.2), {Eigen::Matrix3Xd::Constant(3, 3, 2e-3)}}};
    const auto run = std::make_shared<commands::RunResult>();
    run->trials.resize(2);
    run->trials[0].markers = {Eigen::Matrix3Xd::Constant(3, 2, 4e-3)};
    run->trials[1].markers = {Eigen::Matrix3Xd::Constant(3, 3, 7e-3)};
    commands::WorkbenchState state;
    state.scene = scene;
    state.run = run;
    EXPECT_EQ(lines_of(commands::marker_curves_csv(state, -1.0, 1.0, {0})).size(), 3u)
        << "the shown trial is not laid over itself";
    const std::vector<std::string> lines = lines_of(commands::marker_curves_csv(state, -1.0, 1.0, {0, 1}));
    ASSERT_EQ(lines.size(), 5u) << "0, 0.05, 0.1 and 0.2 s";
    EXPECT_NE(lines[0].find(",drop_simulated_x_m,"), std::string::npos) << lines[0];
    EXPECT_EQ(numbers_of(lines[1]), (std::vector<double>{0.0, 1e-3, 1e-3, 1e-3, 4e-3, 4e-3, 4e-3, 3e-3, 3e-3, 3e-3,
                                                         2e-3, 2e-3, 2e-3, 7e-3, 7e-3, 7e-3, 5e-3, 5e-3, 5e-3}));
    const std::vector<double> only_drop = numbers_of(lines[4]), only_pull = numbers_of(lines[3]);
    EXPECT_EQ(only_drop.at(0), 0.2);
    EXPECT_TRUE(std::isnan(only_drop.at(1)));
    EXPECT_EQ(only_drop.at(10), 2e-3);
    EXPECT_EQ(only_pull.at(1), 1e-3);
    EXPECT_TRUE(std::isnan(only_pull.at(10)));
}

TEST(MarkerErrors, ArePerAxisAndWithinARange) {
    commands::Scene scene;
    scene.markers = {{"tip", {}}};
    commands::SceneTrial trial{"pull", "fit", Eigen::Vector3d(0.0, 0.1, 0.2), {Eigen::Matrix3Xd::Zero(3, 3)}};
    commands::SimulatedTrial simulated;
    simulated.markers = {Eigen::Matrix3Xd::Zero(3, 3)};
    simulated.markers[0].col(1) << 1e-3, -4e-3, 0.0;
    simulated.markers[0].col(2) << 3e-3, 0.0, 0.0;
    const commands::MarkerError error = commands::marker_errors(scene, trial, &simulated).at(0);
    EXPECT_EQ(error.largest_axis_m, Eigen::Vector3d(3e-3, 4e-3, 0.0));
    EXPECT_NEAR(error.largest_m, std::sqrt(17.0) * 1e-3, 1e-15);
    EXPECT_NEAR(commands::marker_rms_m(trial, &simulated, 0, 0.15, 0.25), std::sqrt(3.0) * 1e-3, 1e-15)
        << "of 3 mm, 0 and 0";
    EXPECT_NEAR(commands::marker_rms_m(trial, &simulated, 0, 0.0, 0.2), error.rms_m, 1e-15);
    EXPECT_TRUE(std::isnan(commands::marker_rms_m(trial, &simulated, 0, 0.3, 0.4)));
    EXPECT_TRUE(std::isnan(commands::marker_rms_m(trial, nullptr, 0, 0.0, 0.2)));
}

TEST(MarkerPlot, OtherTrialsAreLaidOverTheShownOne) {
    Driver driver;
    driver.open_beam();
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_FALSE(driver.has("markers/legend/pull_release, measured"));
    driver.click("markers/trials");
    driver.click("markers/trial/pull_release");
    driver.key(ImGuiKey_Escape);
    ASSERT_TRUE(driver.has("markers/legend/pull_release, simulated"));
    ImVec4 color = platform::make_theme(platform::ThemeName::dark, 1.0f).muscle(2);
    const auto drawn = [&] {
        const platform::Rectangle plot = driver.item("plot/z");
        const ImVec2 middle = plot.center();
        return test::color_near(driver.picture(), middle, color,
                                static_cast<int>(0.5f * std::min(plot.width(), plot.height())));
    };
    EXPECT_TRUE(drawn());
    driver.click("markers/legend/pull_release, simulated");
    driver.click("markers/legend/pull_release, measured");
    EXPECT_FALSE(drawn());
    driver.click("markers/trials");
    driver.click("markers/trial/pull_release");
    driver.key(ImGuiKey_Escape);
    EXPECT_FALSE(driver.has("markers/legend/pull_release, simulated"));
    EXPECT_TRUE(driver.has("plot/x/legend/measured")) << "each plot has its own again";
}

TEST(MarkerPlot, ErrorOfAChosenRangeIsTold) {
    Driver driver;
    driver.open_beam();
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    EXPECT_FALSE(driver.has("markers/chosen_rms"));
    const platform::Rectangle plot = driver.item("plot/x");
    const float y = plot.center().y;
    const double before = driver.state().time_s;
    driver.drag({plot.lowest.x + 0.4f * plot.width(), y}, {plot.lowest.x + 0.7f * plot.width(), y}, 0,
                platform::Modifiers{false, true, false});
    EXPECT_TRUE(driver.has("markers/chosen_rms"));
    EXPECT_EQ(driver.state().time_s, before) << "the time stays";
    const platform::Rectangle chosen = driver.item("residual/z/chosen"), z = driver.item("residual/z");
    EXPECT_NEAR((chosen.lowest.x - z.lowest.x) / z.width(), 0.4f, 0.02f) << "shown in all plots";
    EXPECT_NEAR(chosen.width() / z.width(), 0.3f, 0.02f);
    driver.drag({plot.lowest.x + 0.9f * plot.width(), y}, {plot.lowest.x + 0.9f * plot.width() + 1.0f, y}, 0,
                platform::Modifiers{false, true, false});
    EXPECT_FALSE(driver.has("markers/chosen_rms"));
}

TEST(MarkerCsv, IsSavedFromTheTableAndFromThePlots) {
    Driver driver;
    driver.open_beam();
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    const auto save = [&](const std::string& button) {
        driver.click(button);
        driver.click("browser/open");
        const std::string told = driver.state().log.back().text;
        const std::filesystem::path file = told.substr(std::min(told.size(), std::string("Wrote ").size()));
        const Result<std::string> text = read_file(file);
        EXPECT_TRUE(text) << told;
        std::filesystem::remove(file);
        return text ? lines_of(*text) : std::vector<std::string>{};
    };
    const std::vector<std::string> errors = save("measure/csv");
    ASSERT_EQ(errors.size(), driver.state().scene->markers.size() + 1);
    const std::vector<commands::MarkerError> expected = commands::marker_errors(
        *driver.state().scene, *driver.state().scene_trial(), driver.state().simulated_trial());
    const std::string& first = errors[1];
    ASSERT_EQ(first.substr(0, first.find(',')), expected[0].name);
    EXPECT_NEAR(numbers_of(first.substr(first.find(',') + 1)).at(0), expected[0].rms_m, 1e-8 * expected[0].rms_m);
    const std::vector<std::string> curves = (driver.click("markers/export"), save("markers/csv"));
    ASSERT_EQ(static_cast<Eigen::Index>(curves.size()), driver.state().scene_trial()->time_s.size() + 1);
    EXPECT_EQ(numbers_of(curves[1]).size(), 10u);
}

}  // namespace
}  // namespace myo::ui
