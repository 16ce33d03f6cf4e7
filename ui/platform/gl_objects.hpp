#pragma once

#include <string>
#include <utility>
#include <vector>

#include "base/result.hpp"
#include "platform/gl.hpp"

namespace myo::ui::platform::gl {

/// Owns one OpenGL object and deletes it in the destructor. Movable, not copyable; an empty handle (name 0) deletes
/// nothing. The OpenGL context must still be current when a handle is destroyed, and all calls come from the UI thread.
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
    GLuint name_ = 0;  // OpenGL's object name; 0: owns nothing
};

// Deleters for Handle; each deletes one object.
void delete_buffer(GLuint name);
void delete_vertex_array(GLuint name);
void delete_texture(GLuint name);
void delete_program(GLuint name);
void delete_framebuffer(GLuint name);
void delete_renderbuffer(GLuint name);

// Owners of the object types that the workbench uses.
using Buffer = Handle<delete_buffer>;
using VertexArray = Handle<delete_vertex_array>;
using Texture = Handle<delete_texture>;
using Program = Handle<delete_program>;
using Framebuffer = Handle<delete_framebuffer>;
using Renderbuffer = Handle<delete_renderbuffer>;

/// Create an empty buffer and an empty vertex array object.
Buffer make_buffer();
VertexArray make_vertex_array();

/// Compiles and links shaders/`name`.vert and shaders/`name`.frag, which are embedded in the program. Error: no such
/// shader, or the compiler's or linker's log with the file name.
Result<Program> make_program(const std::string& name);

/// Location of a uniform; -1, which OpenGL ignores on assignment, if the program does not use it.
GLint uniform(const Program& program, const char* name);

/// Creates an 8-bit RGBA texture with linear filtering, clamped at its edges.
///
/// @param width, height  size [pixels]
/// @param rgba  width x height x 4 bytes, copied to the GPU
Texture make_texture(int width, int height, const unsigned char* rgba);

/// Replaces the content of a buffer, marked as data that changes every frame. Leaves the buffer bound to
/// GL_ARRAY_BUFFER.
void upload(const Buffer& buffer, const std::vector<float>& data);

/// Declares vertex attribute `index` of the bound vertex array and buffer: `size` floats.
///
/// @param stride, offset  counted in floats, not bytes
/// @param divisor  0: one value per vertex; 1: one value per instance
void attribute(GLuint index, int size, int stride, int offset, GLuint divisor = 0);

/// A framebuffer for off-screen rendering with colour (RGBA, 8 bits) and depth (24 bits).
struct RenderTarget {
    Framebuffer framebuffer;
    Renderbuffer color;
    Renderbuffer depth;
    int width = 0;    // [pixels]
    int height = 0;   // [pixels]
    int samples = 0;  // per pixel; 0 = no multisampling
};
/// Creates an off-screen framebuffer of this size [pixels]. Error: the driver refuses the size or the number of
/// samples.
Result<RenderTarget> make_render_target(int width, int height, int samples);

/// Copies the whole image of `from` into framebuffer `to`, with its lower left corner at (x, y) [pixels]; multisampled
/// images are resolved. Leaves `to` bound.
void blit(const RenderTarget& from, GLuint to, int x, int y);

}  // namespace myo::ui::platform::gl
