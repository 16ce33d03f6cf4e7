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

/// What the image of the workbench shows. Defaults are those of the command line.
struct ScreenshotOptions {
    std::filesystem::path open;             // file or folder to open; empty = nothing
    std::optional<double> metres_per_unit;  // length unit of a mesh file without unit
    int width = 1600;                       // of the window [pixels]
    int height = 900;                       // of the window [pixels]
    std::vector<std::string> panels;        // names of panels to show; empty = the initial ones
    std::string trial;                      // shown trial; empty = the first, or the worst of a diagnosis
    std::string marker;                     // plotted marker; empty = likewise
    bool run = true;                        // simulate before drawing, if possible
    bool calibrate = false;                 // calibrate instead
    bool optimize = false;                  // optimise the muscle signals instead
    bool diagnose = false;         // diagnose afterwards, and show where the declared model has its largest error
    std::optional<double> time_s;  // shown time; empty = end of the trial
    platform::ThemeName theme = platform::ThemeName::dark;
    float scale = 1.0f;            // of text and controls
    std::filesystem::path import;  // recording to open in the import; empty: none
    std::string field;             // id of the field that colours the body; empty: none
};

/// Draws the window of the workbench without a display. Creates its own OpenGL context; takes as long as the requested
/// jobs.
///
/// Errors: anything that the workbench would log as a failure (a file that cannot be opened, a failed run); unknown
/// panel, trial, marker or field; cancelled.
Result<platform::Image> draw_screenshot(std::shared_ptr<commands::Backend> backend, const ScreenshotOptions& options,
                                        const Progress& progress = {});

/// Waits until no job runs, and reports progress. Error: a failure in the log, or cancelled.
Result<void> wait_for_jobs(commands::Workbench& workbench, const Progress& progress);

}  // namespace myo::ui::panels
