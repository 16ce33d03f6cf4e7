#include "frame_times.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "backend/workbench_backend.hpp"
#include "base/files.hpp"
#include "base/stopwatch.hpp"
#include "panels/screenshot.hpp"
#include "panels/workbench_window.hpp"
#include "platform/gl.hpp"
#include "platform/offscreen_context.hpp"

namespace myo::app {
namespace {

constexpr int picture_width = 1600, picture_height = 900;
// Goals for the 95th percentile; a background job may double the time of a frame.
constexpr double goal_ms = 50.0, busy_goal_ms = 100.0, stroke_goal_ms = 100.0;

// Plate of one layer of 71 x 71 cells: 20,732 surface triangles, but a short simulation.
constexpr double plate_m = 0.142, layer_m = 0.002;
// Bar of 68,208 cells for painting.
constexpr double bar_m = 0.182, bar_side_m = 0.0594, bar_cell_m = 0.0021;
// Beam of 4,608 degrees of freedom for playing live.
constexpr double beam_m = 0.1, beam_side_m = 0.03, beam_cell_m = beam_m / 23.0;
// Five seconds at the frame rate of frame_ms().
constexpr int live_frames = 150;

/// Declaration of a box; `rest` holds markers, muscles and trials.
std::string experiment(const std::string& name, const Eigen::Vector3d& size, const std::string& rest) {
    std::ostringstream text;
    text << "schema = \"experiment/1\"\nname = \"" << name << "\"\n[geometry]\nkind = \"box\"\nsize_m = [" << size.x()
         << ", " << size.y() << ", " << size.z() << "]\n"
         << "[clamp]\nbox_m = [[-0.001, -1, -1], [0.0005, 1, 1]]\n"
            "[material]\nmodel = \"neo_hookean\"\nyoungs_modulus_Pa = 3e5\npoissons_ratio = 0.45\ndensity_kg_m3 = "
            "1070\ndamping_s = 0.003\ncalibrate = []\n"
            "[environment]\ngravity_m_s2 = [0, 0, 0]\n[registration]\nknown = true\n"
         << rest;
    return text.str();
}

/// Plate with moving markers, as something to draw and to follow; the motion is invented.
Result<void> write_plate(const std::filesystem::path& folder) {
    constexpr int markers = 8, samples = 41;
    std::ostringstream rest, trace;
    // Markers in a row along the plate, on its upper face.
    rest << "[markers]\nnoise_m = 1e-4\n[markers.rest_m]\n";
    trace << "time_s";
    const auto place = [](int m) { return plate_m * (m + 1.0) / (markers + 1.0); };
    for (int m = 0; m < markers; ++m) {
        rest << 'm' << m << " = [" << place(m) << ", " << 0.5 * plate_m << ", " << layer_m << "]\n";
        for (const char axis : {'x', 'y', 'z'}) trace << ",m" << m << '_' << axis << "_m";
    }
    for (int k = 0; k < samples; ++k) {
        const double t = 0.005 * k;
        trace << '\n' << t;
        for (int m = 0; m < markers; ++m)
            trace << ',' << place(m) * (1.0 - 0.03 * std::sin(20.0 * t)) << ',' << 0.5 * plate_m << ',' << layer_m;
    }
    rest << "[[muscle]]\nname = \"middle\"\nbox_m = [[0.01, 0, -1], [" << 0.9 * plate_m
         << ", 1, 1]]\nfibre = [1, 0, 0]\nstiffness_Pa = 1e5\n"
            "[[trial]]\nname = \"swing\"\nrole = \"fit\"\ntrace = \"swing.csv\"\nformat = \"csv\"\nstart = "
            "\"straight\"\n";
    if (const auto written = write_file(folder / "swing.csv", trace.str() + "\n"); !written) return written;
    return write_file(folder / "experiment.toml", experiment("Plate", {plate_m, plate_m, layer_m}, rest.str()));
}

/// Bar for painting; its trial exists because an experiment needs one.
Result<void> write_bar(const std::filesystem::path& folder) {
    if (const auto written = write_file(folder / "still.csv",
                                        "time_s,end_x_m,end_y_m,end_z_m\n0,0.182,0,0\n0.01,0.182,0,0\n");
        !written)
        return written;
    return write_file(folder / "experiment.toml",
                      experiment("Bar", {bar_m, bar_side_m, bar_side_m},
                                 "[markers]\nnoise_m = 1e-4\n[markers.rest_m]\nend = [0.182, 0, 0]\n"
                                 "[[trial]]\nname = \"still\"\nrole = \"fit\"\ntrace = \"still.csv\"\nformat = "
                                 "\"csv\"\nstart = \"straight\"\n"));
}

/// Beam for playing live.
Result<void> write_beam(const std::filesystem::path& folder) {
    return write_file(folder / "experiment.toml",
                      experiment("Beam", {beam_m, beam_side_m, beam_side_m},
                                 "[[trial]]\nname = \"free\"\nrole = \"simulate\"\nduration_s = 1\nstart = "
                                 "\"straight\"\n"));
}

/// Drives the workbench off screen and measures its frames.
class Bench {
public:
    Bench(const Progress& progress, const std::function<void(const FrameTimes&)>& done)
        : progress_(progress), done_(done), workbench_(backend::make_core_backend()) {}

