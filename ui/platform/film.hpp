#pragma once

#include <filesystem>
#include <memory>

#include "platform/image.hpp"

namespace myo::ui::platform {

/// Whether films can be written: ffmpeg is found on the path.
bool can_write_films();

/// Pictures one after the other, as a film or as numbered files. What is not finished leaves nothing behind.
class FilmWriter {
public:
    /// @param path     ending in .mp4: a film (H.264 by ffmpeg); else a new folder of frame_0001.png, frame_0002.png,
    /// ...
    /// @param rate_Hz  pictures in a second of the film
    /// Errors: the folder is taken; there is no ffmpeg; cannot be written.
    static Result<std::unique_ptr<FilmWriter>> begin(const std::filesystem::path& path, int width, int height,
                                                     double rate_Hz);

    virtual ~FilmWriter() = default;
    /// A picture of the size given at the beginning.
    virtual Result<void> add(const Image& image) = 0;
    /// Gives it its name.
    virtual Result<void> finish() = 0;
};

}  // namespace myo::ui::platform
