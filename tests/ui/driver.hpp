#pragma once

#include <memory>
#include <optional>
#include <string>

#include "panels/workbench_window.hpp"
#include "platform/image.hpp"
#include "platform/offscreen_context.hpp"
#include "ui/swinging_beam.hpp"

namespace myo::test {

/// Drives a workbench without a display through named items, as a user would with mouse and keyboard. Size in pixels.
/// Frames lay out everything and send it to OpenGL, but pixels are drawn only for those who look at them: drawing
/// them without a graphics card takes most of the time of a frame.
class Driver {
public:
    explicit Driver(int width = 1280, int height = 800);
    /// Uses another backend instead of the swinging beam. The member `backend` is then not the one in use.
    Driver(std::shared_ptr<ui::commands::Backend> backend, int width, int height);

    /// Draws one frame.
    ///
    /// @param seconds  since the last one
    void frame(double seconds = 1.0 / 60.0);
    /// Draws frames until every event has been consumed and has shown its effect.
    void settle();
    /// Draws a frame while a job runs in the background and leaves it time.
    void frame_beside_job();
    /// Draws frames until no job runs. Returns false after `seconds`.
    bool wait_for_job(int seconds = 20);

    /// Rectangle of an item. Opens the tasks one after another if it is not visible. Fails the test if it is in none of
    /// them.
    ui::platform::Rectangle item(const std::string& name);
    bool has(const std::string& name) { return window->items().find(name).has_value(); }

    // Input. Each call draws the frames that the input needs.
    void click(const std::string& name, int button = 0);
    void double_click(const std::string& name);
    void click_at(const ImVec2& place, int button = 0);
    void drag(const ImVec2& from, const ImVec2& to, int button = 0, ui::platform::Modifiers modifiers = {});
    void wheel(const ImVec2& place, float notches);
    void key(int key, ui::platform::Modifiers modifiers = {});
    void type(const std::string& text);

    const ui::commands::WorkbenchState& state() const { return workbench->state(); }
    /// Draws the pixels of this and all later frames.
    void draw_pixels();
    /// The window as it is now. Its pixels are drawn if they were not.
    ui::platform::Image picture();
    /// Opens the beam and waits for its mesh.
    void open_beam();

    int width, height;
    std::shared_ptr<SwingingBeam> backend = std::make_shared<SwingingBeam>();
    std::optional<ui::platform::OffscreenContext> context;
    std::optional<ui::commands::Workbench> workbench;
    std::optional<ui::panels::WorkbenchWindow> window;

private:
    bool pixels_ = false;
};

/// Opens the beam and runs it.
void run_a_beam(Driver& driver);

/// Pixel of the window at which a point of the scene [m] is drawn. Fails the test if it is not visible.
ImVec2 pixel_of(Driver& driver, const Eigen::Vector3d& point);

/// Whether an image has approximately this colour at most `radius` pixels from a place, in x and in y.
bool color_near(const ui::platform::Image& image, const ImVec2& place, const ImVec4& color, int radius);

/// Share of the pixels in a part of two images of equal size whose colours differ visibly: by more than 24 of 765 in
/// the sum of the channels.
double differing_share(const ui::platform::Image& a, const ui::platform::Image& b, const ui::platform::Rectangle& part);

}  // namespace myo::test
