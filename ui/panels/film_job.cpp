#include "panels/film_job.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "panels/escape.hpp"
#include "panels/job_text.hpp"
#include "panels/widgets.hpp"
#include "viewport/view_overlay.hpp"

namespace myo::ui::panels {
namespace {

constexpr float min_picture_scale = 0.75f;  // minimum for letters 10 pixels high

/// Widens the field of view for an image that is narrower than the view, so that it contains everything that the view
/// shows.
viewport::Camera widened(viewport::Camera camera, const viewport::ViewSize& view, const viewport::ViewSize& picture) {
    const double by = std::max(1.0, view.aspect() / picture.aspect());
    camera.field_of_view = 2.0 * std::atan(by * std::tan(0.5 * camera.field_of_view));
    return camera;
}

/// Time in the corner of an image. Three decimals, so that its width does not change within a video.
std::string time_label(double time_s) {
    char text[40];
    std::snprintf(text, sizeof text, "t = %.3f s", time_s);
    return text;
}

}  // namespace

float picture_scale(const viewport::ViewSize& view, const viewport::ViewSize& picture, float view_scale) {
    // The smaller ratio counts: annotations must fit in both directions.
    const float wide = static_cast<float>(picture.width) / static_cast<float>(view.width),
                high = static_cast<float>(picture.height) / static_cast<float>(view.height);
    return std::max(min_picture_scale, view_scale * std::min(wide, high));
}

/// Everything that can fail is created before the first image: renderer, canvas and writer.
Result<void> FilmJob::begin(const PictureRequest& request, FilmedView filmed) {
    cancel();
    request_ = request;
    // 0 stands for the size of the view at this moment.
    if (request_.width <= 0) request_.width = filmed.view.size().width, request_.height = filmed.view.size().height;
    // A single image shows the time of the request, whatever is shown when it is rendered.
    if (!request_.moves) request_.from_s = request_.time_s.value_or(filmed.state.time_s);
    const viewport::ViewSize view = filmed.view.size(), size{request_.width, request_.height};
    scale_ = picture_scale(view, size, filmed.theme.scale);
    filmed.view.camera = widened(filmed.view.camera, view, size);
    // Overlays are drawn as in the view, whose rectangle is now the whole image.
    filmed.view.pixels = {{0.0f, 0.0f}, {static_cast<float>(size.width), static_cast<float>(size.height)}};
    // Without the window's background light annotations would vanish.
    if (request_.background != PictureBackground::view)
        filmed.theme = platform::make_theme(platform::ThemeName::light, filmed.theme.scale);
    auto renderer = viewport::SceneRenderer::make();
    if (!renderer) return renderer.error();
    auto canvas = platform::PictureCanvas::make(filmed.theme.name, scale_, filmed.letters);
    // The writer comes last, so that a failure above leaves no partial file.
    if (!canvas) return canvas.error();
    if (request_.moves) {
        auto writer = platform::FilmWriter::begin(request_.path, request_.width, request_.height, request_.rate_Hz);
        if (!writer) return writer.error();
        writer_ = std::move(*writer);
    }
    // Nothing can fail from here on; until now runs() is false.
    renderer_ = std::move(*renderer);
    canvas_ = std::move(*canvas);
    filmed_ = std::move(filmed);
    done_ = 0;
    watch_ = {};
    return {};
}

void FilmJob::cancel() {
    writer_.reset();
    filmed_.reset();
    renderer_.reset();
    canvas_.reset();
}

/// The image is rendered from a copy of the state at its own time; the window's view is not affected.
Result<bool> FilmJob::add(const commands::Backend& backend) {
    commands::WorkbenchState& state = filmed_->state;
    state.time_s = time_s();
    std::shared_ptr<const commands::FieldFrame> field = fields_.update(state, backend);
    if (fields_.waits()) field = fields_.update(state, backend);  // fast fields are complete after a second call
    // Field values are computed on another thread; the next frame tries again.
    if (fields_.waits()) return false;
    const std::optional<commands::FieldKind> kind = commands::shown_field(state, backend);
    const viewport::DrawnScene scene = commands::scene_at_time(state, filmed_->theme, filmed_->motion, nullptr,
                                                               kind ? &*kind : nullptr, field.get());
    const Result<platform::Image> image = picture(scene);
    Result<void> added = !image    ? Result<void>(image.error())
                         : writer_ ? writer_->add(*image)
                                   : platform::write_png(*image, request_.path);
    if (added) ++done_;
    // A failure ends the job as the last image does; its output is removed by the writer.
    const bool last = added && done_ == picture_count(request_);
    if (last && writer_) added = writer_->finish();
    if (last || !added) cancel();
    if (!added) return added.error();
    return last;
}

Result<platform::Image> FilmJob::picture(const viewport::DrawnScene& scene) {
    const viewport::ViewSize size{request_.width, request_.height};
    // A new revision for each image, as the scene differs in every one.
    viewport::ViewColors colors = viewport::view_colors(filmed_->theme);
    if (request_.background != PictureBackground::view) colors.top = colors.bottom = viewport::Color::Ones();
    colors.transparent = request_.background == PictureBackground::transparent;
    const auto drawn = renderer_->update(scene, static_cast<std::uint64_t>(done_) + 1, colors, filmed_->view.camera,
                                         size, 4, static_cast<double>(scale_));
    if (!drawn) return drawn.error();
    if (request_.overlay) draw_overlay(scene);
    return renderer_->read(colors.transparent);
}

/// Draws the view's annotations with fonts of the image's scale, and the time if there is a motion.
void FilmJob::draw_overlay(const viewport::DrawnScene& scene) {
    const viewport::ViewportState& view = filmed_->view;
    const commands::WorkbenchState& state = filmed_->state;
    // Distances follow the motion, so their lengths are computed for each image.
    measure(filmed_->distances, scene);
    canvas_->draw(renderer_->framebuffer(), request_.width, request_.height,
                  [&](ImDrawList& list, const platform::Theme& theme) {
                      // Names of markers follow the option of the view.
                      viewport::draw_view_overlay(list, view.pixels, view.camera, scene, theme, state.view.labels);
                      draw_distances(list, theme, filmed_->distances, scene, view);
                      if (const auto span = commands::time_span(state); span[1] > span[0])
                          viewport::draw_view_title(list, view.pixels, time_label(state.time_s), theme);
                  });
}

bool FilmJob::draw(PanelContext& context) const {
    // The dialog is modal: edits during the writing would not appear in the images.
    if (!begin_dialog(context.theme, "Writing pictures", 360.0f)) return false;
    const int count = picture_count(request_);
    // Estimated from the images so far, all of which took about the same time.
    const double left = done_ > 0 ? watch_.seconds() * (count - done_) / done_ : 0.0;
    ImGui::TextUnformatted(
        (with_separators(done_) + " of " + with_separators(count) + (count == 1 ? " picture" : " pictures")).c_str());
    if (done_ > 0) {
        ImGui::SameLine();
        right_aligned(time_left_range(left) + " left");
    }
    ImGui::ProgressBar(static_cast<float>(done_) / static_cast<float>(count), {-1.0f, 0.0f});
    const bool cancel = ImGui::Button("Cancel", {-1.0f, 0.0f}) || escape_closes();
    context.items.mark("film/cancel");
    if (cancel) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
    return cancel;
}

}  // namespace myo::ui::panels
