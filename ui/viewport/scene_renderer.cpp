#include "viewport/scene_renderer.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "viewport/color_map.hpp"
#include "viewport/scene_lines.hpp"

namespace myo::ui::viewport {
namespace {

constexpr int segment_floats = 10;    // see append_segments()
constexpr int marker_floats = 7;      // position (3) and colour (4)
constexpr double min_opacity = 0.22;  // minimum opacity of what an opaque body hides

// Rows of the colour texture: the maps to choose from, then the one for signed values.
int color_rows() { return static_cast<int>(color_maps().size()) + 1; }

/// Texture coordinate of a field's colour map. Rows are sampled at their middle, so that filtering does not mix two
/// maps.
float color_row(const std::optional<DrawnField>& field) {
    const int row = !field ? 0 : field->diverging ? color_rows() - 1 : field->color_map;
    return (static_cast<float>(row) + 0.5f) / static_cast<float>(color_rows());
}

/// Vertex data of the markers of one kind. Spheres and rings need separate draw calls.
std::vector<float> marker_data(const std::vector<DrawnMarker>& markers, bool ring) {
    std::vector<float> data;
    for (const DrawnMarker& marker : markers) {
        if (marker.ring != ring || !marker.position.allFinite()) continue;
        for (int k = 0; k < 3; ++k) data.push_back(static_cast<float>(marker.position[k]));
        for (int k = 0; k < 4; ++k) data.push_back(marker.color[k]);
    }
    return data;
}

/// The rows of the texture: 256 colours of each map, the diverging one last.
std::vector<unsigned char> color_map_pixels() {
    std::vector<unsigned char> pixels;
    const auto append_row = [&](Eigen::Vector3f (*color)(double)) {
        for (int i = 0; i < 256; ++i) {
            const Eigen::Vector3f c = color(i / 255.0);
            for (int k = 0; k < 3; ++k) pixels.push_back(static_cast<unsigned char>(std::lround(255.0f * c[k])));
            pixels.push_back(255);
        }
    };
    for (const ColorMap& map : color_maps()) append_row(map.color);
    append_row(diverging_color_map);
    return pixels;
}

}  // namespace

void SceneRenderer::describe_vertices() const {
    const auto bind = [](const Program& p) {
        platform::gl::BindVertexArray(p.vertex_array.name());
        platform::gl::BindBuffer(GL_ARRAY_BUFFER, p.buffer.name());
    };
    bind(surface_);
    platform::gl::attribute(0, 3, surface_floats, 0);
    platform::gl::attribute(1, 1, surface_floats, 3);
    platform::gl::attribute(2, 4, surface_floats, 4);
    bind(line_);
    platform::gl::attribute(0, 3, segment_floats, 0, 1);
    platform::gl::attribute(1, 3, segment_floats, 3, 1);
    platform::gl::attribute(2, 4, segment_floats, 6, 1);
    bind(marker_);
    platform::gl::attribute(0, 3, marker_floats, 0);
    platform::gl::attribute(1, 4, marker_floats, 3);
    platform::gl::BindVertexArray(0);
}

Result<SceneRenderer> SceneRenderer::make() {
    SceneRenderer renderer;
    // The four shaders and the members they are stored in.
    const std::pair<const char*, Program*> programs[] = {{"surface", &renderer.surface_},
                                                         {"line", &renderer.line_},
                                                         {"marker", &renderer.marker_},
                                                         {"backdrop", &renderer.backdrop_}};
    for (const auto& [name, slot] : programs) {
        auto program = platform::gl::make_program(name);
        if (!program) return program.error();
        slot->program = std::move(*program);
        slot->vertex_array = platform::gl::make_vertex_array();
        slot->buffer = platform::gl::make_buffer();
    }
    renderer.describe_vertices();
    // All colour maps go into one texture, one row each, so that changing the map changes only a number.
    const std::vector<unsigned char> pixels = color_map_pixels();
    renderer.color_map_ = platform::gl::make_texture(256, color_rows(), pixels.data());
    return renderer;
}

Result<void> SceneRenderer::resize(const ViewSize& size, int samples) {
    if (picture_.width != size.width || picture_.height != size.height) {
        // The resolved image is always needed; the multisampled one only while the view is at rest.
        auto picture = platform::gl::make_render_target(size.width, size.height, 0);
        if (!picture) return picture.error();
        picture_ = std::move(*picture);
    }
    if (samples > 0 && (target_.width != size.width || target_.height != size.height || target_.samples != samples)) {
        auto target = platform::gl::make_render_target(size.width, size.height, samples);
        if (!target) return target.error();
        target_ = std::move(*target);
    }
    return {};
}

void SceneRenderer::set_camera(const platform::gl::Program& program) const {
    platform::gl::UseProgram(program.name());
    platform::gl::UniformMatrix4fv(platform::gl::uniform(program, "view"), 1, GL_FALSE, view_.data());
    platform::gl::UniformMatrix4fv(platform::gl::uniform(program, "projection"), 1, GL_FALSE, projection_.data());
}

void SceneRenderer::draw_backdrop(const ViewColors& colors) const {
    // The background ignores depth, so that everything else is drawn over it.
    platform::gl::Disable(GL_DEPTH_TEST);
    platform::gl::UseProgram(backdrop_.program.name());
    platform::gl::Uniform3f(platform::gl::uniform(backdrop_.program, "top"), colors.top[0], colors.top[1],
                            colors.top[2]);
    platform::gl::Uniform3f(platform::gl::uniform(backdrop_.program, "bottom"), colors.bottom[0], colors.bottom[1],
                            colors.bottom[2]);
    platform::gl::BindVertexArray(backdrop_.vertex_array.name());
    platform::gl::DrawArrays(GL_TRIANGLES, 0, 3);
    platform::gl::Enable(GL_DEPTH_TEST);
}

void SceneRenderer::draw_lines(const std::vector<float>& segments, double width, double opacity) const {
    if (segments.empty()) return;
    // Lines are quads expanded in the shader, as OpenGL 3.3 core does not draw lines wider than one pixel portably.
    set_camera(line_.program);
    platform::gl::Uniform2f(platform::gl::uniform(line_.program, "size"), static_cast<float>(size_.width),
                            static_cast<float>(size_.height));
    platform::gl::Uniform1f(platform::gl::uniform(line_.program, "width"), scale_ * static_cast<float>(width));
    platform::gl::Uniform1f(platform::gl::uniform(line_.program, "opacity"), static_cast<float>(opacity));
    platform::gl::BindVertexArray(line_.vertex_array.name());
    platform::gl::upload(line_.buffer, segments);
    platform::gl::DrawArraysInstanced(GL_TRIANGLES, 0, 6, static_cast<GLsizei>(segments.size() / segment_floats));
}

void SceneRenderer::upload_scene(const DrawnScene& scene) {
    if (!scene.surface) return;
    Eigen::VectorXd levels;
    if (scene.field) {
        // Levels run from 0 to 1 over the range. A range without extent must not divide by zero.
        const double span = scene.field->highest - scene.field->lowest;
        levels = (scene.field->values.array() - scene.field->lowest) / (span > 0.0 ? span : 1.0);
    }
    platform::gl::upload(surface_.buffer, surface_vertices(*scene.surface, scene.positions, levels, scene.tints));
}

void SceneRenderer::draw_surface(const DrawnScene& scene, const ViewColors& colors) const {
    if (!scene.surface || scene.surface->corners.empty()) return;
    const platform::gl::Program& p = surface_.program;
    set_camera(p);
    platform::gl::Uniform1i(platform::gl::uniform(p, "face_nodes"), scene.surface->face_nodes);
    platform::gl::Uniform3f(platform::gl::uniform(p, "base_color"), colors.body[0], colors.body[1], colors.body[2]);
    platform::gl::Uniform4f(platform::gl::uniform(p, "edge_color"), colors.edge[0], colors.edge[1], colors.edge[2],
                            colors.edge[3]);
    platform::gl::Uniform1f(platform::gl::uniform(p, "edge_width"), scene.edges ? 0.8f : 0.0f);
    platform::gl::Uniform1f(platform::gl::uniform(p, "scale"), scale_);
    platform::gl::Uniform1f(platform::gl::uniform(p, "opacity"), static_cast<float>(scene.body_opacity));
    platform::gl::Uniform1i(platform::gl::uniform(p, "use_field"), scene.field ? 1 : 0);
    platform::gl::Uniform1f(platform::gl::uniform(p, "color_row"), color_row(scene.field));
    platform::gl::Uniform1i(platform::gl::uniform(p, "color_map"), 0);
    platform::gl::ActiveTexture(GL_TEXTURE0);
    platform::gl::BindTexture(GL_TEXTURE_2D, color_map_.name());
    if (scene.surface->closed) platform::gl::Enable(GL_CULL_FACE);
    platform::gl::CullFace(GL_BACK);
    platform::gl::BindVertexArray(surface_.vertex_array.name());
    platform::gl::DrawArrays(GL_TRIANGLES, 0, static_cast<GLsizei>(scene.surface->corners.size()));
    platform::gl::Disable(GL_CULL_FACE);
}

void SceneRenderer::draw_markers(const DrawnScene& scene, bool ring, double opacity) const {
    const std::vector<float> data = marker_data(scene.markers, ring);
    if (data.empty()) return;
    const platform::gl::Program& p = marker_.program;
    set_camera(p);
    platform::gl::Uniform1f(platform::gl::uniform(p, "radius"),
                            // Sizes on screen are limited: markers stay visible from afar and do not cover the body
                            // from nearby.
                            static_cast<float>(scene.marker_radius * (ring ? 1.55 : 1.0)));
    platform::gl::Uniform2f(platform::gl::uniform(p, "pixel_limits"), scale_ * (ring ? 6.5f : 4.0f),
                            scale_ * (ring ? 40.0f : 30.0f));
    platform::gl::Uniform1f(platform::gl::uniform(p, "view_height"), static_cast<float>(size_.height));
    platform::gl::Uniform1f(platform::gl::uniform(p, "opacity"), static_cast<float>(opacity));
    platform::gl::Uniform1i(platform::gl::uniform(p, "ring"), ring ? 1 : 0);
    platform::gl::BindVertexArray(marker_.vertex_array.name());
    platform::gl::upload(marker_.buffer, data);
    platform::gl::DrawArrays(GL_POINTS, 0, static_cast<GLsizei>(data.size() / marker_floats));
}

void SceneRenderer::begin_drawing(const ViewSize& size, int samples) const {
    const platform::gl::RenderTarget& target = samples > 0 ? target_ : picture_;
    platform::gl::BindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.name());
    platform::gl::Viewport(0, 0, size.width, size.height);
    platform::gl::Disable(GL_SCISSOR_TEST);
    platform::gl::Enable(GL_BLEND);
    platform::gl::Enable(GL_PROGRAM_POINT_SIZE);
    platform::gl::BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    platform::gl::DepthMask(GL_TRUE);
    platform::gl::DepthFunc(GL_LEQUAL);
    // Without a background what is blended over it gets colours multiplied by their opacity, see read_transparent().
    platform::gl::ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
    platform::gl::Clear(GL_DEPTH_BUFFER_BIT | GL_COLOR_BUFFER_BIT);
    platform::gl::Enable(GL_DEPTH_TEST);
}

