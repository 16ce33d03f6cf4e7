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

namespace myo {

/// The 3D view when pictures of it are asked for. What happens later, as playing, a search or another run, is not in them.
struct FilmedView {
    WorkbenchState state;
    MotionSummary motion;              // of its trial, the body cut as in the view
    ViewportState view;
    std::vector<MeasuredDistance> distances;
    Theme theme;
};

/// Draws the view into a file, or the motion into many: one picture in each frame of the window, so that it can be stopped at any time.
class FilmJob {
public:
    bool runs() const { return filmed_.has_value(); }
    /// Pictures so far.
    int done() const { return done_; }

    /// @param request  a picture without a time is of the state's
    /// Error: cannot be written.
    Result<void> begin(const PictureRequest& request, FilmedView filmed);
    /// Draws the next picture, unless values that colour the body are still being computed. True when it was the last.
    Result<bool> add(const Backend& backend);
    void give_up();
    const PictureRequest& request() const { return request_; }

    /// How far it is, and Cancel; true when it was pressed.
    bool draw(PanelContext& context) const;

private:
    /// Of the next picture.
    double time_s() const { return request_.from_s + done_ * request_.speed / request_.rate_Hz; }
    Result<Image> picture(const DrawnScene& scene);
    void draw_overlay(const DrawnScene& scene);

    PictureRequest request_;
    std::optional<FilmedView> filmed_;
    float scale_ = 1.0f;               // of lines and letters
    std::unique_ptr<FilmWriter> writer_;   // null: one picture alone
    std::optional<SceneRenderer> renderer_;
    std::optional<PictureCanvas> canvas_;
    FieldStore fields_;
    Stopwatch watch_;
    int done_ = 0;
};

/// Of lines and letters in a picture: as large against it as they are in the view, where that can be read.
float picture_scale(const ViewSize& view, const ViewSize& picture, float view_scale);

}  // namespace myo
