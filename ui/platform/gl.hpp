#pragma once

#include <GL/glcorearb.h>

#include "base/result.hpp"

// The OpenGL 3.3 functions that the workbench calls. OSMesa and GLFW each return function pointers of their own, and
// common loaders require GLX, so the pointers are loaded here from the current context. To call a further function, add
// its line to this list.
#define MYOLOOP_GL_FUNCTIONS(X)                                                \
    X(PFNGLACTIVETEXTUREPROC, ActiveTexture)                                   \
    X(PFNGLATTACHSHADERPROC, AttachShader)                                     \
    X(PFNGLBINDBUFFERPROC, BindBuffer)                                         \
    X(PFNGLBINDFRAMEBUFFERPROC, BindFramebuffer)                               \
    X(PFNGLBINDRENDERBUFFERPROC, BindRenderbuffer)                             \
    X(PFNGLBINDTEXTUREPROC, BindTexture)                                       \
    X(PFNGLBINDVERTEXARRAYPROC, BindVertexArray)                               \
    X(PFNGLBLENDFUNCSEPARATEPROC, BlendFuncSeparate)                           \
    X(PFNGLBLITFRAMEBUFFERPROC, BlitFramebuffer)                               \
    X(PFNGLBUFFERDATAPROC, BufferData)                                         \
    X(PFNGLCHECKFRAMEBUFFERSTATUSPROC, CheckFramebufferStatus)                 \
    X(PFNGLCLEARPROC, Clear)                                                   \
    X(PFNGLCLEARCOLORPROC, ClearColor)                                         \
    X(PFNGLCOMPILESHADERPROC, CompileShader)                                   \
    X(PFNGLCREATEPROGRAMPROC, CreateProgram)                                   \
    X(PFNGLCREATESHADERPROC, CreateShader)                                     \
    X(PFNGLCULLFACEPROC, CullFace)                                             \
    X(PFNGLDELETEBUFFERSPROC, DeleteBuffers)                                   \
    X(PFNGLDELETEFRAMEBUFFERSPROC, DeleteFramebuffers)                         \
    X(PFNGLDELETEPROGRAMPROC, DeleteProgram)                                   \
    X(PFNGLDELETERENDERBUFFERSPROC, DeleteRenderbuffers)                       \
    X(PFNGLDELETESHADERPROC, DeleteShader)                                     \
    X(PFNGLDELETETEXTURESPROC, DeleteTextures)                                 \
    X(PFNGLDELETEVERTEXARRAYSPROC, DeleteVertexArrays)                         \
    X(PFNGLDEPTHFUNCPROC, DepthFunc)                                           \
    X(PFNGLDEPTHMASKPROC, DepthMask)                                           \
    X(PFNGLDISABLEPROC, Disable)                                               \
    X(PFNGLDRAWARRAYSPROC, DrawArrays)                                         \
    X(PFNGLDRAWARRAYSINSTANCEDPROC, DrawArraysInstanced)                       \
    X(PFNGLDRAWELEMENTSBASEVERTEXPROC, DrawElementsBaseVertex)                 \
    X(PFNGLENABLEPROC, Enable)                                                 \
    X(PFNGLENABLEVERTEXATTRIBARRAYPROC, EnableVertexAttribArray)               \
    X(PFNGLFINISHPROC, Finish)                                                 \
    X(PFNGLFRAMEBUFFERRENDERBUFFERPROC, FramebufferRenderbuffer)               \
    X(PFNGLGENBUFFERSPROC, GenBuffers)                                         \
    X(PFNGLGENFRAMEBUFFERSPROC, GenFramebuffers)                               \
    X(PFNGLGENRENDERBUFFERSPROC, GenRenderbuffers)                             \
    X(PFNGLGENTEXTURESPROC, GenTextures)                                       \
    X(PFNGLGENVERTEXARRAYSPROC, GenVertexArrays)                               \
    X(PFNGLGETERRORPROC, GetError)                                             \
    X(PFNGLGETINTEGERVPROC, GetIntegerv)                                       \
    X(PFNGLGETPROGRAMINFOLOGPROC, GetProgramInfoLog)                           \
    X(PFNGLGETPROGRAMIVPROC, GetProgramiv)                                     \
    X(PFNGLGETSHADERINFOLOGPROC, GetShaderInfoLog)                             \
    X(PFNGLGETSHADERIVPROC, GetShaderiv)                                       \
    X(PFNGLGETSTRINGPROC, GetString)                                           \
    X(PFNGLGETUNIFORMLOCATIONPROC, GetUniformLocation)                         \
    X(PFNGLLINKPROGRAMPROC, LinkProgram)                                       \
    X(PFNGLPIXELSTOREIPROC, PixelStorei)                                       \
    X(PFNGLPOLYGONOFFSETPROC, PolygonOffset)                                   \
    X(PFNGLREADPIXELSPROC, ReadPixels)                                         \
    X(PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC, RenderbufferStorageMultisample) \
    X(PFNGLSCISSORPROC, Scissor)                                               \
    X(PFNGLSHADERSOURCEPROC, ShaderSource)                                     \
    X(PFNGLTEXIMAGE2DPROC, TexImage2D)                                         \
    X(PFNGLTEXPARAMETERIPROC, TexParameteri)                                   \
    X(PFNGLUNIFORM1FPROC, Uniform1f)                                           \
    X(PFNGLUNIFORM1IPROC, Uniform1i)                                           \
    X(PFNGLUNIFORM2FPROC, Uniform2f)                                           \
    X(PFNGLUNIFORM3FPROC, Uniform3f)                                           \
    X(PFNGLUNIFORM4FPROC, Uniform4f)                                           \
    X(PFNGLUNIFORMMATRIX4FVPROC, UniformMatrix4fv)                             \
    X(PFNGLUSEPROGRAMPROC, UseProgram)                                         \
    X(PFNGLVERTEXATTRIBDIVISORPROC, VertexAttribDivisor)                       \
    X(PFNGLVERTEXATTRIBPOINTERPROC, VertexAttribPointer)                       \
    X(PFNGLVIEWPORTPROC, Viewport)

namespace myo::ui::platform::gl {

#define MYOLOOP_GL_DECLARE(type, name) extern type name;
MYOLOOP_GL_FUNCTIONS(MYOLOOP_GL_DECLARE)
#undef MYOLOOP_GL_DECLARE

using AnyFunction = void (*)();                            // stands for a function pointer of any type
using GetProcAddress = AnyFunction (*)(const char* name);  // GLFW's or OSMesa's lookup

/// Loads the function pointers above from the current context.
///
/// Call it once per process, before any other function of this folder. The pointers are global, like OpenGL's own
/// functions, so a process uses one kind of context at a time. Error: a function is missing, or the context is older
/// than OpenGL 3.3.
Result<void> load(GetProcAddress get_proc_address);

}  // namespace myo::ui::platform::gl
