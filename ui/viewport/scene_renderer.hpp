#pragma once

#include <cstdint>
#include <optional>

#include "platform/gl_objects.hpp"
#include "platform/image.hpp"
#include "viewport/camera.hpp"
#include "viewport/scene.hpp"

namespace myo::ui::viewport {

/// Renders a scene into an off-screen image and keeps it, so that frames in which only the interface changed cost a
/// copy.
///
/// Owns its GPU objects; used on the UI thread with a current context.
class SceneRenderer {
public:
    /// Compiles the shaders and creates buffers and the colour texture. Error: a shader does not compile.
    static Result<SceneRenderer> make();

    /// Renders the scene if revision, camera, size, samples or scale differ from the last call.
    ///
    /// @param revision  stands for scene and colours: the caller gives equal content the same number, other content
    ///                  another one
    /// @param size  of the image [pixels]
    /// @param samples  per pixel: 0 while something moves, 4 at rest
    /// @param scale  of line widths, element edges and minimum marker sizes
    /// Error: the driver refuses the size.
    Result<void> update(const DrawnScene& scene, std::uint64_t revision, const ViewColors& colors, const Camera& camera,
                        const ViewSize& size, int samples, double scale);

    /// Framebuffer with the last image, to draw annotations over it.
    GLuint framebuffer() const { return picture_.framebuffer.name(); }
    /// Copies the last image into memory. Waits for the GPU.
    ///
    /// @param transparent  with the opacity of an image that was drawn without a background; otherwise opaque
    platform::Image read(bool transparent = false) const;

    /// Copies the last image into the window's framebuffer, its lower left corner at (x, y) [pixels]. Does nothing
    /// before the first update().
    void blit_to_window(int x, int y) const;

    /// Number of images rendered so far. Tests use it to verify that idle frames render none.
    int draw_count() const { return draw_count_; }

private:
    /// A shader with the vertex data that it draws.
    struct Program {
        platform::gl::Program program;
        platform::gl::VertexArray vertex_array;
        platform::gl::Buffer buffer;
    };
    /// All inputs of an image. An equal key means that the last image is still valid.
    struct Key {
        std::uint64_t revision = 0;
        Camera camera;
        ViewSize size;
        int samples = 0;
        double scale = 1.0;
        bool operator==(const Key&) const = default;
    };
    Result<void> resize(const ViewSize& size, int samples);
    /// Uploads positions, field values and tints of the surface. Only if the revision changed.
    void upload_scene(const DrawnScene& scene);
    /// Target and state of OpenGL for an image.
    void begin_drawing(const ViewSize& size, int samples) const;
    void end_drawing(int samples) const;
    void draw_lines_and_markers(const DrawnScene& scene) const;
    /// Layouts of the vertex data in the buffers of the programs.
    void describe_vertices() const;
    void draw_backdrop(const ViewColors& colors) const;
    void draw_lines(const std::vector<float>& segments, double width, double opacity) const;
    void draw_surface(const DrawnScene& scene, const ViewColors& colors) const;
    void draw_markers(const DrawnScene& scene, bool ring, double opacity) const;
    void set_camera(const platform::gl::Program& program) const;

    Program surface_, line_, marker_, backdrop_;
    platform::gl::Texture color_map_;        // one row per colour map, 256 wide
    platform::gl::RenderTarget target_;      // multisampled image
    platform::gl::RenderTarget picture_;     // resolved image
    std::optional<Key> drawn_;               // key of the last image; empty: none
    std::optional<std::uint64_t> uploaded_;  // revision of the vertex data on the GPU
    Eigen::Matrix4f view_ = Eigen::Matrix4f::Identity();
    Eigen::Matrix4f projection_ = Eigen::Matrix4f::Identity();
    ViewSize size_;
    float scale_ = 1.0f;
    int draw_count_ = 0;
};

}  // namespace myo::ui::viewport
