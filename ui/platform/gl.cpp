#include "platform/gl.hpp"

#include <string>

namespace myo::ui::platform::gl {

#define MYOLOOP_GL_DEFINE(type, name) type name = nullptr;
MYOLOOP_GL_FUNCTIONS(MYOLOOP_GL_DEFINE)
#undef MYOLOOP_GL_DEFINE

Result<void> load(GetProcAddress get_proc_address) {
#define MYOLOOP_GL_LOAD(type, name)                                \
    (name) = reinterpret_cast<type>(get_proc_address("gl" #name)); \
    if ((name) == nullptr) return Error{"the graphics driver lacks gl" #name "; OpenGL 3.3 is needed", "OpenGL"};
    MYOLOOP_GL_FUNCTIONS(MYOLOOP_GL_LOAD)
#undef MYOLOOP_GL_LOAD
    GLint major = 0;
    GLint minor = 0;
    // The context may be older than 3.3 although the driver exports every function, so the version is checked too.
    GetIntegerv(GL_MAJOR_VERSION, &major);
    GetIntegerv(GL_MINOR_VERSION, &minor);
    if (major * 10 + minor < 33) {
        return Error{"OpenGL 3.3 is needed, the driver offers " + std::to_string(major) + "." + std::to_string(minor),
                     "OpenGL"};
    }
    return {};
}

}  // namespace myo::ui::platform::gl
