#include "platform/film.hpp"

#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <system_error>

#include "base/files.hpp"

namespace myo::ui::platform {

namespace fs = std::filesystem;

namespace {

/// Quotes a text for the POSIX shell. File names come from the user and may hold spaces, quotes or `$`.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

/// Writes frame_0001.png, frame_0002.png, … into `<folder>.part` and renames that folder in finish(), so that a folder
/// with the final name always holds the complete film.
class NumberedFiles : public FilmWriter {
public:
    explicit NumberedFiles(const fs::path& folder) : folder_(folder), part_(folder.string() + ".part") {
        std::error_code ignored;
        fs::remove_all(part_, ignored);
        fs::create_directories(part_, code_);
    }
    ~NumberedFiles() override {
        std::error_code ignored;
        if (!finished_) fs::remove_all(part_, ignored);
    }
    Result<void> add(const Image& image) override {
        if (code_) return Error{"cannot be created: " + code_.message(), part_.string()};
        char name[40];
        std::snprintf(name, sizeof name, "frame_%04d.png", ++count_);
        return write_png(image, part_ / name);
    }
    Result<void> finish() override {
        fs::rename(part_, folder_, code_);
        if (code_) return Error{"cannot be written: " + code_.message(), folder_.string()};
        finished_ = true;
        return {};
    }

private:
    fs::path folder_, part_;
    std::error_code code_;
    int count_ = 0;
    bool finished_ = false;
};

/// Pipes raw RGBA frames into ffmpeg, which encodes H.264 into `<file>.part.mp4`; finish() renames it to the final
/// name.
class Mp4 : public FilmWriter {
public:
    Mp4(const fs::path& file, int width, int height, double rate_Hz) : file_(file), part_(file.string() + ".part.mp4") {
        char format[160];
        // yuv420p and faststart: the combination that browsers and presentation programs play.
        std::snprintf(format, sizeof format,
                      "-f rawvideo -pix_fmt rgba -s %dx%d -r %.6g -i - -c:v libx264 -preset veryfast -crf 18 -pix_fmt "
                      "yuv420p -movflags +faststart ",
                      width, height, rate_Hz);
        // If ffmpeg ends early, the failed fwrite reports it. Without this line SIGPIPE would end the workbench.
        before_ = std::signal(SIGPIPE, SIG_IGN);
        pipe_ = popen(
            ("ffmpeg -y -loglevel error " + std::string(format) + quoted(part_.string()) + " >/dev/null 2>&1").c_str(),
            "w");
    }
    ~Mp4() override {
        // finish() sets pipe_ to null, so an open pipe here means that the film was abandoned: the partial file is
        // removed.
        const bool finished = pipe_ == nullptr;
        (void)close();
        std::signal(SIGPIPE, before_);
        std::error_code ignored;
        if (!finished) fs::remove(part_, ignored);
    }
    Result<void> add(const Image& image) override {
        if (!pipe_ || std::fwrite(image.rgba.data(), 1, image.rgba.size(), pipe_) != image.rgba.size()) return failed();
        return {};
    }
    Result<void> finish() override {
        std::error_code code;
        // ffmpeg reports encoding errors only by its exit code, which pclose returns.
        if (close() == 0)
            fs::rename(part_, file_, code);
        else
            code = std::make_error_code(std::errc::io_error);
        if (!code) return {};
        std::error_code ignored;
        fs::remove(part_, ignored);
        return failed();
    }

private:
    // Ends ffmpeg and waits for it. Returns its exit status, -1 if the pipe is closed already or was never opened.
    int close() { return pipe_ ? pclose(std::exchange(pipe_, nullptr)) : -1; }
    Error failed() const {
        return {"ffmpeg did not write the film; check the disk space and its support of H.264", file_.string()};
    }

    fs::path file_, part_;
    FILE* pipe_ = nullptr;
    void (*before_)(int) = SIG_DFL;
};

}  // namespace

bool can_write_films() {
    // Searches PATH as the shell does. Running ffmpeg to find out would block the frame that draws the dialog.
    const char* const path = std::getenv("PATH");
    std::string rest = path ? path : "";
    while (!rest.empty()) {
        const std::size_t colon = rest.find(':');
        if (access((rest.substr(0, colon) + "/ffmpeg").c_str(), X_OK) == 0) return true;
        rest = colon == std::string::npos ? "" : rest.substr(colon + 1);
    }
    return false;
}

Result<std::unique_ptr<FilmWriter>> FilmWriter::begin(const fs::path& path, int width, int height, double rate_Hz) {
    std::error_code code;
    if (path.extension() == ".mp4") {
        // All checks come before the first frame is rendered, so that a bad target fails at once and not after minutes.
        if (!can_write_films())
            return Error{"films need the program ffmpeg, which is not on the path; write numbered pictures instead",
                         path.string()};
        if (fs::exists(path, code) && !fs::is_regular_file(path, code))
            return Error{"is not a plain file; choose another name", path.string()};
        if (!fs::is_directory(path.parent_path().empty() ? fs::path(".") : path.parent_path(), code))
            return Error{"there is no such folder", path.parent_path().string()};
        return std::unique_ptr<FilmWriter>(std::make_unique<Mp4>(behind_links(path), width, height, rate_Hz));
    }
    if (fs::exists(path, code)) return Error{"exists already; choose a new folder", path.string()};
    return std::unique_ptr<FilmWriter>(std::make_unique<NumberedFiles>(path));
}

}  // namespace myo::ui::platform
