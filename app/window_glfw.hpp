#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include "base/result.hpp"
#include "commands/backend.hpp"

namespace myo::app {

/// Initial state of the window.
struct WindowOptions {
    int width = 1600;  // [screen units]
    int height = 900;
    std::filesystem::path open;  // experiment folder or mesh; empty: none
    // A given scale replaces that of the preferences.
    std::optional<float> scale;  // of text and controls; default: that of the screen
};

/// Opens the workbench in a window and returns when it is closed.
///
/// Errors: no display, or the driver lacks OpenGL 3.3.
Result<void> run_window(std::shared_ptr<ui::commands::Backend> backend, const WindowOptions& options);

}  // namespace myo::app
