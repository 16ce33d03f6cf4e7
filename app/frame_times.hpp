#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/result.hpp"

namespace myo::app {

/// Wall-clock times of the frames of one situation, up to the last pixel.
struct FrameTimes {
    std::string name;      // "the view turns"
    double goal_ms = 0.0;  // target for the 95th percentile
    // One entry per frame, in their order.
    std::vector<double> ms;

    /// Percentile by nearest rank [ms]; NaN without frames.
    ///
    /// @param share  of the frames that were not slower, 0 ... 1
    double percentile(double share) const;
};

/// Result of the benchmark of the window.
struct FrameBench {
    int triangles = 0;      // surface triangles of the body that is rotated and simulated
    int painted_cells = 0;  // cells of the body that is painted
    // Playing live while the model is pulled and drawn, at the end.
    double live_rate = 0.0;    // simulated time over real time
    double live_step_s = 0.0;  // length of its steps
    int live_dofs = 0;
    // In the order in which they were measured.
    std::vector<FrameTimes> situations;
};

/// Draws the workbench off screen at 1600 x 900 with bodies of its own: every panel, rotation, playback, rotation
/// during a search in the background, playing live, and first pixels of brush strokes.
///
/// @param folder  temporary, writable
/// @param done    called with each situation when it is measured; may be empty
/// Errors: the folder cannot be written, the driver cannot draw, a run fails, cancelled.
Result<FrameBench> bench_frames(const std::filesystem::path& folder, const Progress& progress,
                                const std::function<void(const FrameTimes&)>& done);

}  // namespace myo::app
