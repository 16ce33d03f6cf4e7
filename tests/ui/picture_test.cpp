#include <gtest/gtest.h>
#include <stb_image.h>

#include <array>
#include <cstdlib>
#include <set>

#include "base/files.hpp"
#include "platform/film.hpp"
#include "support/folder.hpp"
#include "ui/driver.hpp"

namespace myo::ui {
namespace {

namespace fs = std::filesystem;
using test::Driver;
using test::Folder;

platform::Image read_png(const fs::path& path) {
    platform::Image image;
    int channels = 0;
    unsigned char* const pixels = stbi_load(path.c_str(), &image.width, &image.height, &channels, 4);
    EXPECT_TRUE(pixels) << path;
    if (!pixels) return image;
    image.rgba.assign(pixels,
                      pixels + 4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    stbi_image_free(pixels);
    return image;
}

/// What the dialogs hand to the window.
panels::PictureRequest motion(const fs::path& path, double rate_Hz) {
    panels::PictureRequest request;
    request.path = path;
    request.width = 320;
    request.height = 200;
    request.moves = true;
    request.rate_Hz = rate_Hz;
    request.to_s = 0.5;
    return request;
}

TEST(Picture, IsDrawnAnewInTheSizeThatIsAskedFor) {
    const Folder folder("picture");
    Driver driver;
    driver.draw_pixels();
    ASSERT_NO_FATAL_FAILURE(run_a_beam(driver));
    driver.key(ui::platform::key_k, {.ctrl = true});
    driver.type("save picture");
    driver.key(ImGuiKey_Enter);
    driver.settle();
    driver.click("picture/size");
    driver.click("picture/size/1920x1080");
    driver.click("picture/where");
    ASSERT_TRUE(driver.has("browser/path") || driver.has("browser/name"));
    driver.key(ImGuiKey_Escape);
    driver.settle();
    // Twice as large, it shows the same at corresponding places, and more of it.
    const viewport::ViewSize view = driver.window->viewport().size();
    for (const int k : {1, 2}) {
        driver.window->draw_into({folder.path() / (std::to_string(k) + ".png"), k * view.width, k * view.height});
        driver.settle();
    }
    const platform::Image once = read_png(folder.path() / "1.png"), twice = read_png(folder.path() / "2.png");
    ASSERT_EQ(once.width, view.width);
    ASSERT_EQ(twice.width, 2 * view.width);
    ASSERT_EQ(twice.height, 2 * view.height);
    int alike = 0, all = 0;
    std::set<std::array<int, 3>> colours;
    for (int y = 5; y < once.height; y += 7)
        for (int x = 5; x < once.width; x += 7) {
            const auto a = once.color(x, y), b = twice.color(2 * x, 2 * y);
            colours.insert(a);
            ++all;
            alike += std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]) < 40 ? 1 : 0;
        }
    EXPECT_GT(alike, 0.93 * all);  // all but edges
    EXPECT_GT(colours.size(), 30u);
}

/// A picture of the view in twice its size.
platform::Image picture_of(Driver& driver, const fs::path& path, bool overlay = true) {
    const viewport::ViewSize view = driver.window->viewport().size();
    panels::PictureRequest request{path, 2 * view.width, 2 * view.height};
    request.overlay = overlay;
    driver.window->draw_into(request);
    for (int i = 0; i < 100 && !fs::exists(path); ++i) driver.frame();
    return read_png(path);
}

TEST(Picture, HasWhatLiesOverTheViewInItsOwnSize) {
    const Folder folder("overlay");
    Driver driver;
    driver.draw_pixels();
    ASSERT_NO_FATAL_FAILURE(run_a_beam(driver));
    commands::ViewOptions options = driver.state().view;
    options.field = "height";
    driver.workbench->execute(commands::ChangeView{options});
    driver.workbench->execute(commands::SetTime{0.3});
    driver.key(ui::platform::key_d);
    driver.click_at(test::pixel_of(driver, {0.031, 0.0, 0.012}));
    driver.click_at(test::pixel_of(driver, {0.071, 0.0, 0.012}));
    driver.key(ImGuiKey_Escape);
    driver.click_at({driver.item("view").lowest.x + 4.0f, driver.item("view").highest.y - 4.0f});
    ASSERT_EQ(driver.window->distance_tool().distances().size(), 1u);
    while (driver.window->waits_for_field()) driver.frame();
    driver.settle();
    const platform::Image window = driver.picture(), with = picture_of(driver, folder.path() / "with.png"),
                          without = picture_of(driver, folder.path() / "without.png", false);
    const platform::Rectangle view = driver.window->viewport().pixels;
    const auto as_in_window = [&](const platform::Rectangle& part) {
        double alike = 0.0, all = 0.0;
        for (float y = part.lowest.y; y < part.highest.y; y += 1.0f)
            for (float x = part.lowest.x; x < part.highest.x; x += 1.0f) {
                const auto a = window.color(static_cast<int>(view.lowest.x + x), static_cast<int>(view.lowest.y + y));
                const auto b = with.color(static_cast<int>(2.0f * x), static_cast<int>(2.0f * y));
                alike += std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]) < 60 ? 1.0 : 0.0;
                all += 1.0;
            }
        return alike / all;
    };
    const auto drawn = [&](const platform::Rectangle& part) {
        return test::differing_share(
            with, without,
            {{2.0f * part.lowest.x, 2.0f * part.lowest.y}, {2.0f * part.highest.x, 2.0f * part.highest.y}});
    };
    const float w = view.width(), h = view.height();
    const ImVec2 from = test::pixel_of(driver, {0.031, 0.0, 0.012});
    const ImVec2 start{from.x - view.lowest.x, from.y - view.lowest.y};
    struct Part {
        const char* name;
        platform::Rectangle place;
    };
    for (const auto& [name, place] :
         {Part{"legend", {{w - 60.0f, 20.0f}, {w - 8.0f, 190.0f}}},
          Part{"scale bar", {{w - 150.0f, h - 45.0f}, {w, h}}}, Part{"axes", {{8.0f, h - 90.0f}, {88.0f, h}}},
          Part{"distance", {{start.x - 5.0f, start.y - 5.0f}, {start.x + 25.0f, start.y + 5.0f}}}}) {
        EXPECT_GT(drawn(place), 0.01) << name;
        EXPECT_GT(as_in_window(place), 0.75) << name;
    }
    EXPECT_GT(drawn({{10.0f, 10.0f}, {80.0f, 30.0f}}), 0.02) << "the time";
}

