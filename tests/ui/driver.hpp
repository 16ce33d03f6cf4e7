#pragma once

#include <memory>
#include <optional>
#include <string>

#include "panels/workbench_window.hpp"
#include "platform/image.hpp"
#include "platform/offscreen_context.hpp"
#include "ui/swinging_beam.hpp"

namespace myo::test {

/// A workbench without a display, driven by named items as a person would by mouse and keyboard.
class Driver {
public:
    explicit Driver(int width = 1280, int height = 800);
    /// Another backend than the beam.
    Driver(std::shared_ptr<ui::commands::Backend> backend, int width, int height);

    void frame(double seconds = 1.0 / 60.0);
    /// Frames until every event is consumed and has shown its effect.
    void settle();
    /// Frames until no job runs; false after that many seconds.
    bool wait_for_job(int seconds = 20);

    /// Looks through the steps for an item that is not shown. Asserts (gtest) that it is there.
    ui::platform::Rectangle item(const std::string& name);
    bool has(const std::string& name) { return window->items().find(name).has_value(); }

    void click(const std::string& name, int button = 0);
    void double_click(const std::string& name);
    void click_at(const ImVec2& place, int button = 0);
    void drag(const ImVec2& from, const ImVec2& to, int button = 0, ui::platform::Modifiers modifiers = {});
    void wheel(const ImVec2& place, float notches);
    void key(int key, ui::platform::Modifiers modifiers = {});
    void type(const std::string& text);

    const ui::commands::WorkbenchState& state() const { return workbench->state(); }
    ui::platform::Image picture();
    /// Opens the beam and waits for its mesh.
    void open_beam();

    int width, height;
    std::shared_ptr<SwingingBeam> backend = std::make_shared<SwingingBeam>();
    std::optional<ui::platform::OffscreenContext> context;
    std::optional<ui::commands::Workbench> workbench;
    std::optional<ui::panels::WorkbenchWindow> window;
};

/// Pixel of the window where a point of the scene [m] falls. Asserts (gtest) that it does.
ImVec2 pixel_of(Driver& driver, const Eigen::Vector3d& point);

/// Whether a picture has this colour, nearly, at most `radius` pixels from the place in x and in y.
bool color_near(const ui::platform::Image& image, const ImVec2& place, const ImVec4& color, int radius);

/// Share of the pixels in a part of two pictures of one size whose colours differ visibly, by more than 24 of 765 in
/// all.
double differing_share(const ui::platform::Image& a, const ui::platform::Image& b, const ui::platform::Rectangle& part);

}  // namespace myo::test
