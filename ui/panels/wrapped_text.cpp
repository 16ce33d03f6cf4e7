#include "panels/wrapped_text.hpp"

#include <imgui.h>

#include <algorithm>

namespace myo::ui::panels {

std::string broken_at_spaces(const std::string& text, float width,
                             const std::function<float(const std::string&)>& width_of) {
    std::string broken, line;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = std::min(text.find_first_of(" \n", at), text.size());
        const std::string word = text.substr(at, end - at);
        // The width of the whole line counts, spaces included.
        const std::string longer = line.empty() ? word : line + " " + word;
        // The first word of a line is placed even if it is too wide; otherwise the loop would not end.
        if (line.empty() || width_of(longer) <= width) {
            line = longer;
        } else {
            broken += line + "\n";
            line = word;
        }
        if (end < text.size() && text[end] == '\n') {
            broken += line + "\n";
            line.clear();
        }
        at = end + 1;
    }
    return broken + line;
}

void wrapped_text(const std::string& text, float right) {
    const float width = right > 0.0f ? right - ImGui::GetCursorPosX() : ImGui::GetContentRegionAvail().x;
    const std::string broken = broken_at_spaces(
        text, width, [](const std::string& line) { return ImGui::CalcTextSize(line.c_str()).x; });
    ImGui::PushTextWrapPos(right);  // for words that are wider than a line, such as paths
    ImGui::TextUnformatted(broken.c_str());
    ImGui::PopTextWrapPos();
}

}  // namespace myo::ui::panels
