#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/result.hpp"

namespace myo::app {

/// Wall time of every frame of one situation, up to its last pixel.
struct FrameTimes {
    std::string name;      // "the view turns"
    double goal_ms = 0.0;  // for the 95th percentile
    std::vector<double> ms;

    /// Nearest rank. @param share  of the frames that took no longer, 0 to 1
    double percentile(double share) const;
};

struct FrameBench {
    int triangles = 0;      // of the body that is turned and run
    int painted_cells = 0;  // of the body that is painted
    std::vector<FrameTimes> situations;
};

/// Draws the workbench off screen at 1600 x 900 with bodies it makes itself: every panel in turn, turning, playing,
/// turning while signals are sought in the background, and first pixels of brush strokes.
///
/// @param folder  that may be written into
/// @param done    gets each situation as it is measured; may be empty
/// Errors: the folder cannot be written, the driver refuses to draw, a run fails, cancelled.
Result<FrameBench> bench_frames(const std::filesystem::path& folder, const Progress& progress,
                                const std::function<void(const FrameTimes&)>& done);

}  // namespace myo::app
