#include "panels/film_job.hpp"

#include <imgui.h>

#include "panels/widgets.hpp"

namespace myo {

Result<Image> draw_picture(SceneRenderer& renderer, const DrawnScene& scene, std::uint64_t revision, const ViewColors& colors, const Camera& camera, const ViewSize& size) {
    if (const Result<void> drawn = renderer.update(scene, revision, colors, camera, size, 4); !drawn) return drawn.error();
    return renderer.read();
}

Result<void> FilmJob::begin(const PictureRequest& request, double shown_time_s) {
    auto renderer = SceneRenderer::make();
    if (!renderer) return renderer.error();
    auto writer = FilmWriter::begin(request.path, request.width, request.height, request.rate_Hz);
    if (!writer) return writer.error();
    renderer_ = std::move(*renderer);
    writer_ = std::move(*writer);
    request_ = request;
    shown_time_s_ = shown_time_s;
    done_ = 0;
    watch_ = {};
    return {};
}

Result<double> FilmJob::add(const DrawnScene& scene, const ViewColors& colors, const Camera& camera) {
    const Result<Image> image = draw_picture(*renderer_, scene, static_cast<std::uint64_t>(done_) + 1, colors, camera, {request_.width, request_.height});
    Result<void> added = image ? writer_->add(*image) : Result<void>(image.error());
    if (added) ++done_;
    const bool last = added && done_ == picture_count(request_);
    if (last) added = writer_->finish();
    if (last || !added) writer_.reset();
    if (!added) return added.error();
    return last ? shown_time_s_ : time_s();
}

bool FilmJob::draw(PanelContext& context) const {
    if (!begin_dialog(context.theme, "Writing pictures", 360.0f)) return false;
    const int count = picture_count(request_);
    const double left = done_ > 0 ? watch_.seconds() * (count - done_) / done_ : 0.0;
    ImGui::TextUnformatted((with_separators(done_) + " of " + with_separators(count) + " pictures").c_str());
    if (done_ > 0) {
        ImGui::SameLine();
        right_aligned(duration_label(left) + " left");
    }
    ImGui::ProgressBar(static_cast<float>(done_) / static_cast<float>(count), {-1.0f, 0.0f});
    const bool cancel = ImGui::Button("Cancel", {-1.0f, 0.0f}) || ImGui::IsKeyPressed(ImGuiKey_Escape, false);
    context.items.mark("film/cancel");
    if (cancel) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return cancel;
}

}  // namespace myo
