#pragma once

#include "base/result.hpp"
#include "platform/gl_objects.hpp"

struct ImDrawData;
struct ImFontAtlas;

namespace myo::ui::platform {

/// Draws what Dear ImGui hands over. Its own OpenGL back end looks for libGL and so fails under OSMesa.
class ImguiRenderer {
public:
    static Result<ImguiRenderer> make();

    /// Uploads the font atlas; to be called again after the fonts were rebuilt.
    void upload_fonts(ImFontAtlas& atlas);

    /// Draws over what is there.
    /// @param framebuffer  0: that of the window
    void draw(const ImDrawData& data, GLuint framebuffer = 0) const;

private:
    gl::Program program_;
    gl::VertexArray vertex_array_;
    gl::Buffer vertices_;
    gl::Buffer indices_;
    gl::Texture fonts_;
    GLint display_ = -1;
};

}  // namespace myo::ui::platform
