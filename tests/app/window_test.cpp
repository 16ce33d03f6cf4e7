#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <sstream>
#include <thread>

#include "app/program.hpp"
#include "app/virtual_display.hpp"
#include "support/folder.hpp"

namespace myo::test {
namespace {

/// Waiting this long is for loaded machines; each step takes a second or two.
constexpr double limit_s = 90.0;

/// What a program wrote, without Mesa's remarks on drivers that a server without a screen does not have.
std::string own_lines(const std::string& text) {
    std::istringstream lines(text);
    std::string own;
    for (std::string line; std::getline(lines, line);)
        if (line.rfind("libGL", 0) != 0 && line.rfind("MESA", 0) != 0 && line.rfind("libEGL", 0) != 0)
            own += line + "\n";
    return own;
}

// The rail of steps at the left edge, in the dark theme at 100 %: a bar marks the step that is shown, a tick one that
// is done.
constexpr unsigned bar_colour = 0x4c9dff, tick_colour = 0x6fd08c;
constexpr int bar_width = 3, rail_width = 128, row_pitch = 38;

/// Middle of the row of the step that is shown; 0: none is.
int shown_row(const Screenshot& shot) {
    const std::vector<int> rows = shot.rows_with(bar_colour, 0, bar_width);
    return rows.empty() ? 0 : (rows.front() + rows.back()) / 2;
}

bool has_tick(const Screenshot& shot, int row) {
    for (const int y : shot.rows_with(tick_colour, 0, rail_width))
        if (std::abs(y - row) < row_pitch / 2) return true;
    return false;
}

TEST(Window, OpensDrawsResizesRunsAndCloses) {
    const Folder folder("window");
    const auto display = VirtualDisplay::start(folder.path(), 1600, 1000);
    if (!display) GTEST_SKIP() << "skipped: no Xvfb or no xdotool";
    Companion program({std::string(MYOLOOP_BINARY_DIR) + "/myoloop",
                       std::string(MYOLOOP_SOURCE_DIR) + "/assets/examples/silicone_beam"},
                      folder.path() / "out", folder.path() / "err",
                      {"DISPLAY=" + display->name(), "WAYLAND_DISPLAY=", "LIBGL_ALWAYS_SOFTWARE=1",
                       "XDG_CONFIG_HOME=" + (folder.path() / "config").string(),
                       "XDG_STATE_HOME=" + (folder.path() / "state").string()});
    const auto said = [&] { return content_of(folder.path() / "out") + content_of(folder.path() / "err"); };

    unsigned long window = 0;
    ASSERT_TRUE(wait_until(limit_s, [&] { return program.ended() || (window = display->window("Myoloop")) != 0; }));
    ASSERT_FALSE(program.ended()) << said();
    // Text in several sizes, a shaded body, markers: far more colours than an empty window has.
    Screenshot shot;
    const auto drawn = [&](int width) {
        shot = display->picture(window);
        return shot.width == width && shot.colours() > 200;
    };
    const int first_width = display->picture(window).width;
    ASSERT_TRUE(wait_until(limit_s, [&] { return program.ended() || drawn(first_width); }))
        << shot.colours() << " colours";

    display->resize(window, 1500, 940);
    ASSERT_TRUE(wait_until(limit_s, [&] { return program.ended() || drawn(1500); }))
        << shot.width << " x " << shot.height;
    EXPECT_EQ(shot.height, 940);
    // The new part is drawn too.
    EXPECT_TRUE(wait_until(limit_s, [&] { return program.ended() || display->picture(window).colours(1350, 0) > 20; }));

    // Nothing moves any more once the example is open and meshed.
    std::vector<unsigned> before;
    EXPECT_TRUE(wait_until(limit_s, [&] {
        before = display->picture(window).pixels;
        std::this_thread::sleep_for(std::chrono::milliseconds(700));
        return program.ended() || display->picture(window).pixels == before;
    }));
    // Body is shown first; Run is the fifth step. A click on it brings its panel.
    const int body = shown_row(display->picture(window)), run = body + 4 * row_pitch;
    ASSERT_GT(body, 0);
    EXPECT_FALSE(has_tick(display->picture(window), run));
    ASSERT_TRUE(display->click(window, rail_width / 2, run));
    EXPECT_TRUE(wait_until(limit_s, [&] {
        return program.ended() || std::abs(shown_row(display->picture(window)) - run) < row_pitch / 4;
    })) << "the click has shown nothing";
    ASSERT_TRUE(display->press(window, "ctrl+r"));
    EXPECT_TRUE(wait_until(limit_s, [&] { return program.ended() || has_tick(display->picture(window), run); }))
        << "Ctrl+R has run nothing";

    EXPECT_FALSE(program.ended()) << said();
    display->close(window);
    ASSERT_TRUE(wait_until(limit_s, [&] { return program.ended().has_value(); })) << "it did not close";
    EXPECT_EQ(program.ended(), 0) << said();
    EXPECT_EQ(own_lines(said()), "");
}

}  // namespace
}  // namespace myo::test
