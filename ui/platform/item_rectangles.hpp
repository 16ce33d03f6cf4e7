#pragma once

#include <imgui.h>

#include <map>
#include <optional>
#include <string>

namespace myo::ui::platform {

/// An axis-aligned rectangle in the window [pixels], origin at the upper left. `highest` is outside of it.
struct Rectangle {
    ImVec2 lowest;   // upper left [pixels]
    ImVec2 highest;  // lower right [pixels]

    ImVec2 center() const { return {0.5f * (lowest.x + highest.x), 0.5f * (lowest.y + highest.y)}; }
    float width() const { return highest.x - lowest.x; }
    float height() const { return highest.y - lowest.y; }
    bool contains(const ImVec2& p) const {
        return p.x >= lowest.x && p.x < highest.x && p.y >= lowest.y && p.y < highest.y;
    }
};

/// Rectangles of the named items of the last frame. Only tests read them, to find the place to click; the program
/// itself must not depend on them.
///
/// Names look like paths: "view/fit", "plot/x/cursor". Item names are part of the tests' interface, so renaming one
/// changes tests.
class ItemRectangles {
public:
    /// Called at the start of each frame.
    void clear() { items_.clear(); }
    void add(const std::string& name, const Rectangle& rectangle) { items_[name] = rectangle; }
    /// Records the item submitted to ImGui last, unless it is scrolled out of the visible area.
    void mark(const std::string& name) {
        if (ImGui::IsItemVisible()) add(name, {ImGui::GetItemRectMin(), ImGui::GetItemRectMax()});
    }

    /// The rectangle of an item; empty if it was not drawn in the last frame.
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
