#include "platform/imgui_renderer.hpp"

#include <imgui.h>

#include <cstddef>
#include <cstdint>

namespace myo::ui::platform {
namespace {

// ImGui stores texture identifiers as pointers; these two convert an OpenGL name to one and back.
ImTextureID to_texture_id(GLuint name) { return reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(name)); }
GLuint to_name(ImTextureID id) { return static_cast<GLuint>(reinterpret_cast<std::uintptr_t>(id)); }

/// Vertex attribute of ImDrawVert; `offset` in bytes.
void attribute_at(GLuint index, int size, GLenum type, GLboolean normalized, std::size_t offset) {
    gl::EnableVertexAttribArray(index);
    gl::VertexAttribPointer(index, size, type, normalized, sizeof(ImDrawVert), reinterpret_cast<const void*>(offset));
}

}  // namespace

Result<ImguiRenderer> ImguiRenderer::make() {
    auto program = gl::make_program("interface");
    if (!program) return program.error();
    ImguiRenderer renderer;
    renderer.program_ = std::move(*program);
    renderer.display_ = gl::uniform(renderer.program_, "display");
    renderer.vertex_array_ = gl::make_vertex_array();
    renderer.vertices_ = gl::make_buffer();
    renderer.indices_ = gl::make_buffer();
    gl::BindVertexArray(renderer.vertex_array_.name());
    gl::BindBuffer(GL_ARRAY_BUFFER, renderer.vertices_.name());
    gl::BindBuffer(GL_ELEMENT_ARRAY_BUFFER, renderer.indices_.name());
    attribute_at(0, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, pos));
    attribute_at(1, 2, GL_FLOAT, GL_FALSE, offsetof(ImDrawVert, uv));
    attribute_at(2, 4, GL_UNSIGNED_BYTE, GL_TRUE, offsetof(ImDrawVert, col));
    gl::BindVertexArray(0);
    return renderer;
}

void ImguiRenderer::upload_fonts(ImFontAtlas& atlas) {
    unsigned char* pixels = nullptr;
    int width = 0;
    int height = 0;
    atlas.GetTexDataAsRGBA32(&pixels, &width, &height);
    fonts_ = gl::make_texture(width, height, pixels);
    // ImGui refers to the texture by this identifier in each draw command.
    atlas.SetTexID(to_texture_id(fonts_.name()));
    atlas.ClearTexData();
}

void ImguiRenderer::draw(const ImDrawData& data, GLuint framebuffer) const {
    const int height = static_cast<int>(data.DisplaySize.y);
    if (data.DisplaySize.x <= 0.0f || height <= 0) return;
    gl::BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl::Viewport(0, 0, static_cast<int>(data.DisplaySize.x), height);
    gl::Disable(GL_DEPTH_TEST);
    gl::Disable(GL_CULL_FACE);
    gl::Enable(GL_BLEND);
    gl::Enable(GL_SCISSOR_TEST);
    gl::BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    gl::UseProgram(program_.name());
    gl::Uniform4f(display_, data.DisplayPos.x, data.DisplayPos.y, data.DisplaySize.x, data.DisplaySize.y);
    gl::BindVertexArray(vertex_array_.name());
    gl::BindBuffer(GL_ARRAY_BUFFER, vertices_.name());
    gl::ActiveTexture(GL_TEXTURE0);
    for (int n = 0; n < data.CmdListsCount; ++n) {
        const ImDrawList& list = *data.CmdLists[n];
        gl::BufferData(GL_ARRAY_BUFFER, list.VtxBuffer.size_in_bytes(), list.VtxBuffer.Data, GL_STREAM_DRAW);
        gl::BufferData(GL_ELEMENT_ARRAY_BUFFER, list.IdxBuffer.size_in_bytes(), list.IdxBuffer.Data, GL_STREAM_DRAW);
        for (const ImDrawCmd& command : list.CmdBuffer) {
            // No panel submits callbacks, so commands with one carry no geometry.
            if (command.UserCallback != nullptr) continue;
            // ImGui clips from the upper left corner, glScissor counts from the lower left.
            const int left = static_cast<int>(command.ClipRect.x - data.DisplayPos.x);
            const int right = static_cast<int>(command.ClipRect.z - data.DisplayPos.x);
            const int top = static_cast<int>(command.ClipRect.y - data.DisplayPos.y);
            const int bottom = static_cast<int>(command.ClipRect.w - data.DisplayPos.y);
            if (right <= left || bottom <= top) continue;
            gl::Scissor(left, height - bottom, right - left, bottom - top);
            gl::BindTexture(GL_TEXTURE_2D, to_name(command.GetTexID()));
            gl::DrawElementsBaseVertex(GL_TRIANGLES, static_cast<GLsizei>(command.ElemCount),
                                       sizeof(ImDrawIdx) == 2 ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT,
                                       reinterpret_cast<const void*>(command.IdxOffset * sizeof(ImDrawIdx)),
                                       static_cast<GLint>(command.VtxOffset));
        }
    }
    gl::BindVertexArray(0);
    gl::Disable(GL_SCISSOR_TEST);
    gl::Disable(GL_BLEND);
}

}  // namespace myo::ui::platform
