#include <gtest/gtest.h>

#include <cstdlib>
#include <iterator>
#include <random>

#include "ui/driver.hpp"

namespace myo {
namespace {

using test::Driver;

/// A person who does anything: clicks on what is there and beside it, drags, turns the wheel, presses keys, types.
class Monkey {
public:
    Monkey(Driver& driver, unsigned seed) : driver_(driver), random_(seed) {}

    void act() {
        const int kind = below(100);
        if (kind < 45)
            click(below(10) < 8 ? 0 : 1 + below(2));
        else if (kind < 65)
            drag();
        else if (kind < 72)
            push(ui::platform::MouseWheel{0.0f, static_cast<float>(below(5) - 2)});
        else if (kind < 90)
            press_key();
        else
            type();
    }
    int events() const { return events_; }
    void push(const ui::platform::InputEvent& event) {
        driver_.window->input().push(event);
        ++events_;
    }

private:
    int below(int n) { return static_cast<int>(random_() % static_cast<unsigned>(n)); }
    float within(float size) { return static_cast<float>(below(10000)) * 1e-4f * size; }

    /// Mostly on something.
    ImVec2 place() {
        const auto& items = driver_.window->items().all();
        if (items.empty() || below(10) < 2)
            return {within(static_cast<float>(driver_.width)), within(static_cast<float>(driver_.height))};
        auto item = items.begin();
        std::advance(item, below(static_cast<int>(items.size())));
        const ui::platform::Rectangle& r = item->second;
        return {r.lowest.x + within(r.width()), r.lowest.y + within(r.height())};
    }
    void click(int button) {
        const ImVec2 at = place();
        push(ui::platform::MouseMoved{at.x, at.y});
        for (int i = below(8) == 0 ? 2 : 1; i > 0; --i) {
            push(ui::platform::MouseButton{button, true, {below(12) == 0, below(12) == 0, false}});
            push(ui::platform::MouseButton{button, false, {}});
        }
    }
    void drag() {
        const ImVec2 from = place(), to = place();
        push(ui::platform::MouseMoved{from.x, from.y});
        push(ui::platform::MouseButton{below(4) == 0 ? 1 : 0, true, {}});
        for (int i = 1; i <= 3; ++i)
            push(ui::platform::MouseMoved{from.x + (to.x - from.x) * static_cast<float>(i) / 3.0f,
                                          from.y + (to.y - from.y) * static_cast<float>(i) / 3.0f});
        for (int button = 0; button < 2; ++button) push(ui::platform::MouseButton{button, false, {}});
    }
    void press_key() {
        const int key = below(ui::platform::key_count);
        push(ui::platform::KeyPressed{key, true, {below(3) == 0, below(6) == 0, false}});
        push(ui::platform::KeyPressed{key, false, {}});
    }
    void type() {
        static const std::string letters = "0123456789.-eE+ abcxyz/\\~,\"'";
        for (int i = 1 + below(4); i > 0; --i)
            push(ui::platform::TextTyped{static_cast<unsigned char>(
                letters[static_cast<std::size_t>(below(static_cast<int>(letters.size())))])});
    }

    Driver& driver_;
    std::mt19937 random_;
    int events_ = 0;
};

/// Number of events: MYOLOOP_EVENTS, or what takes seconds. tests/random_input.sh runs many, with sanitizers.
int wanted_events() {
    const char* const text = std::getenv("MYOLOOP_EVENTS");
    return text ? std::atoi(text) : 3000;
}

/// Thousands of events must neither crash nor hang nor bring forth numbers that are none.
TEST(RandomInput, NeverBreaksTheWorkbench) {
    Driver driver(1000, 700);
    driver.open_beam();
    Monkey monkey(driver, 7);
    int opened = 0;
    for (const int events = wanted_events(); monkey.events() < events;) {
        monkey.act();
        do {
            driver.frame();
            // Nothing is written where a person did not say so.
            if (driver.has("browser/name"))
                monkey.push(ui::platform::KeyPressed{ImGuiKey_Escape, true, {}}),
                    monkey.push(ui::platform::KeyPressed{ImGuiKey_Escape, false, {}});
        } while (!driver.window->input().empty());
        ASSERT_TRUE(std::isfinite(driver.state().time_s));
        ASSERT_TRUE(driver.window->viewport().camera.target.allFinite());
        ASSERT_GT(driver.window->viewport().camera.distance, 0.0);
        ASSERT_EQ(driver.state().settings, ui::commands::within_limits(driver.state().settings));
        // A search through the disk may end anywhere; the beam comes back.
        if (!driver.state().scene && !driver.state().busy() && ++opened < 1000)
            driver.workbench->execute(ui::commands::Open{"/beam", std::nullopt});
        if (driver.state().job && monkey.events() % 7 == 0) driver.workbench->execute(ui::commands::Cancel{});
    }
    driver.workbench->execute(ui::commands::Cancel{});
    ASSERT_TRUE(driver.wait_for_job(60));
    EXPECT_FALSE(driver.state().log.empty());
}

}  // namespace
}  // namespace myo
