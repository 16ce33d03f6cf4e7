#include "platform/picture_canvas.hpp"

#include <imgui.h>

#include <utility>

#include "platform/fonts.hpp"

namespace myo::ui::platform {
namespace {

/// Makes an ImGui context current for the lifetime of this object and restores the previous one afterwards, on every
/// path.
class CurrentContext {
public:
    explicit CurrentContext(ImGuiContext* context) : before_(ImGui::GetCurrentContext()) {
        ImGui::SetCurrentContext(context);
    }
    CurrentContext(const CurrentContext&) = delete;
    CurrentContext& operator=(const CurrentContext&) = delete;
    ~CurrentContext() { ImGui::SetCurrentContext(before_); }

private:
    ImGuiContext* before_;
};

}  // namespace

void PictureCanvas::DestroyContext::operator()(ImGuiContext* context) const { ImGui::DestroyContext(context); }

Result<PictureCanvas> PictureCanvas::make(ThemeName theme, float scale, const std::vector<ImWchar>& letters) {
    auto renderer = ImguiRenderer::make();
    if (!renderer) return renderer.error();
    PictureCanvas canvas;
    canvas.renderer_ = std::move(*renderer);
    // CreateContext may leave the new context current. The previous one is restored, so that `current` returns to it at
    // the end.
    ImGuiContext* const before = ImGui::GetCurrentContext();
    canvas.context_.reset(ImGui::CreateContext());
    ImGui::SetCurrentContext(before);
    const CurrentContext current(canvas.context_.get());
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    canvas.theme_ = make_theme(theme, scale);
    load_label_font(canvas.theme_, letters);
    canvas.renderer_.upload_fonts(*io.Fonts);
    return canvas;
}

void PictureCanvas::draw(GLuint framebuffer, int width, int height, const Drawing& drawing) const {
    const CurrentContext current(context_.get());
    ImGui::GetIO().DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    ImGui::NewFrame();
    drawing(*ImGui::GetBackgroundDrawList(), theme_);
    ImGui::Render();
    renderer_.draw(*ImGui::GetDrawData(), framebuffer);
    gl::BindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace myo::ui::platform