    /// Runs the three parts; the context must exist as long as the window draws.
    Result<FrameBench> run(const std::filesystem::path& folder) {
        auto context = ui::platform::OffscreenContext::make(picture_width, picture_height);
        if (!context) return context.error();
        auto window = ui::panels::WorkbenchWindow::make(workbench_);
        if (!window) return window.error();
        window_ = &*window;
        for (const auto& part : {&Bench::draw_plate, &Bench::pull_beam, &Bench::paint_bar})
            if (const auto drawn = (this->*part)(folder); !drawn) return drawn.error();
        return std::move(result_);
    }

private:
    const ui::commands::WorkbenchState& state() const { return workbench_.state(); }

    /// Draws a frame; returns its wall-clock time [ms].
    ///
    /// @param seconds  time that passes for animations and playback
    Result<double> frame_ms(double seconds = 1.0 / 30.0) {
        if (progress_.cancelled()) return Error{"stopped", ""};
        const Stopwatch watch;
        if (const auto drawn = window_->draw_frame(picture_width, picture_height, seconds); !drawn)
            return drawn.error();
        // The time counts until the last pixel is drawn.
        ui::platform::gl::Finish();
        return 1e3 * watch.seconds();
    }
    /// Draws frames until the requested state is visible and no input is pending.
    Result<void> settle() {
        for (int frame = 0; frame < 6 || !window_->input().empty(); ++frame)
            if (const auto ms = frame_ms(); !ms) return ms.error();
        return {};
    }
    /// Waits until no job runs. Errors: a job failed; cancelled.
    Result<void> wait() { return ui::panels::wait_for_jobs(workbench_, progress_); }
    /// Publishes the times of a situation.
    void finish(FrameTimes times) {
        if (done_) done_(times);
        result_.situations.push_back(std::move(times));
    }

    /// Opens an experiment and meshes it with hexahedra of this edge length [m].
    Result<void> open(const std::filesystem::path& folder, double cell_m) {
        workbench_.execute(ui::commands::Open{folder, std::nullopt});
        if (const auto opened = wait(); !opened) return opened;
        ui::commands::Settings settings = state().settings;
        settings.element = mesh::CellType::hex8;
        settings.resolution_m = cell_m;
        workbench_.execute(ui::commands::ChangeSettings{settings, "resolution"});
        workbench_.execute(ui::commands::BuildMesh{});
        return wait();
    }

    /// Rotates the view by dragging a few pixels per frame while `goes_on` holds.
    Result<FrameTimes> turn(const std::string& name, double goal, const std::function<bool(int)>& goes_on) {
        FrameTimes times{name, goal, {}};
        const auto view = window_->items().find("view");
        if (!view) return Error{"the window shows no view", ""};
        // At the edge of the view, where a brush does not take the drag.
        const ImVec2 start{view->lowest.x + 0.5f * view->width(), view->highest.y - 12.0f};
        // Press and release lie outside of the measured frames: they may change more than the view.
        window_->input().push(ui::platform::MouseMoved{start.x, start.y});
        window_->input().push(ui::platform::MouseButton{0, true, {}});
        if (const auto settled = settle(); !settled) return settled.error();
        for (int k = 0; goes_on(k); ++k) {
            const float angle = 0.1f * static_cast<float>(k);
            window_->input().push(
                ui::platform::MouseMoved{start.x + 150.0f * std::sin(angle), start.y - 4.0f + 4.0f * std::cos(angle)});
            const auto ms = frame_ms();
            if (!ms) return ms.error();
            times.ms.push_back(*ms);
        }
        window_->input().push(ui::platform::MouseButton{0, false, {}});
        if (const auto settled = settle(); !settled) return settled.error();
        return times;
    }

