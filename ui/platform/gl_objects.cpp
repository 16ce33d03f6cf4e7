#include "platform/gl_objects.hpp"

#include <array>
#include <cstdint>

#include "platform/shader_sources.hpp"

namespace myo::ui::platform::gl {

void delete_buffer(GLuint name) { DeleteBuffers(1, &name); }
void delete_vertex_array(GLuint name) { DeleteVertexArrays(1, &name); }
void delete_texture(GLuint name) { DeleteTextures(1, &name); }
void delete_program(GLuint name) { DeleteProgram(name); }
void delete_framebuffer(GLuint name) { DeleteFramebuffers(1, &name); }
void delete_renderbuffer(GLuint name) { DeleteRenderbuffers(1, &name); }

Buffer make_buffer() {
    GLuint name = 0;
    GenBuffers(1, &name);
    return Buffer(name);
}

VertexArray make_vertex_array() {
    GLuint name = 0;
    GenVertexArrays(1, &name);
    return VertexArray(name);
}

namespace {

/// Compiles one of the embedded shader files. The caller deletes the shader after linking.
Result<GLuint> compile(GLenum kind, const std::string& file) {
    const std::string_view source = shader_source(file);
    if (source.empty()) return Error{"no such shader was built into the program", "shaders/" + file};
    const GLuint shader = CreateShader(kind);
    const GLchar* text = source.data();
    const GLint length = static_cast<GLint>(source.size());
    ShaderSource(shader, 1, &text, &length);
    CompileShader(shader);
    GLint compiled = 0;
    GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE) return shader;
    std::array<char, 2048> log{};
    GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    DeleteShader(shader);
    return Error{std::string("does not compile: ") + log.data(), "shaders/" + file};
}

}  // namespace

Result<Program> make_program(const std::string& name) {
    const auto vertex = compile(GL_VERTEX_SHADER, name + ".vert");
    if (!vertex) return vertex.error();
    const auto fragment = compile(GL_FRAGMENT_SHADER, name + ".frag");
    if (!fragment) {
        DeleteShader(*vertex);
        return fragment.error();
    }
    Program program(CreateProgram());
    AttachShader(program.name(), *vertex);
    AttachShader(program.name(), *fragment);
    LinkProgram(program.name());
    // A linked program keeps its code; the shader objects are no longer needed.
    DeleteShader(*vertex);
    DeleteShader(*fragment);
    GLint linked = 0;
    GetProgramiv(program.name(), GL_LINK_STATUS, &linked);
    if (linked == GL_TRUE) return program;
    std::array<char, 2048> log{};
    GetProgramInfoLog(program.name(), static_cast<GLsizei>(log.size()), nullptr, log.data());
    return Error{std::string("does not link: ") + log.data(), "shaders/" + name};
}

GLint uniform(const Program& program, const char* name) { return GetUniformLocation(program.name(), name); }

Texture make_texture(int width, int height, const unsigned char* rgba) {
    GLuint name = 0;
    GenTextures(1, &name);
    Texture texture(name);
    BindTexture(GL_TEXTURE_2D, name);
    TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    // Widths that are not a multiple of 4 bytes are allowed in OpenGL only with this alignment.
    PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    return texture;
}

void upload(const Buffer& buffer, const std::vector<float>& data) {
    BindBuffer(GL_ARRAY_BUFFER, buffer.name());
    BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(data.size() * sizeof(float)), data.data(), GL_STREAM_DRAW);
}

void attribute(GLuint index, int size, int stride, int offset, GLuint divisor) {
    EnableVertexAttribArray(index);
    // OpenGL takes the byte offset in a pointer argument.
    const void* place = reinterpret_cast<const void*>(static_cast<std::uintptr_t>(offset) * sizeof(float));
    VertexAttribPointer(index, size, GL_FLOAT, GL_FALSE,
                        static_cast<GLsizei>(static_cast<std::size_t>(stride) * sizeof(float)), place);
    VertexAttribDivisor(index, divisor);
}

Result<RenderTarget> make_render_target(int width, int height, int samples) {
    RenderTarget target;
    target.width = width;
    target.height = height;
    target.samples = samples;
    GLuint names[2] = {0, 0};
    GenRenderbuffers(2, names);
    target.color = Renderbuffer(names[0]);
    target.depth = Renderbuffer(names[1]);
    GLuint framebuffer = 0;
    GenFramebuffers(1, &framebuffer);
    target.framebuffer = Framebuffer(framebuffer);
    BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    BindRenderbuffer(GL_RENDERBUFFER, names[0]);
    RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_RGBA8, width, height);
    FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, names[0]);
    BindRenderbuffer(GL_RENDERBUFFER, names[1]);
    RenderbufferStorageMultisample(GL_RENDERBUFFER, samples, GL_DEPTH_COMPONENT24, width, height);
    FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, names[1]);
    const bool complete = CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    BindFramebuffer(GL_FRAMEBUFFER, 0);
    if (complete) return target;
    return Error{"the driver cannot draw off screen at " + std::to_string(width) + " x " + std::to_string(height),
                 "OpenGL"};
}

void blit(const RenderTarget& from, GLuint to, int x, int y) {
    BindFramebuffer(GL_READ_FRAMEBUFFER, from.framebuffer.name());
    BindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    BlitFramebuffer(0, 0, from.width, from.height, x, y, x + from.width, y + from.height, GL_COLOR_BUFFER_BIT,
                    GL_NEAREST);
    BindFramebuffer(GL_FRAMEBUFFER, to);
}

}  // namespace myo::ui::platform::gl
