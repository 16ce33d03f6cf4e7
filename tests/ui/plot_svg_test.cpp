#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "base/files.hpp"
#include "plot/plot_svg.hpp"
#include "ui/driver.hpp"

namespace myo::ui {
namespace {

std::vector<double> numbers_of(const std::string& svg, const std::string& pattern) {
    std::vector<double> numbers;
    const std::regex expression(pattern);
    for (std::sregex_iterator m(svg.begin(), svg.end(), expression), end; m != end; ++m)
        numbers.push_back(std::stod((*m)[1]));
    return numbers;
}

TEST(PlotSvg, HoldsTheVisibleRangeOnlyWithGapsAndEscapedNames) {
    plot::SeenPlot seen{{}, {1.0, 3.0}, {0.0, 10.0}};
    Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(9, 0.0, 4.0), y = 2.0 * x;
    seen.plot.legend = true;
    seen.plot.series = {{"a < b & c", x, y, {1, 0, 0, 1}, false}, {"dots", x, y, {0, 0, 1, 1}, true}};
    seen.plot.series[0].x.array() += 0.25;  // both edges fall between samples
    const std::string whole = plot::plots_svg({seen}, platform::Theme{});
    EXPECT_NE(whole.find("a &lt; b &amp; c"), std::string::npos);
    const std::vector<double> path = numbers_of(whole, "[ML]([0-9.]+) ");
    ASSERT_EQ(path.size(), 6u) << "four samples inside and the two edges";
    EXPECT_NEAR(path.front(), 64.0, 0.01);
    EXPECT_NEAR(path.back(), 784.0, 0.01);
    EXPECT_EQ(numbers_of(whole, "<circle cx=\"([0-9.]+)\"[^>]*r=\"1.80\"").size(), 5u);
    EXPECT_EQ(numbers_of(whole, "M([0-9.]+) ").size(), 1u);
    seen.plot.series[0].y[4] = NAN;
    EXPECT_EQ(numbers_of(plot::plots_svg({seen}, platform::Theme{}), "M([0-9.]+) ").size(), 2u) << "a gap";
}

TEST(PlotSvg, IsSavedFromTheMarkersPanel) {
    test::Driver driver;
    driver.open_beam();
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
    driver.click("markers/export");
    driver.click("markers/svg");
    driver.click("browser/open");
    const std::string told = driver.state().log.back().text;
    const std::filesystem::path file = told.substr(std::min(told.size(), std::string("Wrote ").size()));
    EXPECT_EQ(file.extension(), ".svg") << told;
    const Result<std::string> svg = read_file(file);
    ASSERT_TRUE(svg) << told;
    std::filesystem::remove(file);
    EXPECT_GE(numbers_of(*svg, "translate\\(0 ([0-9.]+)\\)").size(), 3u) << "x, y and z";
    EXPECT_GT(numbers_of(*svg, "L([0-9.]+) ").size(), 10u);
}

}  // namespace
}  // namespace myo::ui
