#include "platform/interface.hpp"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>

namespace myo::ui::platform {

void Interface::DestroyContext::operator()(ImGuiContext* context) const { ImGui::DestroyContext(context); }

Result<Interface> Interface::make(ThemeName theme, float scale) {
    auto renderer = ImguiRenderer::make();
    if (!renderer) return renderer.error();
    Interface made;
    made.renderer_ = std::move(*renderer);
    made.context_.reset(ImGui::CreateContext());
    made.theme_ = make_theme(theme, scale);
    ImGuiIO& io = ImGui::GetIO();
    // ImGui writes no files of its own: the preferences keep the sizes of the window's parts.
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    // Plots with many samples need more than 65,536 vertices in one draw list.
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    // The event queue already uses ImGui's key numbers, so the map is the identity.
    for (int key = 0; key < ImGuiKey_COUNT; ++key) io.KeyMap[key] = key;
    return made;
}

void Interface::rebuild() {
    apply_theme(theme_, ImGui::GetStyle());
    load_fonts(theme_, letters_);
    renderer_.upload_fonts(*ImGui::GetIO().Fonts);
    // The list has pairs, each a range of one letter, and a 0 at its end.
    lacks_letters_ = false;
    for (std::size_t i = 0; i + 1 < letters_.size(); i += 2)
        lacks_letters_ = lacks_letters_ || !theme_.regular->FindGlyphNoFallback(letters_[i]);
    rebuild_ = false;
}

void Interface::begin_frame(int width, int height, float seconds) {
    if (rebuild_) rebuild();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    // ImGui asserts a positive time step. The upper limit keeps its animations from jumping after a long pause.
    io.DeltaTime = std::clamp(seconds, 1e-4f, 0.25f);
    input_->apply_to_next_frame(io);
    items_->clear();
    // Arrow keys and Escape work in lists and menus. Elsewhere they belong to the view; dialogs handle them themselves.
    const auto& popups = ImGui::GetCurrentContext()->OpenPopupStack;
    const ImGuiWindow* const front = popups.empty() ? nullptr : popups.back().Window;
    const bool navigable = front && (front->Flags & (ImGuiWindowFlags_Modal | ImGuiWindowFlags_NoNavInputs)) == 0;
    io.ConfigFlags = navigable ? io.ConfigFlags | ImGuiConfigFlags_NavEnableKeyboard
                               : io.ConfigFlags & ~ImGuiConfigFlags_NavEnableKeyboard;
    ImGui::NewFrame();
}

void Interface::need_letters(const std::string& text) {
    if (theme_.regular == nullptr) return;
    for (const char* at = text.c_str(); *at != '\0';) {
        unsigned int letter = 0;
        at += ImTextCharFromUtf8(&letter, at, text.c_str() + text.size());
        const auto wide = static_cast<ImWchar>(letter);
        const bool missing = letter >= 0x20 && letter <= 0xffff && !theme_.regular->FindGlyphNoFallback(wide);
        if (!missing || std::find(letters_.begin(), letters_.end(), wide) != letters_.end()) continue;
        if (letters_.empty()) letters_.push_back(0);
        letters_.insert(letters_.end() - 1, 2, wide);  // a range of one
        rebuild_ = true;
    }
}

void Interface::end_frame() { ImGui::Render(); }

void Interface::draw() const { renderer_.draw(*ImGui::GetDrawData()); }

void Interface::set_theme(ThemeName name, float scale) {
    scale = std::clamp(scale, 0.75f, 3.0f);
    if (name == theme_.name && scale == theme_.scale) return;
    theme_ = make_theme(name, scale);
    rebuild_ = true;
}

}  // namespace myo::ui::platform