    /// Many triangles: panels, rotation and playback, without and with a job in the background.
    Result<void> draw_plate(const std::filesystem::path& folder) {
        if (const auto written = write_plate(folder / "plate"); !written) return written;
        // Every panel once still and once rotating, then playback, then a background search.
        if (const auto opened = open(folder / "plate", layer_m); !opened) return opened;
        workbench_.execute(ui::commands::Run{});
        // The run of the plate is what playback shows below.
        if (const auto ran = wait(); !ran) return ran;
        if (const auto settled = settle(); !settled) return settled;
        result_.triangles = static_cast<int>(window_->scene().surface->triangle_count());

        FrameTimes still{"every panel in turn, nothing moves", goal_ms, {}},
            turning{"every panel in turn, the view turns", goal_ms, {}};
        for (const std::string& panel : window_->panel_names()) {
            window_->show_panel(panel);
            if (const auto settled = settle(); !settled) return settled;
            for (int k = 0; k < 12; ++k) {
                const auto ms = frame_ms();
                if (!ms) return ms.error();
                still.ms.push_back(*ms);
            }
            const auto times = turn(panel, goal_ms, [](int k) { return k < 12; });
            if (!times) return times.error();
            turning.ms.insert(turning.ms.end(), times->ms.begin(), times->ms.end());
        }
        finish(std::move(still));
        finish(std::move(turning));

        window_->show_panel("markers");
        FrameTimes playing{"the run plays over the marker plots", goal_ms, {}};
        // A tenth of real time, as the motion lasts 0.2 s only.
        workbench_.execute(ui::commands::SetSpeed{0.1});
        workbench_.execute(ui::commands::Play{});
        if (const auto settled = settle(); !settled) return settled;
        for (int k = 0; k < 120; ++k) {
            const auto ms = frame_ms();
            if (!ms) return ms.error();
            playing.ms.push_back(*ms);
        }
        workbench_.execute(ui::commands::Play{false});
        finish(std::move(playing));

        // A search runs in the background; the view rotates while its best result is played.
        ui::commands::OptimizeRequest request = state().optimize;
        request.max_evaluations = 100;
        workbench_.execute(ui::commands::ChangeOptimize{request});
        workbench_.execute(ui::commands::Optimize{});
        // A search that could not begin says why in the log.
        if (!state().busy()) return Error{state().log.back().text, "optimisation"};
        window_->show_panel("search");
        const Stopwatch watch;
        auto searching = turn("the view turns while signals are sought", busy_goal_ms,
                              [&](int k) { return state().busy() && (k < 200 || watch.seconds() < 20.0); });
        if (!searching) return searching.error();
        workbench_.execute(ui::commands::Cancel{});
        (void)wait();  // a search stopped before its first evaluation reports a failure, which is irrelevant here
        finish(std::move(*searching));
        return {};
    }

    /// The beam plays live while the mouse pulls its free end up and down.
    Result<void> pull_beam(const std::filesystem::path& folder) {
        if (const auto written = write_beam(folder / "beam"); !written) return written;
        workbench_.execute(ui::commands::ChangeSettings{state().saved_settings, "as opened"});
        if (const auto opened = open(folder / "beam", beam_cell_m); !opened) return opened;
        window_->show_panel("live");
        if (const auto settled = settle(); !settled) return settled;
        workbench_.execute(ui::commands::PlayLive{});
        // The model is made in the background; frames must be drawn for its result to arrive.
        for (const Stopwatch watch; !(state().live && state().live->ready) && watch.seconds() < 20.0;)
            if (const auto ms = frame_ms(); !ms) return ms.error();
        const auto view = window_->items().find("view");
        if (!state().live || !state().live->ready || !view) return Error{"the model does not play", "beam"};
        // The body lies in the middle of the view, where the mouse takes hold of it.
        const ImVec2 middle = view->center();
        window_->input().push(ui::platform::MouseMoved{middle.x, middle.y});
        window_->input().push(ui::platform::MouseButton{0, true, {}});
        if (const auto settled = settle(); !settled) return settled;
        if (!state().live->controls.grip) return Error{"the mouse does not hold the body", "beam"};
        FrameTimes pulling{"the model plays live while the mouse pulls it", goal_ms, {}};
        for (int k = 0; k < live_frames; ++k) {
            window_->input().push(
                ui::platform::MouseMoved{middle.x, middle.y + 60.0f * std::sin(0.1f * static_cast<float>(k))});
            const auto ms = frame_ms();
            if (!ms) return ms.error();
            pulling.ms.push_back(*ms);
        }
        result_.live_rate = state().live->rate;
        result_.live_step_s = state().live->frame->step_s;
        result_.live_dofs = static_cast<int>(state().body->dofs);
        window_->input().push(ui::platform::MouseButton{0, false, {}});
        workbench_.execute(ui::commands::PlayLive{false});
        finish(std::move(pulling));
        return settle();
    }