void SceneRenderer::draw_lines_and_markers(const DrawnScene& scene) const {
    // One draw call per line width.
    std::map<double, std::vector<float>> by_width;
    for (const DrawnLine& line : scene.lines) append_segments(by_width[line.width], line);
    // First the parts that the body hides, drawn with low opacity so that no marker gets lost; then the visible parts.
    const double through = std::max(min_opacity, 1.0 - scene.body_opacity);
    platform::gl::DepthMask(GL_FALSE);
    for (const bool hidden : {true, false}) {
        platform::gl::DepthFunc(hidden ? GL_GREATER : GL_LEQUAL);
        const double opacity = hidden ? through : 1.0;
        for (const auto& [width, segments] : by_width) draw_lines(segments, width, opacity);
        if (!hidden) platform::gl::DepthMask(GL_TRUE);
        draw_markers(scene, false, opacity);
        draw_markers(scene, true, opacity);
    }
}

void SceneRenderer::end_drawing(int samples) const {
    platform::gl::DepthMask(GL_TRUE);
    platform::gl::DepthFunc(GL_LEQUAL);
    platform::gl::Disable(GL_DEPTH_TEST);
    platform::gl::Disable(GL_BLEND);
    platform::gl::BindVertexArray(0);
    if (samples > 0) platform::gl::blit(target_, picture_.framebuffer.name(), 0, 0);
    platform::gl::BindFramebuffer(GL_FRAMEBUFFER, 0);
}

