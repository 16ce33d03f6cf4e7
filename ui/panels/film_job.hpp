#pragma once

#include <memory>
#include <optional>

#include "base/stopwatch.hpp"
#include "panels/panel.hpp"
#include "platform/film.hpp"
#include "viewport/scene_renderer.hpp"

namespace myo {

/// Draws the motion into files, one picture in each frame of the window, so that it can be stopped at any time.
class FilmJob {
public:
    bool runs() const { return writer_ != nullptr; }
    /// Pictures so far.
    int done() const { return done_; }

    /// The time at which the first picture is drawn, in the state's time. Error: cannot be written.
    Result<void> begin(const PictureRequest& request, double shown_time_s);
    /// Adds the scene as it is; the time of the next picture, or, after the last, the time that was shown before.
    Result<double> add(const DrawnScene& scene, const ViewColors& colors, const Camera& camera);
    void give_up() { writer_.reset(); }
    double time_s() const { return request_.from_s + done_ * request_.speed / request_.rate_Hz; }
    const PictureRequest& request() const { return request_; }

    /// How far it is, and Cancel; true when it was pressed.
    bool draw(PanelContext& context) const;

private:
    PictureRequest request_;
    std::unique_ptr<FilmWriter> writer_;
    std::optional<SceneRenderer> renderer_;
    Stopwatch watch_;
    double shown_time_s_ = 0.0;
    int done_ = 0;
};

/// The scene drawn in a size of its own. Error: the driver refuses the size.
Result<Image> draw_picture(SceneRenderer& renderer, const DrawnScene& scene, std::uint64_t revision, const ViewColors& colors, const Camera& camera, const ViewSize& size);

}  // namespace myo
