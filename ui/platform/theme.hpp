#pragma once

#include <imgui.h>

#include <array>

namespace myo::ui::platform {

enum class ThemeName { dark, light };

/// Colours and fonts of the workbench. One accent; measured and simulated data keep their colours everywhere.
struct Theme {
    ThemeName name = ThemeName::dark;
    float scale = 1.0f;  // of text and spacing
    ImVec4 background;   // behind everything
    ImVec4 panel;
    ImVec4 raised;  // fields, buttons
    ImVec4 popup;
    ImVec4 plot;                  // drawing area of a plot
    float edge_strength = 0.55f;  // of element edges on the body
    ImVec4 hovered;
    ImVec4 border;
    ImVec4 text;
    ImVec4 muted;  // secondary text
    ImVec4 accent;
    ImVec4 on_accent;  // text on the accent
    ImVec4 measured;
    ImVec4 simulated;
    ImVec4 force;  // arrows
    ImVec4 warning;
    ImVec4 failure;
    ImVec4 success;
    ImVec4 view_top;  // backdrop of the 3D view
    ImVec4 view_bottom;
    ImVec4 grid;
    ImVec4 body;  // surface without a field
    ImVec4 axis_x, axis_y, axis_z;
    std::array<ImVec4, 8> muscles;  // told apart by people who do not see all colours, too
    const ImVec4& muscle(int color) const { return muscles[static_cast<std::size_t>(color) % muscles.size()]; }

    // Filled by load_fonts.
    ImFont* regular = nullptr;
    ImFont* strong = nullptr;  // headings, results
    ImFont* small = nullptr;   // labels in plots and view
    ImFont* large = nullptr;   // title and signs of the start page; Latin only
};

Theme make_theme(ThemeName name, float scale);

/// Writes colours and spacing (multiples of 4 pixels) into ImGui's style.
void apply_theme(const Theme& theme, ImGuiStyle& style);

ImU32 packed(const ImVec4& color, float alpha = 1.0f);

}  // namespace myo::ui::platform