TEST(Picture, LinesAndMarkersKeepTheirShareOfALargerOne) {
    auto context = platform::OffscreenContext::make(16, 16);
    ASSERT_TRUE(context);
    auto renderer = viewport::SceneRenderer::make();
    ASSERT_TRUE(renderer);
    viewport::DrawnScene scene;
    scene.grid = false;
    scene.marker_radius = 1e-6;  // the least size counts
    scene.markers.push_back({{0.1, 0.0, 0.1}, viewport::Color(1.0f, 0.0f, 0.0f, 1.0f), false, "", -1});
    viewport::DrawnLine line;
    line.points.resize(3, 2);
    line.points << -0.1, 0.1, 0.0, 0.0, -0.1, -0.1;
    line.color = viewport::Color(1.0f, 0.0f, 0.0f, 1.0f);
    scene.lines.push_back(line);
    viewport::Camera camera;
    camera.yaw = -1.5707963;
    camera.pitch = 0.0;
    const auto red = [&](int side, double scale) {
        EXPECT_TRUE(renderer->update(scene, static_cast<std::uint64_t>(side),
                                     viewport::view_colors(platform::make_theme(platform::ThemeName::dark, 1.0f)),
                                     camera, {side, side}, 4, scale));
        const platform::Image image = renderer->read();
        double sum = 0.0;
        for (std::size_t i = 0; i < image.rgba.size(); i += 4)
            sum += std::max(0, image.rgba[i] - image.rgba[i + 1]) / 255.0;
        return sum / side / side;
    };
    const double small = red(200, 1.0);
    EXPECT_GT(small, 1e-3);
    EXPECT_NEAR(red(800, 4.0) / small, 1.0, 0.15);
}

TEST(Picture, IsOfTheTimeThatWasShownWhenItWasAskedFor) {
    const Folder folder("asked");
    Driver driver;
    driver.draw_pixels();
    ASSERT_NO_FATAL_FAILURE(run_a_beam(driver));
    driver.workbench->execute(commands::SetTime{0.2});
    driver.workbench->execute(commands::Play{true});
    for (int i = 0; i < 5; ++i) driver.frame();
    const platform::Image playing = picture_of(driver, folder.path() / "playing.png");
    ASSERT_TRUE(driver.state().playing) << "it is written meanwhile";
    const double shown = driver.state().time_s;
    driver.workbench->execute(commands::Play{false});
    driver.workbench->execute(commands::SetTime{shown});
    driver.settle();
    EXPECT_TRUE(playing.rgba == picture_of(driver, folder.path() / "paused.png").rgba);
    // By the dialog: what was shown when it was opened, not when the file was chosen.
    driver.workbench->execute(commands::SetTime{0.4});
    driver.settle();
    const fs::path before = fs::current_path();
    fs::create_directory(folder.path() / "dialog");
    fs::current_path(folder.path() / "dialog");  // where the browser begins
    driver.key(ui::platform::key_k, {.ctrl = true});
    driver.type("save picture");
    driver.key(ImGuiKey_Enter);
    driver.settle();
    driver.workbench->execute(commands::SetTime{1.1});
    driver.settle();
    driver.click("picture/where");
    driver.click("browser/open");
    fs::current_path(before);
    driver.settle();
    ASSERT_TRUE(fs::exists(folder.path() / "dialog" / "picture.png"));
    const viewport::ViewSize view = driver.window->viewport().size();
    driver.workbench->execute(commands::SetTime{0.4});
    driver.settle();
    driver.window->draw_into({folder.path() / "then.png", view.width, view.height});
    driver.settle();
    EXPECT_TRUE(read_png(folder.path() / "dialog" / "picture.png").rgba == read_png(folder.path() / "then.png").rgba);
}

