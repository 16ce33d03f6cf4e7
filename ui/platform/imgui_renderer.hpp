#pragma once

#include "base/result.hpp"
#include "platform/gl_objects.hpp"

struct ImDrawData;
struct ImFontAtlas;

namespace myo::ui::platform {

/// Draws the output of Dear ImGui through the functions of gl.hpp. ImGui's own OpenGL back end searches for libGL and
/// therefore fails with OSMesa. Used on the UI thread with a current context.
class ImguiRenderer {
public:
    /// Compiles the shader `interface` and creates the buffers. Error: the shader does not compile.
    static Result<ImguiRenderer> make();

    /// Copies the font atlas into a texture. Call it again whenever the fonts were rebuilt.
    void upload_fonts(ImFontAtlas& atlas);

    /// Draws the frame that ImGui::Render() produced over the present content of a framebuffer; does nothing for an
    /// empty display.
    ///
    /// @param framebuffer  0 is the framebuffer of the window
    void draw(const ImDrawData& data, GLuint framebuffer = 0) const;

private:
    gl::Program program_;
    gl::VertexArray vertex_array_;  // refilled for each draw list
    gl::Buffer vertices_;           // refilled for each draw list
    gl::Buffer indices_;
    gl::Texture fonts_;   // the font atlas
    GLint display_ = -1;  // location of the uniform with position and size of the display
};

}  // namespace myo::ui::platform
