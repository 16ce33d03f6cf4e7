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

/// The element of the curve in the colour "#ff0000".
std::string curve_of(const std::string& svg) {
    const std::size_t colour = svg.find("stroke=\"#ff0000\" stroke-width=\"1.6\"", svg.find("overflow=\"hidden\""));
    return svg.substr(svg.rfind('<', colour), colour - svg.rfind('<', colour));
}

TEST(PlotSvg, HoldsTheVisibleRangeOnlyWithGapsAndEscapedNames) {
    const Eigen::VectorXd x = Eigen::VectorXd::LinSpaced(9, 0.0, 4.0), y = 2.0 * x;
    chart::Chart seen{.x = {.unit = "s", .lowest = 1.0, .highest = 3.0}, .panels = {{}}};
    chart::Panel& panel = seen.panels[0];
    panel.y = {.lowest = 0.0, .highest = 10.0};
    // Both edges fall between samples.
    panel.series = {plot::plot_series("a < b & c", x.array() + 0.25, y, {1, 0, 0, 1}),
                    plot::plot_series("dots", x, y, {0, 0, 1, 1}, true)};
    const std::string whole = plot::plots_svg({seen}, platform::Theme{});
    EXPECT_NE(whole.find("a &lt; b &amp; c"), std::string::npos);
    const double left = numbers_of(whole, "<svg x=\"([0-9.]+)\"").at(0);
    const double width = numbers_of(whole, "<svg x=[^>]*width=\"([0-9.]+)\"").at(0);
    const std::vector<double> path = numbers_of(curve_of(whole), "[ML]([0-9.]+) ");
    ASSERT_EQ(path.size(), 6u) << "four samples inside and the two edges";
    EXPECT_NEAR(path.front(), left, 0.01);
    EXPECT_NEAR(path.back(), left + width, 0.01);
    EXPECT_EQ(numbers_of(whole, "M[0-9.]+ ([0-9.]+)h0").size(), 5u + 1u) << "samples inside and the legend";
    EXPECT_EQ(numbers_of(curve_of(whole), "M([0-9.]+) ").size(), 1u);
    panel.series[0].y[4] = NAN;
    EXPECT_EQ(numbers_of(curve_of(plot::plots_svg({seen}, platform::Theme{})), "M([0-9.]+) ").size(), 2u) << "a gap";
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
    EXPECT_GE(numbers_of(*svg, "<svg x=\"([0-9.]+)\"").size(), 3u) << "x, y and z";
    EXPECT_GT(numbers_of(*svg, "L([0-9.]+) ").size(), 10u);
}

}  // namespace
}  // namespace myo::ui
