#include "platform/theme.hpp"

#include <initializer_list>

namespace myo::ui::platform {
namespace {

/// Opaque colour from 0xRRGGBB.
ImVec4 rgb(unsigned hex) {
    const auto part = [hex](unsigned shift) { return static_cast<float>((hex >> shift) & 0xffu) / 255.0f; };
    return {part(16), part(8), part(0), 1.0f};
}

/// A colour of the theme and its value in the dark and light variant, 0xRRGGBB.
struct Swatch {
    ImVec4 Theme::*color;
    unsigned dark, light;
};
constexpr Swatch palette[] = {
    {&Theme::background, 0x121418, 0xdfe3e9},  {&Theme::panel, 0x1a1d23, 0xf6f7f9},
    {&Theme::raised, 0x262b34, 0xffffff},      {&Theme::popup, 0x1e2229, 0xf6f7f9},
    {&Theme::plot, 0x121418, 0xffffff},        {&Theme::hovered, 0x323946, 0xe3ebf7},
    {&Theme::border, 0x2e343f, 0xc4cbd6},      {&Theme::text, 0xe9ecf1, 0x171b22},
    {&Theme::muted, 0xa0a9b8, 0x556070},       {&Theme::accent, 0x4c9dff, 0x1a66d6},
    {&Theme::on_accent, 0x08121f, 0xffffff},   {&Theme::measured, 0xffb347, 0xc96a00},
    {&Theme::simulated, 0x59b4ff, 0x1a66d6},   {&Theme::force, 0xd9a0ff, 0x7a2fd0},
    {&Theme::warning, 0xf2c14e, 0x8f6400},     {&Theme::failure, 0xff7b72, 0xc0342b},
    {&Theme::success, 0x6fd08c, 0x1c7a3c},     {&Theme::view_top, 0x2a303a, 0xffffff},
    {&Theme::view_bottom, 0x171a20, 0xdde2ea}, {&Theme::grid, 0x4a5362, 0xa9b2c0},
    {&Theme::body, 0xb9c1cc, 0xcfd6e0},        {&Theme::axis_x, 0xff6b6b, 0xc92a2a},
    {&Theme::axis_y, 0x7bd88f, 0x2b8a3e},      {&Theme::axis_z, 0x6aa9ff, 0x1864ab},
};

/// Muscle colours by Okabe and Ito 2008, distinguishable with colour vision deficiencies; darker on a light background.
/// The last is between their yellow and green.
constexpr unsigned muscle_colors_dark[] = {0xe8663c, 0x56b4e9, 0x1fb58a, 0xcc79a7,
                                           0xe69f00, 0x5b8def, 0xf0e442, 0x9bc53d};
constexpr unsigned muscle_colors_light[] = {0xd04a14, 0x2a8fca, 0x008f66, 0xb0578a,
                                            0xc98600, 0x1f5fc4, 0xb8a800, 0x6f9420};

/// Each group of ImGui's colours takes one colour of the theme.
void apply_colors(const Theme& t, ImGuiStyle& style) {
    const auto faint = [](ImVec4 color, float alpha) {
        color.w = alpha;
        return color;
    };
    const auto use = [&](const ImVec4& color, std::initializer_list<ImGuiCol> places) {
        for (const ImGuiCol place : places) style.Colors[place] = color;
    };
    use(t.text, {ImGuiCol_Text});
    use(t.muted, {ImGuiCol_TextDisabled, ImGuiCol_ScrollbarGrabHovered, ImGuiCol_ScrollbarGrabActive});
    use(t.panel, {ImGuiCol_WindowBg, ImGuiCol_TitleBg, ImGuiCol_TitleBgActive, ImGuiCol_TableHeaderBg});
    use(faint(t.panel, 0.0f), {ImGuiCol_ChildBg, ImGuiCol_ScrollbarBg});
    use(t.popup, {ImGuiCol_PopupBg});
    use(t.hovered, {ImGuiCol_Border, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive, ImGuiCol_ButtonHovered,
                    ImGuiCol_HeaderHovered, ImGuiCol_HeaderActive});
    use(t.raised, {ImGuiCol_FrameBg, ImGuiCol_Button});
    use(t.name == ThemeName::dark ? t.hovered : t.border, {ImGuiCol_ScrollbarGrab});
    use(t.accent, {ImGuiCol_CheckMark, ImGuiCol_SliderGrabActive, ImGuiCol_SeparatorHovered, ImGuiCol_SeparatorActive,
                   ImGuiCol_PlotHistogram, ImGuiCol_DragDropTarget, ImGuiCol_NavHighlight});
    use(faint(t.accent, 0.6f), {ImGuiCol_SliderGrab});
    use(t.border, {ImGuiCol_ButtonActive, ImGuiCol_Separator, ImGuiCol_TableBorderLight, ImGuiCol_TableBorderStrong});
    use(faint(t.accent, 0.22f), {ImGuiCol_Header});
    use(faint(t.accent, 0.35f), {ImGuiCol_TextSelectedBg});
    use({0.0f, 0.0f, 0.0f, 0.5f}, {ImGuiCol_ModalWindowDimBg});
    use(faint(t.raised, 0.5f), {ImGuiCol_TableRowBgAlt});
}

}  // namespace

Theme make_theme(ThemeName name, float scale) {
    const bool light = name == ThemeName::light;
    Theme theme;
    theme.name = name;
    theme.scale = scale;
    theme.edge_strength = light ? 0.38f : 0.55f;
    for (const Swatch& swatch : palette) theme.*swatch.color = rgb(light ? swatch.light : swatch.dark);
    for (std::size_t i = 0; i < theme.muscles.size(); ++i)
        theme.muscles[i] = rgb(light ? muscle_colors_light[i] : muscle_colors_dark[i]);
    return theme;
}

void apply_theme(const Theme& t, ImGuiStyle& style) {
    // Start from ImGui's defaults: ScaleAllSizes would otherwise multiply already scaled sizes again.
    style = ImGuiStyle();
    style.WindowPadding = {16, 12};
    style.FramePadding = {8, 5};
    style.ItemSpacing = {8, 6};
    style.ItemInnerSpacing = {8, 4};
    style.CellPadding = {8, 4};
    style.IndentSpacing = 16;
    style.ScrollbarSize = 12;
    style.GrabMinSize = 12;
    style.WindowBorderSize = 0;
    style.ChildBorderSize = 0;
    style.FrameBorderSize = t.name == ThemeName::light ? 1.0f : 0.0f;
    style.PopupBorderSize = 1;
    style.FrameRounding = 4;
    style.GrabRounding = 4;
    style.PopupRounding = 6;
    style.ScrollbarRounding = 6;
    style.ChildRounding = 0;
    style.ScaleAllSizes(t.scale);

    apply_colors(t, style);
}

ImU32 packed(const ImVec4& color, float alpha) {
    return ImGui::ColorConvertFloat4ToU32({color.x, color.y, color.z, color.w * alpha});
}

}  // namespace myo::ui::platform
