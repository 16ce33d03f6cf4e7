#pragma once

#include <imgui.h>

#include <array>

namespace myo::ui::platform {

/// The two colour schemes.
enum class ThemeName { dark, light };

/// Colours and fonts of the workbench.
///
/// There is one accent colour. Measured and simulated data have their own colours, used consistently in the view, plots
/// and tables. Panels take colours from here and define none of their own.
struct Theme {
    ThemeName name = ThemeName::dark;
    float scale = 1.0f;  // of text and spacing; 1 = default size
    ImVec4 background;   // behind all panels
    ImVec4 panel;        // of panels
    ImVec4 raised;       // fields, buttons
    ImVec4 popup;
    ImVec4 plot;                  // drawing area of a plot
    float edge_strength = 0.55f;  // opacity of element edges on the body, 0 to 1
    ImVec4 hovered;               // item under the mouse
    ImVec4 border;                // lines between areas
    ImVec4 text;                  // primary text
    ImVec4 muted;                 // secondary text
    ImVec4 accent;                // selection, active controls
    ImVec4 on_accent;             // text on the accent
    ImVec4 measured;              // data from motion capture
    ImVec4 simulated;             // data from the model
    ImVec4 force;                 // force arrows
    ImVec4 warning;
    ImVec4 failure;
    ImVec4 success;
    ImVec4 view_top;                // background of the 3D view, top
    ImVec4 view_bottom;             // background of the 3D view, bottom
    ImVec4 grid;                    // ground grid
    ImVec4 body;                    // body surface without a field
    ImVec4 axis_x, axis_y, axis_z;  // coordinate axes
    std::array<ImVec4, 8> muscles;  // distinguishable with colour vision deficiencies
    /// Colour of a muscle by its number; numbers above 7 repeat the sequence. `color` must not be negative.
    const ImVec4& muscle(int color) const { return muscles[static_cast<std::size_t>(color) % muscles.size()]; }

    // Fonts, owned by ImGui's atlas and filled by load_fonts(); null before.
    ImFont* regular = nullptr;  // body text and controls
    ImFont* strong = nullptr;   // headings, results
    ImFont* small = nullptr;    // labels in plots and view
    ImFont* large = nullptr;    // title and icons of the start page; Latin only
};

/// Returns the colours of a scheme; the fonts stay null until load_fonts().
Theme make_theme(ThemeName name, float scale);

/// Writes colours and spacing (multiples of 4 pixels, times the scale) into ImGui's style.
void apply_theme(const Theme& theme, ImGuiStyle& style);

/// Colour as ImGui's draw lists take it, its opacity multiplied by `alpha`.
ImU32 packed(const ImVec4& color, float alpha = 1.0f);

}  // namespace myo::ui::platform
