#include <gtest/gtest.h>

#include <sstream>

#include "base/files.hpp"
#include "base/text.hpp"
#include "commands/marker_csv.hpp"
#include "ui/driver.hpp"

namespace myo {
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
    for (std::string field; std::getline(stream, field, ',');) EXPECT_TRUE(parse_number(field, numbers.emplace_back())) << field;
    return numbers;
}

TEST(MarkerCsv, HoldsTheCurvesOfTheRangeAndOfComparedRuns) {
    auto scene = std::make_shared<Scene>();
    scene->markers = {{"tip", {}}};
    scene->trials = {{"pull", "fit", Eigen::Vector4d(0.0, 0.1, 0.2, 0.3), {Eigen::Matrix3Xd::Constant(3, 4, 1e-3)}}};
    scene->trials[0].measured[0].col(2).setConstant(std::numeric_limits<double>::quiet_NaN());
    const auto shown = std::make_shared<RunResult>(), other = std::make_shared<RunResult>();
    shown->trials.resize(1);
    shown->trials[0].markers = {Eigen::Matrix3Xd::Constant(3, 4, 4e-3)};
    other->trials.resize(1);
    other->trials[0].markers = {Eigen::Matrix3Xd::Constant(3, 4, 7e-3)};
    WorkbenchState state;
    state.scene = scene;
    state.run = shown;
    JobRecord record;
    record.name = "Run, \"soft\"";
    record.clock = "14:05:09";
    record.run = other;
    state.history = {record};
    EXPECT_EQ(numbers_of(lines_of(marker_curves_csv(state, 0.0, 1.0)).at(1)).size(), 10u) << "a run that is not compared is left out";
    state.history[0].compared = true;
    const std::vector<std::string> lines = lines_of(marker_curves_csv(state, 0.05, 0.25));
    ASSERT_EQ(lines.size(), 3u);
    EXPECT_EQ(lines[0].substr(0, 60), "time_s,measured_x_m,measured_y_m,measured_z_m,simulated_x_m,");
    EXPECT_NE(lines[0].find(",\"Run, \"\"soft\"\" 14:05:09_x_m\","), std::string::npos) << lines[0];
    EXPECT_EQ(numbers_of(lines[1]), (std::vector<double>{0.1, 1e-3, 1e-3, 1e-3, 4e-3, 4e-3, 4e-3, 3e-3, 3e-3, 3e-3, 7e-3, 7e-3, 7e-3}));
    const std::vector<double> occluded = numbers_of(lines[2]);
    EXPECT_TRUE(std::isnan(occluded.at(1)) && std::isnan(occluded.at(7)));
    EXPECT_EQ(occluded.at(4), 4e-3);
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
    const std::vector<MarkerError> expected = marker_errors(*driver.state().scene, *driver.state().scene_trial(), driver.state().simulated_trial());
    const std::string& first = errors[1];
    ASSERT_EQ(first.substr(0, first.find(',')), expected[0].name);
    EXPECT_NEAR(numbers_of(first.substr(first.find(',') + 1)).at(0), expected[0].rms_m, 1e-8 * expected[0].rms_m);
    const std::vector<std::string> curves = save("markers/csv");
    ASSERT_EQ(static_cast<Eigen::Index>(curves.size()), driver.state().scene_trial()->time_s.size() + 1);
    EXPECT_EQ(numbers_of(curves[1]).size(), 10u);
}

}  // namespace
}  // namespace myo
