#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <memory>

#include "base/files.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "exit_status.hpp"
#include "frame_times.hpp"
#include "report/json.hpp"
#include "standard_output.hpp"

namespace myo::app {
namespace {

namespace fs = std::filesystem;

/// One line of the table: number of frames, median, 95th percentile, longest and goal [ms], name of the situation.
void print_times(const FrameTimes& times) {
    print_format("%8zu %8.1f %8.1f %8.1f %8.0f  %s\n", times.ms.size(), times.percentile(0.5), times.percentile(0.95),
                 times.percentile(1.0), times.goal_ms, times.name.c_str());
}

/// Content of the file of --json (schema frames/1); width and height are those of bench_frames() [pixels].
report::Json frames_json(const FrameBench& bench) {
    report::Json rows = report::Json::array();
    for (const FrameTimes& times : bench.situations)
        rows.push_back({{"name", times.name},
                        {"frames", times.ms.size()},
                        {"median_ms", report::json_number(times.percentile(0.5))},
                        {"p95_ms", report::json_number(times.percentile(0.95))},
                        {"longest_ms", report::json_number(times.percentile(1.0))},
                        {"goal_p95_ms", times.goal_ms}});
    return {{"schema", "frames/1"},
            {"width", 1600},
            {"height", 900},
            {"triangles", bench.triangles},
            {"painted_cells", bench.painted_cells},
            {"live",
             {{"dofs", bench.live_dofs},
              {"step_s", bench.live_step_s},
              {"simulated_over_real_time", report::json_number(bench.live_rate)}}},
            {"situations", rows}};
}

/// Measures in a temporary folder, which is removed afterwards; the process number keeps concurrent calls apart. A
/// missed goal is no failure: times depend on the machine.
int frames_command(const fs::path& json) {
    Console console(false, false);
    const Progress progress = console.progress();
    std::error_code code;
    const fs::path folder = fs::temp_directory_path(code) / ("myoloop-frames-" + std::to_string(::getpid()));
    print_format("%8s %8s %8s %8s %8s  %s\n", "frames", "median", "95 %", "longest", "goal",
                 "[ms], drawn off screen at 1600 x 900");
    const Result<FrameBench> bench = bench_frames(folder, progress, print_times);
    fs::remove_all(folder, code);
    // Only after the folder is removed.
    if (progress.cancelled()) return status_stopped;
    if (!bench) {
        console.complain(bench.error().text());
        return status_failed;
    }
    print_format("A body of %d triangles; painted: one of %d elements.\n", bench->triangles, bench->painted_cells);
    print_format("Playing live: %d degrees of freedom, steps of %.3g ms, %.2f of real time.\n", bench->live_dofs,
                 1e3 * bench->live_step_s, bench->live_rate);
    if (json.empty()) return status_done;
    if (const auto written = write_file(json, frames_json(*bench).dump(2) + "\n"); !written)
        return console.fail(written.error());
    return status_done;
}

}  // namespace

std::function<int()> declare_frames(CLI::App& app) {
    const auto json = std::make_shared<fs::path>();
    app.add_option("--json", *json, "figures to write")->type_name("FILE");
    return [json] { return frames_command(*json); };
}

}  // namespace myo::app