/// A search that shows its best, or a person who looks at another time, must not hold a film up or get into it.
TEST(Picture, FilmsDoNotDependOnTheTimeThatIsShown) {
    const Folder folder("film_alone");
    Driver driver;
    driver.draw_pixels();
    ASSERT_NO_FATAL_FAILURE(run_a_beam(driver));
    commands::ViewOptions options = driver.state().view;
    options.field = "height";
    driver.workbench->execute(commands::ChangeView{options});
    driver.settle();
    const auto film = [&](const std::string& name, bool disturbed) {
        driver.window->draw_into(motion(folder.path() / name, 20.0));
        for (int i = 0; i < 200 && !fs::exists(folder.path() / name); ++i) {
            if (disturbed) driver.workbench->execute(commands::SetTime{0.7 + 0.01 * i});
            if (disturbed && i == 2) driver.workbench->execute(commands::Play{true});
            driver.frame();
        }
        return fs::exists(folder.path() / name);
    };
    ASSERT_TRUE(film("alone", false));
    ASSERT_TRUE(film("disturbed", true));
    EXPECT_TRUE(driver.state().playing);
    for (const char* frame : {"frame_0001.png", "frame_0006.png", "frame_0011.png"})
        EXPECT_TRUE(read_png(folder.path() / "alone" / frame).rgba ==
                    read_png(folder.path() / "disturbed" / frame).rgba)
            << frame;
}

TEST(Picture, NumberedOnesShowTheMotionOverItsTime) {
    const Folder folder("frames");
    Driver driver;
    driver.draw_pixels();
    ASSERT_NO_FATAL_FAILURE(run_a_beam(driver));
    driver.workbench->execute(commands::SetTime{0.123});
    driver.settle();
    driver.window->draw_into(motion(folder.path() / "swing", 20.0));
    for (int i = 0; i < 40 && !fs::exists(folder.path() / "swing"); ++i) driver.frame();
    ASSERT_TRUE(fs::exists(folder.path() / "swing" / "frame_0011.png"));
    EXPECT_FALSE(fs::exists(folder.path() / "swing" / "frame_0012.png")) << "0 to 0.5 s, both included";
    std::set<std::string> different;
    for (const auto& entry : fs::directory_iterator(folder.path() / "swing"))
        different.insert(*read_file(entry.path()));
    EXPECT_EQ(different.size(), 11u);
    EXPECT_EQ(read_png(folder.path() / "swing" / "frame_0001.png").width, 320);
    driver.settle();
    EXPECT_DOUBLE_EQ(driver.state().time_s, 0.123) << "as before";
    EXPECT_EQ(driver.state().log.back().level, commands::LogLevel::done);
    // A folder that is there is not touched.
    driver.window->draw_into(motion(folder.path() / "swing", 20.0));
    driver.settle();
    EXPECT_EQ(driver.state().log.back().level, commands::LogLevel::failure);
}

TEST(Picture, GivenUpLeavesNothing) {
    const Folder folder("given_up");
    Driver driver;
    driver.draw_pixels();
    ASSERT_NO_FATAL_FAILURE(run_a_beam(driver));
    driver.window->draw_into(motion(folder.path() / "swing", 200.0));
    for (int i = 0; i < 8; ++i) driver.frame();
    EXPECT_TRUE(fs::exists(folder.path() / "swing.part"));
    driver.click("film/cancel");
    driver.settle();
    EXPECT_TRUE(fs::is_empty(folder.path()));
    EXPECT_FALSE(driver.has("film/cancel"));
}

