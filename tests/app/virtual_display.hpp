#pragma once

#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace myo::test {

/// A program that goes on beside the test, with files for what it writes; killed when it outlives the object or the
/// test.
class Companion {
public:
    /// @param words      program and arguments; a program without a slash is looked up in PATH
    /// @param variables  NAME=VALUE, added to the environment
    /// @param keep_fd    a descriptor that the program inherits; -1: none
    Companion(const std::vector<std::string>& words, const std::filesystem::path& out, const std::filesystem::path& err,
              const std::vector<std::string>& variables = {}, int keep_fd = -1);
    ~Companion();
    Companion(const Companion&) = delete;
    Companion& operator=(const Companion&) = delete;

    /// Exit status, or 128 + signal; empty while it runs.
    std::optional<int> ended();

private:
    pid_t pid_;
    std::optional<int> status_;
};

/// Asks every 20 ms until it is so; false after limit_s.
bool wait_until(double limit_s, const std::function<bool()>& is_so);

/// Pixels as 0xRRGGBB, row by row.
struct Screenshot {
    int width = 0, height = 0;
    std::vector<unsigned> pixels;

    /// Number of different colours at x >= left, y >= top.
    std::size_t colours(int left = 0, int top = 0) const;
    /// Rows that have a pixel of nearly this colour 0xRRGGBB at left <= x < right, from above.
    std::vector<int> rows_with(unsigned colour, int left, int right) const;
};

/// An X server without a screen (Xvfb) on a free display number.
class VirtualDisplay {
public:
    /// Null where the server or xdotool is not installed, or it does not start.
    static std::unique_ptr<VirtualDisplay> start(const std::filesystem::path& folder, int width, int height);
    ~VirtualDisplay();

    const std::string& name() const { return name_; }  // ":7"

    /// The mapped window of this title, 0 when there is none.
    unsigned long window(const std::string& title);
    /// What the window shows; empty when it cannot be read just now.
    Screenshot picture(unsigned long window);
    void resize(unsigned long window, int width, int height);
    /// Moves the mouse to a place in the window and clicks, as a person's hand would: by the server's own pointer
    /// (xdotool). False when that failed.
    bool click(unsigned long window, int x, int y);
    /// Gives the window the keyboard and presses keys, as "ctrl+r" (xdotool). False when that failed.
    bool press(unsigned long window, const std::string& keys);
    /// Asks the window to close, as a window manager does.
    void close(unsigned long window);

private:
    VirtualDisplay() = default;
    bool xdotool(std::vector<std::string> words);

    std::filesystem::path folder_;
    std::unique_ptr<Companion> server_;
    std::string name_;
    void* display_ = nullptr;  // Display*; Xlib's macros stay out of this header
};

}  // namespace myo::test
