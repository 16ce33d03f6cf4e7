#pragma once

#include <filesystem>
#include <optional>

namespace myo::ui::panels {

/// What is behind the body in an image. White and transparent images have the colours of the light theme.
enum class PictureBackground { view, white, transparent };

/// A request for an image of the 3D view, or for a sequence of images of the motion.
struct PictureRequest {
    std::filesystem::path path;  // file or folder to write
    int width = 0, height = 0;   // [pixels]; 0: the size of the view
    bool overlay = true;         // draws legend, scale bars, axes, names, distances and time
    PictureBackground background = PictureBackground::view;
    std::optional<double> time_s = {};  // time of a single image; empty: the shown time
    bool moves = false;                 // sequence: a video (.mp4) or numbered images; otherwise a single image
    double rate_Hz = 30.0;              // images per second of the video
    double speed = 1.0;                 // of the video relative to real time
    double from_s = 0.0, to_s = 0.0;    // first and last time of a sequence
};

/// Number of images of a request, both ends included. 1 for a single image.
inline int picture_count(const PictureRequest& request) {
    return request.moves
               ? 1 + static_cast<int>((request.to_s - request.from_s) * request.rate_Hz / request.speed + 1e-9)
               : 1;
}

}  // namespace myo::ui::panels
