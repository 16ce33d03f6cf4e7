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

/// Copy of the 3D view at the time when images of it were requested. Later changes of the workbench do not affect the
/// images.
struct FilmedView {
    commands::WorkbenchState state;           // copied when the writing began
    commands::MotionSummary motion;           // of the shown trial, with the body cut as in the view
    viewport::ViewportState view;             // camera and size of the view
    std::vector<MeasuredDistance> distances;  // to be drawn into the images
    platform::Theme theme;
    std::vector<ImWchar> letters = {};  // of names in other scripts, see platform::load_fonts()
};

/// Renders the view into an image file, or the motion into many images or a video. One image per frame of the window,
/// so that the window stays responsive and the user can cancel. Used on the UI thread.
class FilmJob {
public:
    /// Whether images remain to be written.
    bool runs() const { return filmed_.has_value(); }
    /// Number of images written so far.
    int done() const { return done_; }

    /// Starts writing. A running job is cancelled first.
    ///
    /// @param request  without time_s an image shows the state's time
    /// Error: the target cannot be written, or the driver refuses the size.
    Result<void> begin(const PictureRequest& request, FilmedView filmed);
    /// Renders and writes the next image; does nothing while field values are being computed. Requires runs(). Returns
    /// true after the last image. Errors: the image cannot be rendered or written; the job has ended then.
    Result<bool> add(const commands::Backend& backend);
    /// Cancels the job; unfinished output is removed.
    void cancel();
    /// The request that is being carried out.
    const PictureRequest& request() const { return request_; }

    /// Draws the dialog with the progress. Returns true if the user pressed Cancel.
    bool draw(PanelContext& context) const;

private:
    /// Time of the next image in the trial [s].
    double time_s() const { return request_.from_s + done_ * request_.speed / request_.rate_Hz; }
    /// Renders one scene with its annotations.
    Result<platform::Image> picture(const viewport::DrawnScene& scene);
    /// Draws annotations over the rendered scene, which is still in the renderer's framebuffer.
    void draw_overlay(const viewport::DrawnScene& scene);

    PictureRequest request_;                           // its size in pixels, never 0
    std::optional<FilmedView> filmed_;                 // empty: no job runs
    float scale_ = 1.0f;                               // of lines and text
    std::unique_ptr<platform::FilmWriter> writer_;     // null: a single image
    std::optional<viewport::SceneRenderer> renderer_;  // own renderer: images have another size than the view
    std::optional<platform::PictureCanvas> canvas_;
    commands::FieldStore fields_;  // own store: the view may show another field meanwhile
    Stopwatch watch_;              // for the remaining time
    int done_ = 0;                 // images written
};

/// Scale of lines and text in an image: the same size relative to the image as in the view, unless that would be
/// illegible.
float picture_scale(const viewport::ViewSize& view, const viewport::ViewSize& picture, float view_scale);

}  // namespace myo::ui::panels
