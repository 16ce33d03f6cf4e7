#include <charconv>
#include <memory>
#include <string_view>

#include "backend/project_file.hpp"
#include "backend/workbench_backend.hpp"
#include "base/overwrites.hpp"
#include "base/text.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "exit_status.hpp"
#include "experiment/read_experiment.hpp"
#include "options.hpp"
#include "panels/screenshot.hpp"
#include "results/output_files.hpp"

namespace myo::app {
namespace {

/// Parsed call of `myoloop screenshot`.
struct ScreenshotCall {
    ui::panels::ScreenshotOptions picture;
    std::filesystem::path out;
    std::string theme = "dark";
    int percent = 100;       // size of text and controls
    bool as_opened = false;  // draws without a run
    bool quiet = false;
    bool json_progress = false;
};

/// Parses "1600x900", sides 320 ... 8192 pixels.
void parse_size(const std::string& text, ui::panels::ScreenshotOptions& picture) {
    const auto side = [](std::string_view word, int& value) {
        const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
        return code == std::errc{} && end == word.data() + word.size() && value >= 320 && value <= 8192;
    };
    const std::size_t cross = text.find('x');
    if (cross == std::string::npos || !side(std::string_view(text).substr(0, cross), picture.width) ||
        !side(std::string_view(text).substr(cross + 1), picture.height))
        throw CLI::ValidationError("--size", "'" + text + "' is not of the form 1600x900, with sides from 320 to 8192");
}

/// Files that are read for the picture, including those that a project or experiment refers to.
std::vector<std::filesystem::path> files_drawn(const ui::panels::ScreenshotOptions& picture) {
    std::vector<std::filesystem::path> files{picture.open, picture.import};
    std::filesystem::path source = picture.open;
    if (ui::commands::is_project(picture.open))
        if (const Result<ui::commands::Project> project = backend::read_project_file(picture.open))
            source = project->source;
    files.push_back(source);
    if (const Result<experiment::Experiment> experiment = experiment::read_experiment(source))
        for (const std::filesystem::path& file : results::files_read(source, *experiment)) files.push_back(file);
    return files;
}

/// Opens the file, runs what was asked for, and writes the picture.
int screenshot_command(const ScreenshotCall& call) {
    Console console(call.quiet, call.json_progress);
    if (call.out.empty()) return console.refuse({"name the picture to write", "--out"});
    // The only format that is written.
    if (call.out.extension() != ".png")
        return console.refuse({"'" + call.out.string() + "' does not end in .png", "--out"});
    // A picture may lie in the folder of the experiment, but not in the place of one of its files.
    const Result<void> kept = check_overwrites("--out", {call.out}, files_drawn(call.picture));
    if (!kept) return console.refuse(kept.error());
    const Progress progress = console.progress();
    ui::panels::ScreenshotOptions picture = call.picture;
    // Calibration and search contain a run of their own.
    picture.run = !call.as_opened && !call.picture.calibrate && !call.picture.optimize;
    picture.theme = call.theme == "light" ? ui::platform::ThemeName::light : ui::platform::ThemeName::dark;
    // The option is in percent.
    picture.scale = 0.01f * static_cast<float>(call.percent);
    const Result<ui::platform::Image> image = ui::panels::draw_screenshot(backend::make_core_backend(), picture,
                                                                          progress);
    if (progress.cancelled()) {
        console.complain("stopped; nothing was written");
        return status_stopped;
    }
    if (!image) return console.refuse(image.error());
    if (const Result<void> written = ui::platform::write_png(*image, call.out); !written)
        return console.fail(written.error());
    console.print(call.out.string());
    return status_done;
}

/// What the picture shows of the opened file.
void add_shown_options(CLI::App& app, ScreenshotCall& call) {
    app.add_option("--trial", call.picture.trial, "trial to show")->type_name("NAME");
    app.add_option("--marker", call.picture.marker, "marker to plot")->type_name("NAME");
    add_optional_number(app, "--time", call.picture.time_s, "time to show [s] (default: the end of the trial)")
        ->type_name("SECONDS");
    app.add_option("--field", call.picture.field,
                   "quantity that colours the body: displacement, stretch, von_mises, ...")
        ->type_name("NAME");
    app.add_option("--import", call.picture.import, "recording of motion capture to show, as before it becomes a trial")
        ->type_name("FILE");
    add_unit(app, call.picture.metres_per_unit);
}

}  // namespace

std::function<int()> declare_screenshot(CLI::App& app) {
    const auto call = std::make_shared<ScreenshotCall>();
    app.add_option("FILE", call->picture.open, "experiment folder, mesh or project (default: the start page)")
        ->type_name("");
    app.add_option("--out", call->out, "picture to write")->type_name("X.png");
    app.add_option_function<std::string>(
           "--size", [call](const std::string& text) { parse_size(text, call->picture); },
           "width and height in pixels (default 1600x900)")
        ->type_name("WxH");
    app.add_option("--panel", call->picture.panels, "panels to bring to the front, at the side and below the view")
        ->delimiter(',')
        ->type_name("A,B");
    app.add_option("--theme", call->theme, "dark or light (default: dark)")
        ->check(CLI::IsMember({"dark", "light"}))
        ->type_name("NAME");
    app.add_option("--scale", call->percent, "size of text and controls, 75 to 250 (default: 100)")
        ->check(CLI::Range(75, 250))
        ->type_name("PERCENT");
    add_shown_options(app, *call);
    app.add_flag("--calibrate", call->picture.calibrate, "calibrate before drawing, instead of a plain run");
    app.add_flag("--optimize", call->picture.optimize,
                 "look for the muscles' signals before drawing, instead of a plain run");
    app.add_flag("--diagnose", call->picture.diagnose, "diagnose, too: for the panel diagnose");
    app.add_flag("--as-opened", call->as_opened, "draw without running anything");
    app.add_flag("--quiet", call->quiet, "print errors only");
    app.add_flag("--json-progress", call->json_progress, "progress as one JSON line per event on standard error");
    return [call] { return screenshot_command(*call); };
}

}  // namespace myo::app
