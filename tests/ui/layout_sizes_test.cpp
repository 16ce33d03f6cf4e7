#include "panels/layout.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "ui/driver.hpp"

// Sizes of the window's parts, from small windows with large letters to large ones.

namespace myo::ui::layout_sizes {
namespace {

using commands::LayoutSizes;
using panels::Layout;
using panels::make_layout;
using platform::Rectangle;

struct Window {
    float width, height, scale;
};
const std::vector<Window> windows{{1000, 640, 1.0f},  {1000, 640, 0.75f}, {1000, 640, 1.25f},
                                  {1000, 640, 2.0f},  {1280, 800, 1.1f},  {1600, 900, 2.5f},
                                  {1921, 1081, 1.5f}, {3840, 2160, 1.0f}, {640, 480, 1.0f}};
// As they are at first, dragged to nothing, and dragged beyond the window.
const std::vector<LayoutSizes> dragged{{}, {0.0f, 0.0f}, {1e6f, 1e6f}, {1e6f, 0.0f}, {333.3f, 211.1f}};

std::vector<Rectangle> parts(const Layout& layout) {
    return {layout.bar,      layout.steps, layout.rail,       layout.rail_edge, layout.view,
            layout.timeline, layout.strip, layout.strip_edge, layout.help};
}

double area(const Rectangle& part) { return static_cast<double>(part.width()) * static_cast<double>(part.height()); }

bool overlap(const Rectangle& a, const Rectangle& b) {
    return std::min(a.highest.x, b.highest.x) > std::max(a.lowest.x, b.lowest.x) &&
           std::min(a.highest.y, b.highest.y) > std::max(a.lowest.y, b.lowest.y);
}

/// Expects that the parts fill the window without a gap, on whole pixels.
void expect_filled(const Layout& layout, const Window& window) {
    const std::vector<Rectangle> all = parts(layout);
    double sum = 0.0;
    for (std::size_t i = 0; i < all.size(); ++i) {
        EXPECT_GE(all[i].width(), 0.0f) << i;
        EXPECT_GE(all[i].height(), 0.0f) << i;
        for (const float side : {all[i].lowest.x, all[i].lowest.y, all[i].highest.x, all[i].highest.y})
            EXPECT_EQ(side, std::round(side)) << i << ": text would be blurred";
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(overlap(all[i], all[j])) << i << " and " << j;
        sum += area(all[i]);
    }
    EXPECT_EQ(sum, static_cast<double>(window.width) * static_cast<double>(window.height));
}

TEST(LayoutSizes, PartsFillTheWindowWithAndWithoutTheHelp) {
    for (const Window& window : windows)
        for (const LayoutSizes& sizes : dragged) {
            SCOPED_TRACE(::testing::Message() << window.width << " x " << window.height << " at " << window.scale
                                              << ", " << sizes.rail << ", " << sizes.strip);
            const Layout layout = make_layout(window.width, window.height, window.scale, sizes);
            EXPECT_EQ(area(layout.help), 0.0);
            expect_filled(layout, window);
            const Layout with_help = panels::beside_help(layout, window.scale);
            expect_filled(with_help, window);
            EXPECT_GE(with_help.view.width(), 0.45f * layout.view.width() - 1.0f);
            EXPECT_LE(with_help.help.width(), std::round(380.0f * window.scale));
        }
}

TEST(LayoutSizes, TheViewKeepsAThirdOfAUsualWindow) {
    for (const Window& window : windows) {
        // Bars and timeline of letters that are this large leave less of a window that is this small.
        if (window.height < 320.0f * window.scale || window.width < 640.0f * window.scale) continue;
        for (const LayoutSizes& sizes : dragged) {
            const Layout layout = make_layout(window.width, window.height, window.scale, sizes);
            EXPECT_GT(layout.view.width(), window.width / 3.0f) << window.width << " at " << window.scale;
            EXPECT_GT(layout.view.height(), window.height / 3.0f) << window.height << " at " << window.scale;
        }
    }
}

TEST(LayoutSizes, AreAskedForInPixelsAtScaleOne) {
    const Layout usual = make_layout(3000, 2000, 1.0f, {336.0f, 288.0f}),
                 large = make_layout(3000, 2000, 2.0f, {336.0f, 288.0f});
    EXPECT_EQ(usual.rail.width(), 336.0f);
    EXPECT_EQ(usual.strip.height(), 288.0f);
    EXPECT_EQ(large.rail.width(), 672.0f);
    EXPECT_EQ(large.strip.height(), 576.0f);
    EXPECT_EQ(large.bar.height(), 2.0f * usual.bar.height());
    EXPECT_EQ(large.timeline.height(), 2.0f * usual.timeline.height());
    EXPECT_EQ(large.rail_edge.width(), 2.0f * usual.rail_edge.width());
}

TEST(LayoutSizes, ASmallWindowLimitsWhatIsDragged) {
    // 1000 x 640: the panel takes 240 pixels to what is left of 60 % beside the tasks, the strip 80 to half of the
    // rest.
    for (const auto& [asked, kept] : std::vector<std::pair<float, float>>{
             {0.0f, 240.0f}, {239.0f, 240.0f}, {241.0f, 241.0f}, {471.0f, 471.0f}, {473.0f, 472.0f}, {9e9f, 472.0f}})
        EXPECT_EQ(make_layout(1000, 640, 1.0f, {asked, 288.0f}).rail.width(), kept) << asked;
    for (const auto& [asked, kept] : std::vector<std::pair<float, float>>{
             {0.0f, 80.0f}, {81.0f, 81.0f}, {275.0f, 275.0f}, {277.0f, 276.0f}, {9e9f, 276.0f}})
        EXPECT_EQ(make_layout(1000, 640, 1.0f, {336.0f, asked}).strip.height(), kept) << asked;
    // Below 1000 pixels at scale 1 the tasks are icons.
    EXPECT_FALSE(make_layout(1000, 640, 1.0f, {}).narrow);
    EXPECT_TRUE(make_layout(999, 640, 1.0f, {}).narrow);
    EXPECT_TRUE(make_layout(1000, 640, 1.01f, {}).narrow);
    EXPECT_EQ(make_layout(1000, 640, 1.0f, {}).steps.width(), 128.0f);
    EXPECT_EQ(make_layout(999, 640, 1.0f, {}).steps.width(), 44.0f);
    // Where even the tasks and the least panel would exceed half of the window, the panel gives way.
    const Layout tiny = make_layout(300, 640, 1.0f, {0.0f, 0.0f});
    EXPECT_EQ(tiny.rail.width(), 150.0f - 44.0f);
}

TEST(LayoutSizes, AreThoseOfTheItemsInASmallWindow) {
    test::Driver driver(1000, 640);
    driver.open_beam();
    for (const float scale : {1.0f, 0.75f}) {
        driver.workbench->execute(commands::SetTheme{platform::ThemeName::dark, scale});
        driver.settle();
        const Layout layout = make_layout(1000, 640, scale, driver.state().preferences.layout);
        const auto expect_within = [&](const Rectangle& part, const char* name) {
            const auto item = driver.window->items().find(name);
            ASSERT_TRUE(item) << name;
            EXPECT_GE(item->lowest.x, part.lowest.x - 1.0f) << name << " at " << scale;
            EXPECT_GE(item->lowest.y, part.lowest.y - 1.0f) << name << " at " << scale;
            EXPECT_LE(item->highest.x, part.highest.x + 1.0f) << name << " at " << scale;
            EXPECT_LE(item->highest.y, part.highest.y + 1.0f) << name << " at " << scale;
        };
        expect_within(layout.view, "view");
        expect_within(layout.timeline, "timeline/track");
        expect_within(layout.bar, "menu/run");
        for (const commands::Task task : commands::all_tasks)
            expect_within(layout.steps, (std::string("task/") + commands::task_id(task)).c_str());
        EXPECT_GE(driver.item("timeline/track").width(), 40.0f) << scale;
        EXPECT_GT(driver.item("view").height(), 150.0f) << scale;
    }
}

}  // namespace
}  // namespace myo::ui::layout_sizes
