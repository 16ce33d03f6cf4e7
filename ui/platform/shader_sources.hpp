#pragma once

#include <string_view>

namespace myo::ui::platform {

/// Returns the text of a file in shaders/, embedded when the program was built; empty if there is no file of that name.
/// Example: "surface.vert".
std::string_view shader_source(std::string_view name);

}  // namespace myo::ui::platform