Result<void> SceneRenderer::update(const DrawnScene& scene, std::uint64_t revision, const ViewColors& colors,
                                   const Camera& camera, const ViewSize& size, int samples, double scale) {
    const Key key{revision, camera, size, samples, scale};
    // Most frames change only the interface. They reuse the image and cost a copy.
    if (drawn_ && *drawn_ == key) return {};
    if (const auto sized = resize(size, samples); !sized) return sized;
    if (!uploaded_ || *uploaded_ != revision) upload_scene(scene);
    uploaded_ = revision;
    size_ = size;
    scale_ = static_cast<float>(scale);
    view_ = view_matrix(camera).cast<float>();
    projection_ = projection_matrix(camera, size).cast<float>();

    begin_drawing(size, samples);
    if (!colors.transparent) draw_backdrop(colors);
    if (scene.grid) {
        // The grid writes no depth, so that it never hides what lies below it.
        platform::gl::DepthMask(GL_FALSE);
        draw_lines(grid_segments(scene.extent, colors.grid), 1.0, 1.0);
        platform::gl::DepthMask(GL_TRUE);
    }
    draw_surface(scene, colors);

    draw_lines_and_markers(scene);
    end_drawing(samples);
    drawn_ = key;
    ++draw_count_;
    return {};
}

platform::Image SceneRenderer::read(bool transparent) const {
    platform::Image image = platform::read_frame(picture_.width, picture_.height, picture_.framebuffer.name(),
                                                 transparent);
    platform::gl::BindFramebuffer(GL_FRAMEBUFFER, 0);
    return image;
}

void SceneRenderer::blit_to_window(int x, int y) const {
    if (picture_.width > 0) platform::gl::blit(picture_, 0, x, y);
}

}  // namespace myo::ui::viewport
