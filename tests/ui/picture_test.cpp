#include <gtest/gtest.h>
#include <stb_image.h>

#include <array>
#include <cstdlib>
#include <set>

#include "base/files.hpp"
#include "platform/film.hpp"
#include "support/folder.hpp"
#include "ui/driver.hpp"

namespace myo {
namespace {

namespace fs = std::filesystem;
using test::Driver;
using test::Folder;

Image read_png(const fs::path& path) {
    Image image;
    int channels = 0;
    unsigned char* const pixels = stbi_load(path.c_str(), &image.width, &image.height, &channels, 4);
    EXPECT_TRUE(pixels) << path;
    if (!pixels) return image;
    image.rgba.assign(pixels, pixels + 4 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    stbi_image_free(pixels);
    return image;
}

void run_beam(Driver& driver) {
    driver.open_beam();
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
}

/// What the dialogs hand to the window.
PictureRequest motion(const fs::path& path, double rate_Hz) {
    PictureRequest request;
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
    ASSERT_NO_FATAL_FAILURE(run_beam(driver));
    driver.key(key_k, {.ctrl = true});
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
    const ViewSize view = driver.window->viewport().size();
    for (const int k : {1, 2}) {
        driver.window->draw_into({folder.path() / (std::to_string(k) + ".png"), k * view.width, k * view.height});
        driver.settle();
    }
    const Image once = read_png(folder.path() / "1.png"), twice = read_png(folder.path() / "2.png");
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
    EXPECT_GT(alike, 0.93 * all);   // all but edges
    EXPECT_GT(colours.size(), 30u);
}

TEST(Picture, NumberedOnesShowTheMotionOverItsTime) {
    const Folder folder("frames");
    Driver driver;
    ASSERT_NO_FATAL_FAILURE(run_beam(driver));
    driver.workbench->execute(command::SetTime{0.123});
    driver.settle();
    driver.window->draw_into(motion(folder.path() / "swing", 20.0));
    for (int i = 0; i < 40 && !fs::exists(folder.path() / "swing"); ++i) driver.frame();
    ASSERT_TRUE(fs::exists(folder.path() / "swing" / "frame_0011.png"));
    EXPECT_FALSE(fs::exists(folder.path() / "swing" / "frame_0012.png")) << "0 to 0.5 s, both included";
    std::set<std::string> different;
    for (const auto& entry : fs::directory_iterator(folder.path() / "swing")) different.insert(*read_file(entry.path()));
    EXPECT_EQ(different.size(), 11u);
    EXPECT_EQ(read_png(folder.path() / "swing" / "frame_0001.png").width, 320);
    driver.settle();
    EXPECT_DOUBLE_EQ(driver.state().time_s, 0.123) << "as before";
    EXPECT_EQ(driver.state().log.back().level, LogLevel::done);
    // A folder that is there is not touched.
    driver.window->draw_into(motion(folder.path() / "swing", 20.0));
    driver.settle();
    EXPECT_EQ(driver.state().log.back().level, LogLevel::failure);
}

TEST(Picture, GivenUpLeavesNothing) {
    const Folder folder("given_up");
    Driver driver;
    ASSERT_NO_FATAL_FAILURE(run_beam(driver));
    driver.window->draw_into(motion(folder.path() / "swing", 200.0));
    for (int i = 0; i < 8; ++i) driver.frame();
    EXPECT_TRUE(fs::exists(folder.path() / "swing.part"));
    driver.click("film/cancel");
    driver.settle();
    EXPECT_TRUE(fs::is_empty(folder.path()));
    EXPECT_FALSE(driver.has("film/cancel"));
}

TEST(Picture, AFilmIsWrittenWhereFfmpegIs) {
    if (!can_write_films()) GTEST_SKIP() << "skipped: no ffmpeg";
    const Folder folder("film's");
    Driver driver;
    ASSERT_NO_FATAL_FAILURE(run_beam(driver));
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
    ASSERT_NO_FATAL_FAILURE(run_beam(driver));
    const Image window = driver.picture();
    const Rectangle first = driver.item("markers/plots");
    const fs::path before = fs::current_path();
    fs::current_path(folder.path());   // where the browser begins
    driver.click("markers/export");
    driver.click("markers/png");
    driver.click("browser/open");
    fs::current_path(before);
    for (int i = 0; i < 6; ++i) driver.frame();
    ASSERT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1);
    const Image plots = read_png(fs::directory_iterator(folder.path())->path());
    ASSERT_GT(plots.width, 400);
    int alike = 0, all = 0;
    for (int y = 20; y < plots.height - 20; y += 5)
        for (int x = 20; x < plots.width - 20; x += 5, ++all) alike += plots.color(x, y) == window.color(x + static_cast<int>(first.lowest.x), y + static_cast<int>(first.lowest.y)) ? 1 : 0;
    EXPECT_GT(alike, 0.97 * all) << "no dialog in front";
}

TEST(Picture, WithoutFfmpegAFilmIsRefused) {
    const char* const path = std::getenv("PATH");
    const std::string before = path ? path : "";
    setenv("PATH", "/nowhere", 1);
    EXPECT_FALSE(can_write_films());
    EXPECT_FALSE(FilmWriter::begin("x.mp4", 320, 200, 30.0));
    setenv("PATH", before.c_str(), 1);
}

}  // namespace
}  // namespace myo
