#pragma once

#include <filesystem>
#include <optional>

namespace myo::ui::panels {

/// The 3D view as a picture, or as pictures one after the other.
struct PictureRequest {
    std::filesystem::path path;
    int width = 0, height = 0;          // [pixels]; 0: as the view is
    bool overlay = true;                // with legend, scale bar, axes, names, distances and the time
    std::optional<double> time_s = {};  // of one picture; empty: as shown when it is drawn
    bool moves = false;                 // a film (.mp4) or numbered pictures of the motion, else one picture of now
    double rate_Hz = 30.0;              // pictures in a second of the film
    double speed = 1.0;                 // of the film against real time
    double from_s = 0.0, to_s = 0.0;
};

/// Pictures of it: both ends included.
inline int picture_count(const PictureRequest& request) {
    return request.moves
               ? 1 + static_cast<int>((request.to_s - request.from_s) * request.rate_Hz / request.speed + 1e-9)
               : 1;
}

}  // namespace myo::ui::panels
