#pragma once

#include <imgui.h>

#include <map>
#include <optional>
#include <string>

namespace myo::ui::platform {

struct Rectangle {
    ImVec2 lowest;   // upper left [pixels]
    ImVec2 highest;  // lower right

    ImVec2 center() const { return {0.5f * (lowest.x + highest.x), 0.5f * (lowest.y + highest.y)}; }
    float width() const { return highest.x - lowest.x; }
    float height() const { return highest.y - lowest.y; }
    bool contains(const ImVec2& p) const {
        return p.x >= lowest.x && p.x < highest.x && p.y >= lowest.y && p.y < highest.y;
    }
};

/// Where the named items of the last frame are: how tests, and only they, find what to click.
class ItemRectangles {
public:
    void clear() { items_.clear(); }
    void add(const std::string& name, const Rectangle& rectangle) { items_[name] = rectangle; }
    /// Records the item just submitted to ImGui, unless it is scrolled out of sight.
    void mark(const std::string& name) {
        if (ImGui::IsItemVisible()) add(name, {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()});
    }

    std::optional<Rectangle> find(const std::string& name) const {
        const auto found = items_.find(name);
        if (found == items_.end()) return std::nullopt;
        return found->second;
    }
    const std::map<std::string, Rectangle>& all() const { return items_; }

private:
    std::map<std::string, Rectangle> items_;
};

}  // namespace myo::ui::platform
