#pragma once

#include <functional>
#include <string>

namespace myo::ui::panels {

/// The text with line ends where it would pass `width`, at spaces only: numbers such as "0.16" stay whole, which Dear
/// ImGui's own wrapping parts at their point. A word that is wider than a line keeps a line of its own.
std::string broken_at_spaces(const std::string& text, float width,
                             const std::function<float(const std::string&)>& width_of);

/// Draws text in lines up to `right` in the window's coordinates; 0: up to its content's edge.
void wrapped_text(const std::string& text, float right = 0.0f);

}  // namespace myo::ui::panels
