#pragma once

#include <optional>

#include "base/stopwatch.hpp"
#include "commands/field_store.hpp"
#include "commands/scene_at_time.hpp"
#include "panels/distance_tool.hpp"
#include "panels/panel.hpp"
#include "platform/film.hpp"
#include "platform/picture_canvas.hpp"
#include "viewport/scene_renderer.hpp"

namespace myo::ui::panels {

/// The 3D view when pictures of it are asked for. What happens later, as playing, a search or another run, is not in
/// them.
struct FilmedView {
    commands::WorkbenchState state;
    commands::MotionSummary motion;  // of its trial, the body cut as in the view
    viewport::ViewportState view;
    std::vector<MeasuredDistance> distances;
    platform::Theme theme;
};

/// Draws the view into a file, or the motion into many: one picture in each frame of the window, so that it can be
/// stopped at any time.
class FilmJob {
public:
    bool runs() const { return filmed_.has_value(); }
    /// Pictures so far.
    int done() const { return done_; }

    /// @param request  a picture without a time is of the state's
    /// Error: cannot be written.
    Result<void> begin(const PictureRequest& request, FilmedView filmed);
    /// Draws the next picture, unless values that colour the body are still being computed. True when it was the last.
    Result<bool> add(const commands::Backend& backend);
    void give_up();
    const PictureRequest& request() const { return request_; }

    /// How far it is, and Cancel; true when it was pressed.
    bool draw(PanelContext& context) const;

private:
    /// Of the next picture.
    double time_s() const { return request_.from_s + done_ * request_.speed / request_.rate_Hz; }
    Result<platform::Image> picture(const viewport::DrawnScene& scene);
    void draw_overlay(const viewport::DrawnScene& scene);

    PictureRequest request_;
    std::optional<FilmedView> filmed_;
    float scale_ = 1.0f;                            // of lines and letters
    std::unique_ptr<platform::FilmWriter> writer_;  // null: one picture alone
    std::optional<viewport::SceneRenderer> renderer_;
    std::optional<platform::PictureCanvas> canvas_;
    commands::FieldStore fields_;
    Stopwatch watch_;
    int done_ = 0;
};

/// Of lines and letters in a picture: as large against it as they are in the view, where that can be read.
float picture_scale(const viewport::ViewSize& view, const viewport::ViewSize& picture, float view_scale);

}  // namespace myo::ui::panels
