#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "commands/backend.hpp"
#include "platform/image.hpp"
#include "platform/theme.hpp"

namespace myo::ui::commands {
class Workbench;
}  // namespace myo::ui::commands

namespace myo::ui::panels {

struct ScreenshotOptions {
    std::filesystem::path open;             // empty = the empty workbench
    std::optional<double> metres_per_unit;  // of a mesh file without unit
    int width = 1600;                       // [pixels]
    int height = 900;
    std::vector<std::string> panels;  // brought to the front; empty = as it starts
    std::string trial;                // shown; empty = the first, or that of a diagnosis
    std::string marker;               // plotted; likewise
    bool run = true;                  // simulate before drawing, where possible
    bool calibrate = false;           // calibrate instead
    bool optimize = false;            // look for the muscles' signals instead
    bool diagnose = false;            // diagnose besides, and show where the declared model is furthest off
    std::optional<double> time_s;     // shown; empty = the end of the trial
    platform::ThemeName theme = platform::ThemeName::dark;
    float scale = 1.0f;
    std::filesystem::path import;  // a recording that is being made a trial; empty: none
    std::string field;             // colours the body, by its id; empty: none
};

/// Draws the workbench without a display.
///
/// Errors: what the workbench would show as a failure (the file cannot be opened, the run failed); unknown panel, trial
/// or marker; cancelled.
Result<platform::Image> draw_screenshot(std::shared_ptr<commands::Backend> backend, const ScreenshotOptions& options,
                                        const Progress& progress = {});

/// Waits until no job runs, reporting its progress; a failure in the log is the error.
Result<void> wait_for_jobs(commands::Workbench& workbench, const Progress& progress);

}  // namespace myo::ui::panels
