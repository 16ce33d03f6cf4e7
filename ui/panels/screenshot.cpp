#include "panels/screenshot.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <thread>

#include "base/text.hpp"
#include "commands/field_store.hpp"
#include "commands/workbench.hpp"
#include "panels/workbench_window.hpp"
#include "platform/offscreen_context.hpp"

namespace myo::ui::panels {
namespace {

/// Index of the element with a given name. An empty name gives `otherwise`. Error: unknown name, with the known ones
/// listed.
template <class Named>
Result<int> index_of(const std::string& what, const std::string& name, const std::vector<Named>& all, int otherwise) {
    // The names found on the way are listed in the error.
    if (name.empty()) return otherwise;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].name == name) return static_cast<int>(i);
        names.push_back(all[i].name);
    }
    return Error{"there is no " + what + " \"" + name + "\"; there is " + join(names), ""};
}

/// Selects trial, marker, time and field as the options say. Called before the run, so that errors appear early, and
/// after it, as the run changes them.
Result<void> choose(commands::Workbench& workbench, const ScreenshotOptions& options) {
    if (!workbench.state().scene) return {};
    const commands::Scene& scene = *workbench.state().scene;
    const commands::DiagnosisView* const d = workbench.state().diagnosis.get();
    const auto trial = index_of("trial", options.trial, scene.trials, d ? d->worst_trial : 0);
    if (!trial) return trial.error();
    if (const auto fields = commands::field_kinds(workbench.backend());
        !options.field.empty() && std::none_of(fields.begin(), fields.end(),
                                               [&](const commands::FieldKind& f) { return f.id == options.field; })) {
        std::vector<std::string> ids;
        for (const commands::FieldKind& field : fields) ids.push_back(field.id);
        return Error{"there is no field \"" + options.field + "\"; there is " + join(ids), ""};
    }
    // Everything is looked up before anything is changed, so that an unknown name changes nothing.
    const auto marker = index_of("marker", options.marker, scene.markers, d ? d->worst_marker : 0);
    if (!marker) return marker.error();
    workbench.execute(commands::ChooseTrial{*trial});
    workbench.execute(commands::ChooseMarker{*marker});
    // Without a time the end of the trial: the workbench limits the greatest number to it.
    workbench.execute(commands::SetTime{options.time_s.value_or(std::numeric_limits<double>::max())});
    commands::ViewOptions view = workbench.state().view;
    view.field = options.field;
    workbench.execute(commands::ChangeView{view});
    return {};
}

/// Opens the file of the options and waits for it.
Result<void> open(commands::Workbench& workbench, const ScreenshotOptions& options, const Progress& progress) {
    workbench.execute(commands::Open{options.open, options.metres_per_unit});
    // The window would ask; without a display this is an error.
    if (workbench.state().unit_question) {
        return Error{"the file does not say in which unit its numbers are; give one (mm or m)", options.open.string()};
    }
    if (const auto opened = wait_for_jobs(workbench, progress); !opened) return opened.error();
    return {};
}

/// Runs the jobs of the options, one after the other.
Result<void> compute(commands::Workbench& workbench, const ScreenshotOptions& options, const Progress& progress) {
    if (options.calibrate) workbench.execute(commands::Calibrate{});
    // One job at most; a calibration contains a run.
    else if (options.optimize)
        workbench.execute(commands::Optimize{});
    else if (options.run)
        workbench.execute(commands::Run{});
    if (const auto ran = wait_for_jobs(workbench, progress); !ran) return ran.error();
    if (options.diagnose) workbench.execute(commands::Diagnose{});
    if (const auto diagnosed = wait_for_jobs(workbench, progress); !diagnosed) return diagnosed.error();
    return {};
}

}  // namespace

Result<void> wait_for_jobs(commands::Workbench& workbench, const Progress& progress) {
    while (workbench.state().busy()) {
        workbench.advance(0.0);
        if (!workbench.state().job) break;
        progress.report(workbench.state().job->progress);
        if (progress.cancelled()) {
            workbench.execute(commands::Cancel{});
            return Error{"stopped", ""};
        }
        // There is no window to wake, so the state is polled.
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    // A job that failed has logged a failure; the state keeps no other trace of it.
    for (const commands::LogLine& line : workbench.state().log) {
        if (line.level == commands::LogLevel::failure) return Error{line.text, ""};
    }
    return {};
}

// Panels are shown twice: first to report unknown names at once, and again at the end, as opening and jobs show others.
Result<platform::Image> draw_screenshot(std::shared_ptr<commands::Backend> backend, const ScreenshotOptions& options,
                                        const Progress& progress) {
    // The context must exist before the window, which creates GPU objects in it, and outlive it.
    auto context = platform::OffscreenContext::make(options.width, options.height);
    if (!context) return context.error();
    commands::Workbench workbench(std::move(backend));
    workbench.execute(commands::SetTheme{options.theme, options.scale});
    auto window = WorkbenchWindow::make(workbench);
    if (!window) return window.error();
    for (const std::string& panel : options.panels)
        if (!window->show_panel(panel))
            return Error{"there is no panel \"" + panel + "\"; there is " + join(window->panel_names()), ""};
    if (!options.open.empty()) {
        if (const auto opened = open(workbench, options, progress); !opened) return opened.error();
    }
    if (const auto chosen = choose(workbench, options); !chosen) return chosen.error();
    if (workbench.state().scene) {
        if (const auto computed = compute(workbench, options, progress); !computed) return computed.error();
    }
    // The import comes last, as the timeline then shows the recording.
    if (!options.import.empty()) {
        workbench.execute(commands::ReadRecording{options.import});
        if (const auto read = wait_for_jobs(workbench, progress); !read) return read.error();
    }
    if (const auto chosen = choose(workbench, options); !chosen) return chosen.error();
    for (const std::string& panel : options.panels) window->show_panel(panel);
    // Sizes of texts are known from the second frame on, scroll positions from the third.
    for (int frame = 0; frame < 5 || window->waits_for_field(); ++frame)
        if (const auto drawn = window->draw_frame(options.width, options.height, 0.02); !drawn) return drawn.error();
    return platform::read_frame(options.width, options.height);
}

}  // namespace myo::ui::panels
