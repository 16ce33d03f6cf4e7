#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "ui/bare_workbench.hpp"

// What is shown: trial, marker, time, playback, preferences, messages. Requests beyond their range are limited.

namespace myo::ui::shown_state {
namespace {

using test::BareWorkbench;

constexpr double first_s = -0.2, last_s = 2.0;  // of the beam's recordings

TEST(ShownState, ChoicesStayWithinTheirLists) {
    BareWorkbench bench;
    const auto choose = [&](int index) {
        bench.execute(commands::ChooseTrial{index});
        bench.execute(commands::ChooseMarker{index});
        bench.execute(commands::ChooseMuscle{index});
        return std::vector<int>{bench.state().trial, bench.state().marker, bench.state().muscle};
    };
    for (const int index : {-1, 0, 3}) EXPECT_EQ(choose(index), (std::vector<int>{0, 0, 0})) << "nothing is open";
    bench.open_beam();
    bench.change([](commands::Settings& s) { s.muscles.resize(3); }, "muscles");
    EXPECT_EQ(choose(-5), (std::vector<int>{0, 0, 0}));
    EXPECT_EQ(choose(1), (std::vector<int>{1, 1, 1}));
    EXPECT_EQ(choose(2), (std::vector<int>{1, 2, 2}));
    EXPECT_EQ(choose(99), (std::vector<int>{1, 3, 2}));
    // The last muscles go, and with them the choice.
    bench.change([](commands::Settings& s) { s.muscles.resize(1); }, "muscles");
    EXPECT_EQ(bench.state().muscle, 0);
    ASSERT_TRUE(bench.state().chosen_muscle());
    bench.change([](commands::Settings& s) { s.muscles.clear(); }, "muscles");
    EXPECT_EQ(bench.state().muscle, 0);
    EXPECT_FALSE(bench.state().chosen_muscle());
    EXPECT_FALSE(bench.state().chosen_paint());
}

TEST(ShownState, TheTimeStaysWithinTheTrial) {
    BareWorkbench bench;
    bench.execute(commands::SetTime{1.0});
    EXPECT_EQ(bench.state().time_s, 0.0) << "nothing is open";
    bench.open_beam();
    EXPECT_EQ(bench.state().time_s, 0.0);
    for (const double t : {first_s, 0.3, last_s}) {
        bench.execute(commands::SetTime{t});
        EXPECT_EQ(bench.state().time_s, t);
    }
    bench.execute(commands::SetTime{std::nextafter(last_s, 3.0)});
    EXPECT_EQ(bench.state().time_s, last_s);
    bench.execute(commands::SetTime{-1e9});
    EXPECT_EQ(bench.state().time_s, first_s);
    bench.execute(commands::SetTime{0.3});
    constexpr double infinite = std::numeric_limits<double>::infinity();
    for (const double t : {infinite, -infinite, std::numeric_limits<double>::quiet_NaN()}) {
        bench.execute(commands::SetTime{t});
        EXPECT_EQ(bench.state().time_s, 0.3) << t;
    }
    // Another trial begins at the release, and stands still.
    bench.execute(commands::Play{});
    bench.execute(commands::ChooseTrial{1});
    EXPECT_EQ(bench.state().time_s, 0.0);
    EXPECT_FALSE(bench.state().playing);
}

TEST(ShownState, PlaysAtItsSpeedFromTheStartToTheEnd) {
    BareWorkbench bench;
    bench.execute(commands::Play{});
    EXPECT_FALSE(bench.state().playing) << "nothing is open";
    bench.open_beam();
    bench.execute(commands::SetSpeed{2.0});
    bench.execute(commands::SetTime{0.1});
    bench.workbench.advance(0.25);
    EXPECT_EQ(bench.state().time_s, 0.1) << "not before it plays";
    bench.execute(commands::Play{});
    EXPECT_TRUE(bench.workbench.animating());
    EXPECT_EQ(bench.state().time_s, 0.1);
    bench.workbench.advance(0.25);
    EXPECT_DOUBLE_EQ(bench.state().time_s, 0.6);
    bench.execute(commands::Play{false});
    bench.workbench.advance(0.25);
    EXPECT_DOUBLE_EQ(bench.state().time_s, 0.6);
    bench.execute(commands::Play{});
    bench.workbench.advance(100.0);
    EXPECT_EQ(bench.state().time_s, last_s);
    EXPECT_FALSE(bench.state().playing);
    EXPECT_FALSE(bench.workbench.animating());
    bench.execute(commands::Play{});
    EXPECT_EQ(bench.state().time_s, first_s) << "again from the beginning";
}

TEST(ShownState, SpeedFrequencyAndScaleHaveLimits) {
    BareWorkbench bench;
    struct Limited {
        double asked, speed, frequency_Hz, scale;
    };
    for (const Limited& limited : {Limited{1.0, 1.0, 1.0, 1.0}, Limited{1e-9, 0.01, 0.01, 0.75},
                                   Limited{-3.0, 0.01, 0.01, 0.75}, Limited{1e9, 10.0, 1000.0, 2.5}}) {
        bench.execute(commands::SetSpeed{limited.asked});
        bench.execute(commands::SetDampingFrequency{limited.asked});
        bench.execute(commands::SetTheme{platform::ThemeName::light, static_cast<float>(limited.asked)});
        EXPECT_EQ(bench.state().speed, limited.speed) << limited.asked;
        EXPECT_EQ(bench.state().damping_frequency_Hz, limited.frequency_Hz) << limited.asked;
        EXPECT_FLOAT_EQ(bench.state().scale(), static_cast<float>(limited.scale)) << limited.asked;
        EXPECT_EQ(bench.state().preferences.theme, platform::ThemeName::light);
    }
    // Stored preferences may be of another version; none at all is left to the screen.
    commands::Preferences preferences;
    for (const auto& [stored, kept, used] : std::vector<std::array<float, 3>>{
             {0.0f, 0.0f, 1.0f}, {0.1f, 0.75f, 0.75f}, {1.25f, 1.25f, 1.25f}, {40.0f, 2.5f, 2.5f}}) {
        preferences.scale = stored;
        bench.execute(commands::UsePreferences{preferences});
        EXPECT_EQ(bench.state().preferences.scale, kept);
        EXPECT_EQ(bench.state().scale(), used);
    }
}

TEST(ShownState, BookmarksAndLateFilesAreListedOnce) {
    BareWorkbench bench;
    using Paths = std::vector<std::filesystem::path>;
    for (const char* folder : {"/a", "/b", "/a"}) bench.execute(commands::Bookmark{folder});
    EXPECT_EQ(bench.state().preferences.bookmarks, (Paths{"/b", "/a"}));
    bench.execute(commands::Bookmark{"/b", false});
    bench.execute(commands::Bookmark{"/c", false});
    EXPECT_EQ(bench.state().preferences.bookmarks, (Paths{"/a"}));
    commands::Preferences preferences;
    for (std::size_t k = 0; k < commands::max_recent; ++k) preferences.recent.push_back("/late" + std::to_string(k));
    bench.execute(commands::UsePreferences{preferences});
    // One of the list moves to its front; a new one drops the oldest; what cannot be opened is none.
    for (const char* path : {"/late7", "/folder/../new/", "/missing"}) bench.execute_and_wait(commands::Open{path, {}});
    const Paths& recent = bench.state().preferences.recent;
    ASSERT_EQ(recent.size(), commands::max_recent);
    EXPECT_EQ(recent[0], "/new");
    EXPECT_EQ(recent[1], "/late7");
    EXPECT_EQ(recent[2], "/late0");
    EXPECT_EQ(recent.back(), "/late8");
}

TEST(ShownState, MessagesAreCountedAlsoAfterTheyAreGone) {
    BareWorkbench bench;
    constexpr std::size_t asked = commands::max_log_lines + 1;
    for (std::size_t k = 0; k < asked; ++k)
        bench.execute(commands::LogMessage{commands::LogLevel::warning, std::to_string(k)});
    EXPECT_EQ(bench.state().logged, asked);
    EXPECT_EQ(bench.state().log.size(), asked - commands::max_log_lines / 10);
    EXPECT_EQ(bench.state().log.back().text, std::to_string(asked - 1));
    EXPECT_EQ(bench.state().log.back().level, commands::LogLevel::warning);
    EXPECT_EQ(bench.state().log.front().text, std::to_string(commands::max_log_lines / 10)) << "the oldest are gone";
    bench.execute(commands::ClearLog{});
    EXPECT_TRUE(bench.state().log.empty());
    EXPECT_EQ(bench.state().logged, asked);
    EXPECT_EQ(commands::log_level(commands::CheckState::green), commands::LogLevel::done);
    EXPECT_EQ(commands::log_level(commands::CheckState::amber), commands::LogLevel::warning);
    EXPECT_EQ(commands::log_level(commands::CheckState::red), commands::LogLevel::failure);
}

TEST(ShownState, WithoutABodyNothingIsComputed) {
    BareWorkbench bench;
    const std::vector<commands::Command> jobs{commands::Run{}, commands::Calibrate{}, commands::Optimize{},
                                              commands::Diagnose{}};
    for (const commands::Command& job : jobs) {
        bench.execute(job);
        EXPECT_FALSE(bench.state().busy());
        EXPECT_EQ(bench.last_message(), "Open an experiment folder first.");
        bench.execute(commands::ClearLog{});
    }
    bench.execute(commands::BuildMesh{});
    bench.execute(commands::Undo{});
    bench.execute(commands::Paint{});
    bench.execute(commands::RestoreRecord{1});
    bench.execute(commands::AddEffect{"linear_drag"});
    bench.execute(commands::DeclareEffect{});
    bench.execute(commands::SaveDeclaration{});
    bench.execute(commands::Cancel{});
    EXPECT_FALSE(bench.state().busy());
    EXPECT_FALSE(bench.state().unsaved());
    EXPECT_EQ(bench.settings().material, "neo_hookean") << "the first of its list, so that panels find it";
    EXPECT_EQ(bench.settings().integrator, "tr_bdf2");
}

}  // namespace
}  // namespace myo::ui::shown_state
