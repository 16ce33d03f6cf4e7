#include <gtest/gtest.h>

#include <cmath>

#include "chart/svg.hpp"
#include "plot/draw_chart.hpp"
#include "plot/plot.hpp"
#include "ui/driver.hpp"

// The window and the SVG draw one chart: same ticks, same labels, same places.

namespace myo::ui {
namespace {

/// Draws a plot in a frame of its own context without a window and returns what happened.
class PlotFrame {
public:
    PlotFrame() : context_(ImGui::CreateContext()) {
        ImGui::SetCurrentContext(context_);
        ImGuiIO& io = ImGui::GetIO();
        io.DisplaySize = {800.0f, 600.0f};
        io.IniFilename = nullptr;
        theme_ = platform::make_theme(platform::ThemeName::light, 1.0f);
        theme_.regular = theme_.strong = theme_.small = theme_.large = io.Fonts->AddFontDefault();
        io.Fonts->Build();
    }
    ~PlotFrame() { ImGui::DestroyContext(context_); }
    PlotFrame(const PlotFrame&) = delete;
    PlotFrame& operator=(const PlotFrame&) = delete;

    plot::PlotResult draw(const plot::Plot& plot, const ImVec2& size, const ImVec2& mouse, float wheel = 0.0f) {
        ImGuiIO& io = ImGui::GetIO();
        io.MousePos = mouse;
        io.MouseWheel = wheel;
        io.DeltaTime = 1.0f / 60.0f;
        ImGui::NewFrame();
        ImGui::SetNextWindowPos({0.0f, 0.0f});
        ImGui::SetNextWindowSize({800.0f, 600.0f});
        ImGui::Begin("test");
        const plot::PlotResult result = plot::draw_plot(plot, size, theme_, items_, x_axis_, state_, hidden_);
        vertices_ = ImGui::GetWindowDrawList()->VtxBuffer.Size;
        ImGui::End();
        ImGui::Render();
        return result;
    }
    const plot::LinkedAxis& x_axis() const { return x_axis_; }
    const platform::Theme& theme() const { return theme_; }
    int vertices() const { return vertices_; }

private:
    ImGuiContext* context_;
    platform::Theme theme_;
    platform::ItemRectangles items_;
    plot::LinkedAxis x_axis_;
    plot::PlotState state_;
    plot::HiddenSeries hidden_;
    int vertices_ = 0;
};

plot::Plot swing() {
    const Eigen::VectorXd t = Eigen::VectorXd::LinSpaced(101, 0.0, 2.0);
    plot::Plot plot;
    plot.id = "swing";
    plot.panel.y = {.label = "z", .unit = "mm"};
    plot.panel.series = {plot::plot_series("measured", t, (3e5 * t.array().sin()).matrix(), {1, 0, 0, 1})};
    return plot;
}

TEST(PlotChart, HasTheTicksOfItsSvg) {
    PlotFrame frame;
    const plot::Plot plot = swing();
    const plot::PlotResult drawn = frame.draw(plot, {500.0f, 240.0f}, {-10.0f, -10.0f});
    // The chart that the SVG export takes, in the same place and with the same letters.
    chart::Chart seen = plot::seen_chart(plot, drawn.area, {});
    const chart::LayoutStyle style = plot::window_style(frame.theme());
    const platform::Rectangle& pixels = drawn.area.pixels;
    seen.width_px = 500.0;
    seen.panels[0].height_px = static_cast<double>(pixels.height());
    const chart::Layout layout = chart::lay_out(seen, style, plot::chart_palette(frame.theme()),
                                                plot::window_text_width(frame.theme()),
                                                {static_cast<double>(pixels.lowest.x) - style.left_margin,
                                                 static_cast<double>(pixels.lowest.y) - style.panel_heading});
    EXPECT_NEAR(layout.panels[0].area.left, static_cast<double>(pixels.lowest.x), 1e-3);
    EXPECT_NEAR(layout.panels[0].area.top, static_cast<double>(pixels.lowest.y), 1e-3);
    for (const double v : layout.x.ticks.values) EXPECT_NEAR(layout.x.scale(v), drawn.area.x(v), 1e-2);
    for (const double v : layout.panels[0].y.ticks.values)
        EXPECT_NEAR(layout.panels[0].y.scale(v), drawn.area.y(v), 1e-2);
    // All labels of the layout are in the SVG, with the common power of ten in the title.
    const std::string svg = chart::svg(chart::draw(seen, layout, plot::chart_palette(frame.theme())));
    for (const std::string& label : layout.panels[0].y.ticks.labels)
        if (!label.empty()) {
            EXPECT_NE(svg.find(">" + label + "</text>"), std::string::npos) << label;
        }
    EXPECT_NE(svg.find("z [10³ mm]"), std::string::npos);
    EXPECT_GT(frame.vertices(), 200);
}

TEST(PlotChart, ZoomKeepsTheValueUnderTheMouseOnBothKindsOfAxis) {
    for (const bool logarithmic : {false, true}) {
        PlotFrame frame;
        plot::Plot plot = swing();
        plot.x.logarithmic = logarithmic;
        const ImVec2 mouse{300.0f, 100.0f};
        plot::PlotResult drawn = frame.draw(plot, {500.0f, 240.0f}, mouse);
        drawn = frame.draw(plot, {500.0f, 240.0f}, mouse);
        ASSERT_TRUE(drawn.hovered);
        const double before = drawn.area.x.value(300.0), span = drawn.area.x.highest / drawn.area.x.lowest;
        frame.draw(plot, {500.0f, 240.0f}, mouse, 1.0f);
        ASSERT_TRUE(frame.x_axis().range);
        drawn = frame.draw(plot, {500.0f, 240.0f}, mouse);
        EXPECT_NEAR(drawn.area.x.value(300.0), before, 1e-9 * std::abs(before));
        if (logarithmic) {
            EXPECT_NEAR(std::log(drawn.area.x.highest / drawn.area.x.lowest), 0.85 * std::log(span), 1e-6);
        }
    }
}

TEST(PlotChart, FindsTheNearestSample) {
    EXPECT_EQ(plot::nearest_sample({}, 1.0), std::nullopt);
    EXPECT_EQ(plot::nearest_sample({0.0, 1.0, 3.0}, 1.9), 1u);
    EXPECT_EQ(plot::nearest_sample({0.0, 1.0, 3.0}, 2.1), 2u);
    EXPECT_EQ(plot::nearest_sample({0.0, 1.0, 3.0}, 9.0), 2u);
}

}  // namespace
}  // namespace myo::ui
