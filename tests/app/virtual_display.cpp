#include "app/virtual_display.hpp"

#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <set>
#include <thread>

namespace myo::test {
namespace {

Display* x(void* display) { return static_cast<Display*>(display); }

/// A window may be gone when it is asked for: the answer is then nothing, not the end of the test.
int ignore_error(Display*, XErrorEvent*) { return 0; }

bool in_path(const std::string& program) {
    const char* const path = std::getenv("PATH");
    std::string folder;
    for (const char* c = path != nullptr ? path : "";; ++c) {
        if (*c != ':' && *c != '\0') {
            folder += *c;
            continue;
        }
        if (::access((folder + "/" + program).c_str(), X_OK) == 0) return true;
        if (*c == '\0') return false;
        folder.clear();
    }
}

/// The display number that the server writes when it is ready; empty when it ends before.
std::string read_line(int fd, Companion& server) {
    std::string line;
    ::fcntl(fd, F_SETFL, O_NONBLOCK);
    wait_until(60.0, [&] {
        char c = 0;
        while (::read(fd, &c, 1) == 1) {
            if (c == '\n') return true;
            line += c;
        }
        return server.ended().has_value();
    });
    return line;
}

}  // namespace

Companion::Companion(const std::vector<std::string>& words, const std::filesystem::path& out,
                     const std::filesystem::path& err, const std::vector<std::string>& variables, int keep_fd) {
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    pid_ = ::fork();
    if (pid_ != 0) return;
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // also when the test itself is killed
    ::dup2(::open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDOUT_FILENO);
    ::dup2(::open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), STDERR_FILENO);
    if (keep_fd >= 0) ::fcntl(keep_fd, F_SETFD, 0);
    for (const std::string& variable : variables) ::putenv(const_cast<char*>(variable.c_str()));
    ::execvp(arguments[0], arguments.data());
    ::_exit(127);
}

Companion::~Companion() {
    if (ended()) return;
    ::kill(pid_, SIGTERM);
    if (wait_until(5.0, [&] { return ended().has_value(); })) return;
    ::kill(pid_, SIGKILL);
    ::waitpid(pid_, nullptr, 0);
}

std::optional<int> Companion::ended() {
    int status = 0;
    if (!status_ && ::waitpid(pid_, &status, WNOHANG) == pid_)
        status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return status_;
}

bool wait_until(double limit_s, const std::function<bool()>& is_so) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(limit_s);
    while (!is_so()) {
        if (std::chrono::steady_clock::now() > end) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return true;
}

std::size_t Screenshot::colours(int left, int top) const {
    std::set<unsigned> seen;
    for (int row = top; row < height; ++row)
        for (int column = left; column < width; ++column)
            seen.insert(pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                               static_cast<std::size_t>(column)]);
    return seen.size();
}

std::vector<int> Screenshot::rows_with(unsigned colour, int left, int right) const {
    const auto near = [&](unsigned pixel) {
        int apart = 0;
        for (const int shift : {0, 8, 16})
            apart += std::abs(static_cast<int>((pixel >> shift) & 0xffu) - static_cast<int>((colour >> shift) & 0xffu));
        return apart < 40;
    };
    std::vector<int> rows;
    for (int row = 0; row < height; ++row) {
        const auto begin = pixels.begin() + static_cast<std::ptrdiff_t>(row) * width;
        if (std::any_of(begin + left, begin + std::min(right, width), near)) rows.push_back(row);
    }
    return rows;
}

std::unique_ptr<VirtualDisplay> VirtualDisplay::start(const std::filesystem::path& folder, int width, int height) {
    int number[2];
    if (!in_path("Xvfb") || !in_path("xdotool") || ::pipe2(number, O_CLOEXEC) != 0) return nullptr;
    std::unique_ptr<VirtualDisplay> made(new VirtualDisplay);
    made->folder_ = folder;
    made->server_ = std::make_unique<Companion>(
        std::vector<std::string>{"Xvfb", "-displayfd", std::to_string(number[1]), "-screen", "0",
                                 std::to_string(width) + "x" + std::to_string(height) + "x24", "-nolisten", "tcp"},
        folder / "xvfb.out", folder / "xvfb.err", std::vector<std::string>{}, number[1]);
    ::close(number[1]);
    made->name_ = ":" + read_line(number[0], *made->server_);
    ::close(number[0]);
    if (made->name_ == ":") return nullptr;
    XSetErrorHandler(ignore_error);
    made->display_ = XOpenDisplay(made->name_.c_str());
    return made->display_ != nullptr ? std::move(made) : nullptr;
}

VirtualDisplay::~VirtualDisplay() {
    if (display_ != nullptr) XCloseDisplay(x(display_));
}

unsigned long VirtualDisplay::window(const std::string& title) {
    Window root = 0, parent = 0, *children = nullptr, found = 0;
    unsigned count = 0;
    if (XQueryTree(x(display_), DefaultRootWindow(x(display_)), &root, &parent, &children, &count) == 0) return 0;
    for (unsigned i = 0; i < count; ++i) {
        char* name = nullptr;
        XWindowAttributes attributes;
        if (XFetchName(x(display_), children[i], &name) != 0 && name != nullptr && title == name &&
            XGetWindowAttributes(x(display_), children[i], &attributes) != 0 && attributes.map_state == IsViewable)
            found = children[i];
        if (name != nullptr) XFree(name);
    }
    if (children != nullptr) XFree(children);
    return found;
}

Screenshot VirtualDisplay::picture(unsigned long window) {
    Screenshot shot;
    XWindowAttributes attributes;
    if (XGetWindowAttributes(x(display_), window, &attributes) == 0) return shot;
    XImage* const image = XGetImage(x(display_), window, 0, 0, static_cast<unsigned>(attributes.width),
                                    static_cast<unsigned>(attributes.height), AllPlanes, ZPixmap);
    if (image == nullptr) return shot;
    shot.width = image->width;
    shot.height = image->height;
    for (int row = 0; row < shot.height; ++row)
        for (int column = 0; column < shot.width; ++column)
            shot.pixels.push_back(static_cast<unsigned>(XGetPixel(image, column, row) & 0xffffffu));
    XDestroyImage(image);
    return shot;
}

void VirtualDisplay::resize(unsigned long window, int width, int height) {
    XResizeWindow(x(display_), window, static_cast<unsigned>(width), static_cast<unsigned>(height));
    XSync(x(display_), False);
}

bool VirtualDisplay::xdotool(std::vector<std::string> words) {
    words.insert(words.begin(), "xdotool");
    Companion tool(words, folder_ / "xdotool.out", folder_ / "xdotool.err", {"DISPLAY=" + name_});
    return wait_until(20.0, [&] { return tool.ended().has_value(); }) && tool.ended() == 0;
}

bool VirtualDisplay::click(unsigned long window, int x, int y) {
    return xdotool(
        {"mousemove", "--window", std::to_string(window), std::to_string(x), std::to_string(y), "click", "1"});
}

bool VirtualDisplay::press(unsigned long window, const std::string& keys) {
    return xdotool({"windowfocus", std::to_string(window), "key", keys});
}

void VirtualDisplay::close(unsigned long window) {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = window;
    event.xclient.message_type = XInternAtom(x(display_), "WM_PROTOCOLS", False);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(XInternAtom(x(display_), "WM_DELETE_WINDOW", False));
    XSendEvent(x(display_), window, False, NoEventMask, &event);
    XSync(x(display_), False);
}

}  // namespace myo::test
