#pragma once

#include <cstdint>
#include <optional>

#include "platform/gl_objects.hpp"
#include "platform/image.hpp"
#include "viewport/camera.hpp"
#include "viewport/scene.hpp"

namespace myo::ui::viewport {

/// Draws a scene off screen and keeps the picture, so that frames in which only the interface changed cost a copy.
class SceneRenderer {
public:
    static Result<SceneRenderer> make();

    /// Draws if anything differs from last time. `revision` stands for the scene and the colours: same number, same
    /// content.
    /// @param samples  0 while something moves, 4 at rest
    /// @param scale    of the widths of lines and edges and the least sizes of markers
    /// Error: the driver refuses the size.
    Result<void> update(const DrawnScene& scene, std::uint64_t revision, const ViewColors& colors, const Camera& camera,
                        const ViewSize& size, int samples, double scale);

    /// Where the picture was drawn last, to draw over it.
    GLuint framebuffer() const { return picture_.framebuffer.name(); }
    platform::Image read() const;

    /// Copies the picture into the default framebuffer, lower left corner at (x, y).
    void blit_to_window(int x, int y) const;

    /// Pictures drawn so far: tests see that idle frames draw none.
    int draw_count() const { return draw_count_; }

private:
    struct Program {
        platform::gl::Program program;
        platform::gl::VertexArray vertex_array;
        platform::gl::Buffer buffer;
    };
    struct Key {
        std::uint64_t revision = 0;
        Camera camera;
        ViewSize size;
        int samples = 0;
        double scale = 1.0;
        bool operator==(const Key&) const = default;
    };
    Result<void> resize(const ViewSize& size, int samples);
    void upload_scene(const DrawnScene& scene);
    void draw_backdrop(const ViewColors& colors) const;
    void draw_lines(const std::vector<float>& segments, double width, double opacity) const;
    void draw_surface(const DrawnScene& scene, const ViewColors& colors) const;
    void draw_markers(const DrawnScene& scene, bool ring, double opacity) const;
    void set_camera(const platform::gl::Program& program) const;

    Program surface_, line_, marker_, backdrop_;
    platform::gl::Texture color_map_;
    platform::gl::RenderTarget target_;   // multisampled
    platform::gl::RenderTarget picture_;  // resolved
    std::optional<Key> drawn_;
    std::optional<std::uint64_t> uploaded_;
    Eigen::Matrix4f view_ = Eigen::Matrix4f::Identity();
    Eigen::Matrix4f projection_ = Eigen::Matrix4f::Identity();
    ViewSize size_;
    float scale_ = 1.0f;
    int draw_count_ = 0;
};

}  // namespace myo::ui::viewport