TEST(Picture, AFilmIsWrittenWhereFfmpegIs) {
    if (!platform::can_write_films()) GTEST_SKIP() << "skipped: no ffmpeg";
    const Folder folder("film's");
    Driver driver;
    driver.draw_pixels();
    ASSERT_NO_FATAL_FAILURE(run_a_beam(driver));
    driver.window->draw_into(motion(folder.path() / "swing.mp4", 20.0));
    for (int i = 0; i < 60 && !fs::exists(folder.path() / "swing.mp4"); ++i) driver.frame();
    const Result<std::string> film = read_file(folder.path() / "swing.mp4");
    ASSERT_TRUE(film);
    EXPECT_EQ(film->substr(4, 4), "ftyp") << "an MP4 file";
    EXPECT_NE(film->find("avc1"), std::string::npos) << "H.264";
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
}

TEST(Picture, PlotsAreSavedAsTheyAreSeen) {
    const Folder folder("plots");
    Driver driver;
    driver.draw_pixels();
    ASSERT_NO_FATAL_FAILURE(run_a_beam(driver));
    // Away from what has a tooltip.
    driver.window->input().push(ui::platform::MouseMoved{0.6f * static_cast<float>(driver.width), 5.0f});
    driver.settle();
    const platform::Image window = driver.picture();
    const platform::Rectangle first = driver.item("markers/plots");
    const fs::path before = fs::current_path();
    fs::current_path(folder.path());  // where the browser begins
    driver.click("markers/export");
    driver.click("markers/png");
    driver.click("browser/open");
    fs::current_path(before);
    for (int i = 0; i < 6; ++i) driver.frame();
    ASSERT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
    const platform::Image plots = read_png(fs::directory_iterator(folder.path())->path());
    ASSERT_GT(plots.width, 400);
    int alike = 0, all = 0;
    for (int y = 20; y < plots.height - 20; y += 5)
        for (int x = 20; x < plots.width - 20; x += 5, ++all)
            alike += plots.color(x, y) ==
                             window.color(x + static_cast<int>(first.lowest.x), y + static_cast<int>(first.lowest.y))
                         ? 1
                         : 0;
    EXPECT_GT(alike, 0.97 * all) << "no dialog in front";
}

TEST(Picture, WithoutFfmpegAFilmIsRefused) {
    const char* const path = std::getenv("PATH");
    const std::string before = path ? path : "";
    setenv("PATH", "/nowhere", 1);
    EXPECT_FALSE(platform::can_write_films());
    EXPECT_FALSE(platform::FilmWriter::begin("x.mp4", 320, 200, 30.0));
    setenv("PATH", before.c_str(), 1);
}

/// A picture of a beam with this background.
platform::Image picture_with(Driver& driver, const fs::path& path, panels::PictureBackground background) {
    panels::PictureRequest request{path, 640, 400};
    request.background = background;
    driver.window->draw_into(request);
    for (int i = 0; i < 100 && !fs::exists(path); ++i) driver.frame();
    return read_png(path);
}

TEST(Picture, HasAWhiteOrATransparentBackground) {
    const Folder folder("background");
    Driver driver;
    driver.draw_pixels();
    ASSERT_NO_FATAL_FAILURE(run_a_beam(driver));
    commands::ViewOptions options = driver.state().view;
    options.grid = false;
    driver.workbench->execute(commands::ChangeView{options});
    const platform::Image white = picture_with(driver, folder.path() / "white.png", panels::PictureBackground::white),
                          clear = picture_with(driver, folder.path() / "clear.png",
                                               panels::PictureBackground::transparent);
    EXPECT_EQ(white.color(2, 200), (std::array{255, 255, 255}));
    const auto alpha = [&](const platform::Image& image, int x, int y) {
        return image.rgba[4 * static_cast<std::size_t>(y * image.width + x) + 3];
    };
    EXPECT_EQ(alpha(white, 2, 200), 255);
    EXPECT_EQ(alpha(clear, 2, 200), 0);
    // On white paper the transparent picture is the white one.
    int opaque = 0, differing = 0;
    for (int y = 0; y < 400; ++y)
        for (int x = 0; x < 640; ++x) {
            const double a = alpha(clear, x, y) / 255.0;
            opaque += alpha(clear, x, y) == 255 ? 1 : 0;
            const auto colour = clear.color(x, y), on_white = white.color(x, y);
            for (std::size_t k = 0; k < 3; ++k)
                if (std::abs(a * colour[k] + (1.0 - a) * 255.0 - on_white[k]) > 6.0) {
                    ++differing;
                    break;
                }
        }
    EXPECT_GT(opaque, 2000) << "the body hides what is behind it";
    EXPECT_LT(differing, 400);
}

}  // namespace
}  // namespace myo::ui
