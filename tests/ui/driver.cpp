#include "ui/driver.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <stdexcept>
#include <thread>

#include "platform/gl.hpp"

namespace myo::test {
namespace {

namespace gl = ui::platform::gl;

/// The OpenGL functions that draw pixels.
struct PixelFunctions {
    PFNGLCLEARPROC clear = gl::Clear;
    PFNGLDRAWARRAYSPROC draw_arrays = gl::DrawArrays;
    PFNGLDRAWARRAYSINSTANCEDPROC draw_instances = gl::DrawArraysInstanced;
    PFNGLDRAWELEMENTSBASEVERTEXPROC draw_elements = gl::DrawElementsBaseVertex;
    PFNGLBLITFRAMEBUFFERPROC blit = gl::BlitFramebuffer;
};

const PixelFunctions no_pixels{[](GLbitfield) {}, [](GLenum, GLint, GLsizei) {}, [](GLenum, GLint, GLsizei, GLsizei) {},
                               [](GLenum, GLsizei, GLenum, const void*, GLint) {},
                               [](GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLint, GLbitfield, GLenum) {}};

PixelFunctions loaded_functions;  // as the context's creation loaded them

void use(const PixelFunctions& functions) {
    gl::Clear = functions.clear;
    gl::DrawArrays = functions.draw_arrays;
    gl::DrawArraysInstanced = functions.draw_instances;
    gl::DrawElementsBaseVertex = functions.draw_elements;
    gl::BlitFramebuffer = functions.blit;
}

}  // namespace

Driver::Driver(int width_, int height_) : Driver(nullptr, width_, height_) {}

Driver::Driver(std::shared_ptr<ui::commands::Backend> other, int width_, int height_) : width(width_), height(height_) {
    auto made = ui::platform::OffscreenContext::make(width, height);
    if (!made) throw std::runtime_error(made.error().text());
    context = std::move(*made);
    if (other)
        workbench.emplace(std::move(other));
    else
        workbench.emplace(backend);
    auto opened = ui::panels::WorkbenchWindow::make(*workbench);
    if (!opened) throw std::runtime_error(opened.error().text());
    window = std::move(*opened);
    loaded_functions = PixelFunctions{};
    use(no_pixels);
    settle();
}

void Driver::draw_pixels() {
    if (pixels_) return;
    pixels_ = true;
    use(loaded_functions);
    // The view keeps its image while nothing changes; in another size it must draw it.
    for (const int wide : {width + 1, width, width}) {
        const auto drawn = window->draw_frame(wide, height, 0.0);
        ASSERT_TRUE(drawn) << drawn.error().text();
    }
}

void Driver::frame(double seconds) {
    const auto drawn = window->draw_frame(width, height, seconds);
    ASSERT_TRUE(drawn) << drawn.error().text();
}

void Driver::settle() {
    do frame();
    while (!window->input().empty());
    for (int i = 0; i < 3; ++i) frame();
}

void Driver::frame_beside_job() {
    frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

bool Driver::wait_for_job(int seconds) {
    using std::chrono::milliseconds;
    const auto begin = std::chrono::steady_clock::now(), end = begin + std::chrono::seconds(seconds);
    for (auto now = begin; now < end; now = std::chrono::steady_clock::now()) {
        frame();
        if (!state().busy()) {
            settle();
            return true;
        }
        // A long job needs the processors more than the picture does.
        const auto waited = std::chrono::duration_cast<milliseconds>(now - begin);
        std::this_thread::sleep_for(std::clamp(waited / 20, milliseconds(2), milliseconds(200)));
    }
    return false;
}

ui::platform::Rectangle Driver::item(const std::string& name) {
    auto found = window->items().find(name);
    // As a person would, look through the steps.
    for (std::size_t i = 0; i < ui::commands::all_tasks.size() && !found &&
                            has(std::string("task/") + ui::commands::task_id(ui::commands::all_tasks[i]));
         ++i) {
        click(std::string("task/") + ui::commands::task_id(ui::commands::all_tasks[i]));
        found = window->items().find(name);
    }
    EXPECT_TRUE(found) << "no item " << name << " is shown";
    return found.value_or(ui::platform::Rectangle{});
}

void Driver::click(const std::string& name, int button) { click_at(item(name).center(), button); }

void Driver::click_at(const ImVec2& place, int button) {
    window->input().push(ui::platform::MouseMoved{place.x, place.y});
    window->input().push(ui::platform::MouseButton{button, true, {}});
    window->input().push(ui::platform::MouseButton{button, false, {}});
    settle();
}

void Driver::double_click(const std::string& name) {
    const ImVec2 place = item(name).center();
    window->input().push(ui::platform::MouseMoved{place.x, place.y});
    for (const bool down : {true, false, true, false}) window->input().push(ui::platform::MouseButton{0, down, {}});
    settle();
}

void Driver::drag(const ImVec2& from, const ImVec2& to, int button, ui::platform::Modifiers modifiers) {
    window->input().push(ui::platform::MouseMoved{from.x, from.y});
    window->input().push(ui::platform::MouseButton{button, true, modifiers});
    for (int i = 1; i <= 4; ++i) {
        const float s = static_cast<float>(i) / 4.0f;
        window->input().push(ui::platform::MouseMoved{from.x + s * (to.x - from.x), from.y + s * (to.y - from.y)});
        frame();
        frame();
    }
    window->input().push(ui::platform::MouseButton{button, false, {}});
    settle();
}

void Driver::wheel(const ImVec2& place, float notches) {
    window->input().push(ui::platform::MouseMoved{place.x, place.y});
    settle();
    window->input().push(ui::platform::MouseWheel{0.0f, notches});
    settle();
}

void Driver::key(int key, ui::platform::Modifiers modifiers) {
    window->input().push(ui::platform::KeyPressed{key, true, modifiers});
    window->input().push(ui::platform::KeyPressed{key, false, {}});
    settle();
}

void Driver::type(const std::string& text) {
    for (const char c : text) window->input().push(ui::platform::TextTyped{static_cast<unsigned char>(c)});
    settle();
}

ui::platform::Image Driver::picture() {
    draw_pixels();
    return ui::platform::read_frame(width, height);
}

void Driver::open_beam() {
    window->open("/beam");
    ASSERT_TRUE(wait_for_job());
    ASSERT_TRUE(state().body);
}

void run_a_beam(Driver& driver) {
    driver.open_beam();
    driver.click("run/run");
    ASSERT_TRUE(driver.wait_for_job());
}

ImVec2 pixel_of(Driver& driver, const Eigen::Vector3d& point) {
    const ui::viewport::ViewportState& view = driver.window->viewport();
    const auto p = ui::viewport::project(view.camera, view.size(), point);
    EXPECT_TRUE(p);
    return {view.pixels.lowest.x + static_cast<float>(p->x()), view.pixels.lowest.y + static_cast<float>(p->y())};
}

double differing_share(const ui::platform::Image& a, const ui::platform::Image& b,
                       const ui::platform::Rectangle& part) {
    double differ = 0.0, all = 0.0;
    for (int y = static_cast<int>(part.lowest.y); y < std::min(a.height, static_cast<int>(part.highest.y)); ++y)
        for (int x = static_cast<int>(part.lowest.x); x < std::min(a.width, static_cast<int>(part.highest.x)); ++x) {
            const std::array<int, 3> p = a.color(x, y), q = b.color(x, y);
            all += 1.0;
            differ += std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) + std::abs(p[2] - q[2]) > 24 ? 1.0 : 0.0;
        }
    return differ / std::max(1.0, all);
}

bool color_near(const ui::platform::Image& image, const ImVec2& place, const ImVec4& color, int radius) {
    const auto distance = [&](const std::array<int, 3>& seen) {
        return std::abs(seen[0] - static_cast<int>(255 * color.x)) +
               std::abs(seen[1] - static_cast<int>(255 * color.y)) +
               std::abs(seen[2] - static_cast<int>(255 * color.z));
    };
    for (int dy = -radius; dy <= radius; ++dy) {
        for (int dx = -radius; dx <= radius; ++dx) {
            const int x = static_cast<int>(place.x) + dx, y = static_cast<int>(place.y) + dy;
            if (x < 0 || y < 0 || x >= image.width || y >= image.height) continue;
            if (distance(image.color(x, y)) < 90) return true;
        }
    }
    return false;
}

}  // namespace myo::test