    /// Time from pressing the brush until the changed colours are drawn.
    Result<void> paint_bar(const std::filesystem::path& folder) {
        if (const auto written = write_bar(folder / "bar"); !written) return written;
        workbench_.execute(ui::commands::ChangeSettings{state().saved_settings, "as opened"});
        if (const auto opened = open(folder / "bar", bar_cell_m); !opened) return opened;
        result_.painted_cells = static_cast<int>(state().body->mesh.cell_count());
        window_->show_panel("fibres");
        ui::commands::Settings settings = state().settings;
        settings.muscles.emplace_back();
        settings.muscles.back().name = "painted";
        settings.muscles.back().signal = fibre::Signal::constant(1.0);
        workbench_.execute(ui::commands::ChangeSettings{settings, "add muscle"});
        ui::commands::BrushSettings brush = state().brush;
        brush.tool = ui::commands::BrushTool::add;
        workbench_.execute(ui::commands::ChangeBrush{brush});
        if (const auto settled = settle(); !settled) return settled;
        const auto view = window_->items().find("view");
        if (!view) return Error{"the window shows no view", ""};
        FrameTimes strokes{"from a press of the brush to its first pixel", stroke_goal_ms, {}},
            going{"a stroke goes on", goal_ms, {}};
        for (int k = 0; k < 12; ++k) {
            const float share = 0.36f + 0.025f * static_cast<float>(k);
            const ImVec2 at{view->lowest.x + share * view->width(), view->center().y};
            window_->input().push(ui::platform::MouseMoved{at.x, at.y});
            if (const auto settled = settle(); !settled) return settled;
            // The stroke is visible when the tints of the surface differ.
            const Eigen::Matrix4Xf before = window_->scene().tints;
            window_->input().push(ui::platform::MouseButton{0, true, {}});
            // A press may need several frames until its colours are visible; all of them count.
            double waited = 0.0;
            for (int frame = 0; frame < 10; ++frame) {
                const auto ms = frame_ms();
                if (!ms) return ms.error();
                waited += *ms;
                if (window_->scene().tints.cols() != before.cols() || window_->scene().tints != before) break;
            }
            strokes.ms.push_back(waited);
            for (int frame = 1; frame <= 5; ++frame) {
                window_->input().push(ui::platform::MouseMoved{at.x, at.y + 4.0f * static_cast<float>(frame)});
                const auto ms = frame_ms();
                if (!ms) return ms.error();
                going.ms.push_back(*ms);
            }
            window_->input().push(ui::platform::MouseButton{0, false, {}});
            if (const auto settled = settle(); !settled) return settled;
        }
        if (!(state().chosen_paint() && state().chosen_paint()->weights.maxCoeff() > 0.0))
            return Error{"the strokes painted nothing", "bar"};
        finish(std::move(strokes));
        finish(std::move(going));
        return {};
    }

    const Progress& progress_;
    const std::function<void(const FrameTimes&)>& done_;
    ui::commands::Workbench workbench_;
    ui::panels::WorkbenchWindow* window_ = nullptr;
    FrameBench result_;
};

}  // namespace

double FrameTimes::percentile(double share) const {
    if (ms.empty()) return std::nan("");
    std::vector<double> sorted = ms;
    std::sort(sorted.begin(), sorted.end());
    // Nearest rank, from 1: a time that was measured, not an interpolation.
    const auto rank = static_cast<std::size_t>(std::ceil(share * static_cast<double>(sorted.size())));
    return sorted[std::clamp<std::size_t>(rank, 1, sorted.size()) - 1];
}

Result<FrameBench> bench_frames(const std::filesystem::path& folder, const Progress& progress,
                                const std::function<void(const FrameTimes&)>& done) {
    return Bench(progress, done).run(folder);
}

}  // namespace myo::app
