#pragma once

#include <filesystem>
#include <memory>

#include "platform/image.hpp"

namespace myo::ui::platform {

/// Returns whether .mp4 files can be written: the program ffmpeg is executable on the PATH. Searches the PATH on each
/// call.
bool can_write_films();

/// Writes a sequence of images as a video file or as numbered PNG files.
///
/// Called on the UI thread, one image per frame. The output gets its final name only in finish(); destroying an
/// unfinished writer removes what it has written.
class FilmWriter {
public:
    /// Opens a writer and checks the target.
    ///
    /// @param path  a name ending in .mp4 writes a video (H.264, encoded by ffmpeg); any other name is a new folder for
    ///              frame_0001.png, frame_0002.png, …
    /// @param width, height  size of all images [pixels]
    /// @param rate_Hz  frames per second of the video; not used for numbered files
    /// Errors: the folder exists already; ffmpeg is missing; the target is not a plain file or its folder does not
    /// exist.
    static Result<std::unique_ptr<FilmWriter>> begin(const std::filesystem::path& path, int width, int height,
                                                     double rate_Hz);

    virtual ~FilmWriter() = default;
    /// Appends one image of the size given to begin(). Error: the disk is full, or ffmpeg has ended.
    virtual Result<void> add(const Image& image) = 0;
    /// Completes the output and renames it to `path`. Call it once, after the last image.
    virtual Result<void> finish() = 0;
};

}  // namespace myo::ui::platform
