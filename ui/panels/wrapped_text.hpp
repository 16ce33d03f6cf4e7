#pragma once

#include <functional>
#include <string>

namespace myo::ui::panels {

/// Inserts line breaks where a text would exceed `width`, at spaces only. Dear ImGui's own wrapping also breaks numbers
/// such as "0.16" at the point. A word wider than a line gets a line of its own.
///
/// @param width_of  width of a text, in the unit of `width`
std::string broken_at_spaces(const std::string& text, float width,
                             const std::function<float(const std::string&)>& width_of);

/// Draws a text in lines up to `right` [pixels in the window]; 0: up to the edge of the content.
void wrapped_text(const std::string& text, float right = 0.0f);

}  // namespace myo::ui::panels
