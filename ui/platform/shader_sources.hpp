#pragma once

#include <string_view>

namespace myo::ui::platform {

/// Text of a file in shaders/, embedded when the program was built; empty when there is none of that name.
std::string_view shader_source(std::string_view name);

}  // namespace myo::ui::platform
