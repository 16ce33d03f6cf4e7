#include <utility>

#include "panels/workbench_window.hpp"
#include "platform/image.hpp"

// Pictures and films that are written from the window.

namespace myo::ui::panels {
namespace {

/// Beginning of the message after a failure.
std::string cannot_write(const PictureRequest& request) {
    return request.moves ? "Cannot write the pictures: " : "Cannot write the picture: ";
}

}  // namespace

/// Images start after the view has been rendered once, as they use its camera and size.
void WorkbenchWindow::begin_pictures() {
    if (!picture_ || film_.runs()) return;
    const PictureRequest request = *std::exchange(picture_, std::nullopt);
    const Result<void> begun = film_.begin(request, {workbench_->state(), motion_, viewport_, distances_.distances(),
                                                     interface_.theme(), interface_.letters()});
    if (!begun)
        workbench_->execute(
            commands::LogMessage{commands::LogLevel::failure, cannot_write(request) + begun.error().text()});
}

/// One image per frame, with a message after the last one.
void WorkbenchWindow::add_picture() {
    if (!film_.runs()) return;
    const PictureRequest request = film_.request();
    const Result<bool> last = film_.add(workbench_->backend());
    const std::string written = request.moves ? std::to_string(film_.done()) + " pictures written to "
                                              : "Picture written to ";
    if (!last)
        workbench_->execute(
            commands::LogMessage{commands::LogLevel::failure, cannot_write(request) + last.error().text()});
    else if (*last)
        workbench_->execute(commands::LogMessage{commands::LogLevel::done, written + request.path.string() + "."});
}

/// The part is read from the framebuffer, so it looks exactly as in the window.
void WorkbenchWindow::write_part(int width, int height) {
    const WindowPart part = *std::exchange(part_, std::nullopt);
    const Result<void> written = platform::write_png(
        platform::cropped(platform::read_frame(width, height), part.pixels), part.path);
    workbench_->execute(
        written
            ? commands::LogMessage{commands::LogLevel::done, "Picture written to " + part.path.string() + "."}
            : commands::LogMessage{commands::LogLevel::failure, "Cannot write the picture: " + written.error().text()});
}

}  // namespace myo::ui::panels
