#include <algorithm>

#include "commands/workbench.hpp"
#include "measurement/trace_file.hpp"

// Files that were dropped on the window.

namespace myo::ui::commands {
namespace {

namespace fs = std::filesystem;

/// A folder may end like a recording, so the type of the path counts too.
bool is_recording(const fs::path& path) {
    std::error_code ignored;
    return measurement::has_trace_ending(path) && !fs::is_directory(path, ignored);
}

}  // namespace

void Workbench::on(const Drop& command) {
    const std::vector<fs::path>& files = command.files;
    const auto recording = std::find_if(files.begin(), files.end(), is_recording);
    const auto body = std::find_if_not(files.begin(), files.end(), is_recording);
    if (body != files.end()) {
        if (request_) return open(*body, std::nullopt);  // open() logs why not; the recording is dropped with it
        // The recording needs the body, which is opened on another thread, so it waits until that is done.
        dropped_with_body_.reset();
        if (recording != files.end()) dropped_with_body_ = *recording;
        open(*body, std::nullopt);
    } else if (recording != files.end()) {
        read_recording(*recording, {});
    }
    const auto taken = (body != files.end() ? 1 : 0) + (recording != files.end() ? 1 : 0);
    if (const auto left = static_cast<std::ptrdiff_t>(files.size()) - taken; left > 0)
        log(LogLevel::warning,
            "Only one body and one recording can be opened at a time; " + std::to_string(left) +
                (left == 1 ? " of the dropped files is left out." : " of the dropped files are left out."));
}

}  // namespace myo::ui::commands
