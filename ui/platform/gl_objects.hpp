#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/result.hpp"
#include "platform/gl.hpp"

namespace myo::ui::platform::gl {

/// Owner of one OpenGL name; frees it when destroyed. The context must still be current then.
template <void (*Delete)(GLuint)>
class Handle {
public:
    Handle() = default;
    explicit Handle(GLuint name) : name_(name) {}
    Handle(Handle&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    Handle& operator=(Handle&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }
    ~Handle() {
        if (name_ != 0) Delete(name_);
    }
    GLuint name() const { return name_; }

private:
    GLuint name_ = 0;
};

void delete_buffer(GLuint name);
void delete_vertex_array(GLuint name);
void delete_texture(GLuint name);
void delete_program(GLuint name);
void delete_framebuffer(GLuint name);
void delete_renderbuffer(GLuint name);

using Buffer = Handle<delete_buffer>;
using VertexArray = Handle<delete_vertex_array>;
using Texture = Handle<delete_texture>;
using Program = Handle<delete_program>;
using Framebuffer = Handle<delete_framebuffer>;
using Renderbuffer = Handle<delete_renderbuffer>;

Buffer make_buffer();
VertexArray make_vertex_array();

/// Compiles and links shaders/<name>.vert and .frag. Error: the compiler's log, with the file's name.
Result<Program> make_program(const std::string& name);

GLint uniform(const Program& program, const char* name);

/// 8-bit RGBA texture, linear filter, clamped.
Texture make_texture(int width, int height, const unsigned char* rgba);

/// Uploads floats for GL_ARRAY_BUFFER use, as data that changes every frame.
void upload(const Buffer& buffer, const std::vector<float>& data);

/// Attribute of `size` floats; stride and offset counted in floats; divisor 1 = per instance.
void attribute(GLuint index, int size, int stride, int offset, GLuint divisor = 0);

/// Colour and depth to draw into, off screen.
struct RenderTarget {
    Framebuffer framebuffer;
    Renderbuffer color;
    Renderbuffer depth;
    int width = 0;
    int height = 0;
    int samples = 0;  // 0 = no multisampling
};
Result<RenderTarget> make_render_target(int width, int height, int samples);

/// Copies all of `from` (resolving its samples) into framebuffer `to` with the lower left corner at (x, y).
void blit(const RenderTarget& from, GLuint to, int x, int y);

}  // namespace myo::ui::platform::gl
