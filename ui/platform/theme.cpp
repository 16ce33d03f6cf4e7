#include "platform/theme.hpp"

namespace myo {
namespace {

ImVec4 rgb(unsigned hex, float alpha = 1.0f) {
    const auto part = [hex](unsigned shift) { return static_cast<float>((hex >> shift) & 0xffu) / 255.0f; };
    return {part(16), part(8), part(0), alpha};
}

Theme dark() {
    Theme t;
    t.name = ThemeName::dark;
    t.background = rgb(0x121418);
    t.panel = rgb(0x1a1d23);
    t.raised = rgb(0x262b34);
    t.popup = rgb(0x1e2229);
    t.plot = rgb(0x121418);
    t.hovered = rgb(0x323946);
    t.border = rgb(0x2e343f);
    t.text = rgb(0xe9ecf1);
    t.muted = rgb(0xa0a9b8);
    t.accent = rgb(0x4c9dff);
    t.on_accent = rgb(0x08121f);
    t.measured = rgb(0xffb347);
    t.simulated = rgb(0x59b4ff);
    t.warning = rgb(0xf2c14e);
    t.failure = rgb(0xff7b72);
    t.success = rgb(0x6fd08c);
    t.view_top = rgb(0x2a303a);
    t.view_bottom = rgb(0x171a20);
    t.grid = rgb(0x4a5362);
    t.body = rgb(0xb9c1cc);
    t.axis_x = rgb(0xff6b6b);
    t.axis_y = rgb(0x7bd88f);
    t.axis_z = rgb(0x6aa9ff);
    return t;
}

Theme light() {
    Theme t;
    t.name = ThemeName::light;
    t.background = rgb(0xdfe3e9);
    t.panel = rgb(0xf6f7f9);
    t.raised = rgb(0xffffff);
    t.popup = rgb(0xf6f7f9);
    t.plot = rgb(0xffffff);
    t.edge_strength = 0.38f;
    t.hovered = rgb(0xe3ebf7);
    t.border = rgb(0xc4cbd6);
    t.text = rgb(0x171b22);
    t.muted = rgb(0x556070);
    t.accent = rgb(0x1a66d6);
    t.on_accent = rgb(0xffffff);
    t.measured = rgb(0xc96a00);
    t.simulated = rgb(0x1a66d6);
    t.warning = rgb(0x8f6400);
    t.failure = rgb(0xc0342b);
    t.success = rgb(0x1c7a3c);
    t.view_top = rgb(0xffffff);
    t.view_bottom = rgb(0xdde2ea);
    t.grid = rgb(0xa9b2c0);
    t.body = rgb(0xcfd6e0);
    t.axis_x = rgb(0xc92a2a);
    t.axis_y = rgb(0x2b8a3e);
    t.axis_z = rgb(0x1864ab);
    return t;
}

}  // namespace

Theme make_theme(ThemeName name, float scale) {
    Theme theme = name == ThemeName::dark ? dark() : light();
    theme.scale = scale;
    return theme;
}

void apply_theme(const Theme& t, ImGuiStyle& style) {
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

    const auto faint = [](ImVec4 color, float alpha) {
        color.w = alpha;
        return color;
    };
    ImVec4* c = style.Colors;
    c[ImGuiCol_Text] = t.text;
    c[ImGuiCol_TextDisabled] = t.muted;
    c[ImGuiCol_WindowBg] = t.panel;
    c[ImGuiCol_ChildBg] = faint(t.panel, 0.0f);
    c[ImGuiCol_PopupBg] = t.popup;
    c[ImGuiCol_Border] = t.hovered;
    c[ImGuiCol_FrameBg] = t.raised;
    c[ImGuiCol_FrameBgHovered] = t.hovered;
    c[ImGuiCol_FrameBgActive] = t.hovered;
    c[ImGuiCol_TitleBg] = t.panel;
    c[ImGuiCol_TitleBgActive] = t.panel;
    c[ImGuiCol_ScrollbarBg] = faint(t.panel, 0.0f);
    c[ImGuiCol_ScrollbarGrab] = t.name == ThemeName::dark ? t.hovered : t.border;
    c[ImGuiCol_ScrollbarGrabHovered] = t.muted;
    c[ImGuiCol_ScrollbarGrabActive] = t.muted;
    c[ImGuiCol_CheckMark] = t.accent;
    c[ImGuiCol_SliderGrab] = faint(t.accent, 0.6f);
    c[ImGuiCol_SliderGrabActive] = t.accent;
    c[ImGuiCol_Button] = t.raised;
    c[ImGuiCol_ButtonHovered] = t.hovered;
    c[ImGuiCol_ButtonActive] = t.border;
    c[ImGuiCol_Header] = faint(t.accent, 0.22f);
    c[ImGuiCol_HeaderHovered] = t.hovered;
    c[ImGuiCol_HeaderActive] = t.hovered;
    c[ImGuiCol_Separator] = t.border;
    c[ImGuiCol_SeparatorHovered] = t.accent;
    c[ImGuiCol_SeparatorActive] = t.accent;
    c[ImGuiCol_PlotHistogram] = t.accent;
    c[ImGuiCol_TextSelectedBg] = faint(t.accent, 0.35f);
    c[ImGuiCol_DragDropTarget] = t.accent;
    c[ImGuiCol_NavHighlight] = t.accent;
    c[ImGuiCol_ModalWindowDimBg] = {0.0f, 0.0f, 0.0f, 0.5f};
    c[ImGuiCol_TableHeaderBg] = t.panel;
    c[ImGuiCol_TableBorderLight] = t.border;
    c[ImGuiCol_TableBorderStrong] = t.border;
    c[ImGuiCol_TableRowBgAlt] = faint(t.raised, 0.5f);
}

ImU32 packed(const ImVec4& color, float alpha) {
    return ImGui::ColorConvertFloat4ToU32({color.x, color.y, color.z, color.w * alpha});
}

}  // namespace myo
