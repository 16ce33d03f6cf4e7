#include <memory>

#include "base/text.hpp"
#include "commands.hpp"
#include "exit_status.hpp"
#include "experiment_command.hpp"
#include "planning/power_output.hpp"

namespace myo::app {
namespace {

/// What an early cancellation prevents, for stopped_before().
const char* const complete_map = "the map was complete";
const char* const map_json_file = "power.json";
const char* const map_page_file = "power.html";

/// Parsed call of `myoloop power`.
struct PowerCall : ExperimentCall {
    // Output file; empty: none.
    std::string json;
    // rms error of predictions by mesh and step; empty: from the noise.
    std::optional<double> numerical_error_m;
    // Ids of the effects that are considered; empty: all.
    std::vector<std::string> only;
};

/// Writes the map as JSON where --json asks for it, and as JSON and page into the folder of --out.
Result<void> write_map(const PowerCall& call, const planning::PowerMap& map, const experiment::Experiment& experiment,
                       const results::RunFacts& facts) {
    const std::string folder = std::filesystem::weakly_canonical(experiment.folder).filename().string();
    const report::Json json = planning::power_json(map, folder, facts);
    if (!call.json.empty())
        if (const Result<void> written = report::write_json(call.json, json); !written) return written;
    if (call.out.empty()) return {};
    if (const Result<void> written = report::write_json(call.out / map_json_file, json); !written) return written;
    return report::write_html(call.out / map_page_file, planning::power_report(map, experiment.name, facts));
}

/// Opens the experiment, runs every effect on it, prints and writes the map.
int power_command(PowerCall& call) {
    Console console(call.work.quiet, call.work.json_progress);
    const Progress progress = console.progress();
    // Unlike in other commands, --out is optional; without it no folder is locked.
    call.writes_folder = !call.out.empty();
    const OpenedExperiment opening = open_command(call, TrialChoice::all, complete_map, console, progress);
    if (!opening.setup) return opening.status;
    const setup::Setup& setup = *opening.setup;
    for (const std::string& warning : setup.warnings) console.warn(warning);
    console.print(setup.experiment.name + "\n" + size_line(setup));
    const double setup_s = opening.stopwatch.seconds();
    planning::PowerSettings settings;
    settings.numerical_error_m = call.numerical_error_m;
    settings.only = call.only;
    const planning::PowerMap map = planning::power_map(setup, settings, progress);
    if (map.stopped) return stopped_before(complete_map, console);
    if (!map.failure.empty()) {
        console.complain(with_options(map.failure));
        return status_failed;
    }
    console.print("\n" + planning::power_lines(map) + "\n\n" + std::to_string(map.runs) + " runs, " +
                  format_number(map.seconds, 3) + " s");
    if (const Result<void> written = write_map(call, map, opening.experiment, run_facts(call, setup_s)); !written)
        return console.fail(written.error());
    if (!call.out.empty()) console.print("report: " + (call.out / map_page_file).string());
    return status_done;
}

}  // namespace

std::function<int()> declare_power(CLI::App& app) {
    const auto call = std::make_shared<PowerCall>();
    declare_experiment_call(app, *call);
    // Only what was asked for is written.
    call->outputs = [own = call.get()](const experiment::Experiment&) {
        std::vector<std::filesystem::path> files;
        if (!own->json.empty()) files.emplace_back(own->json);
        if (!own->out.empty()) files.insert(files.end(), {own->out / map_json_file, own->out / map_page_file});
        return files;
    };
    add_named_effects(app, "--effects", call->only, "effects that are considered (default: all)", *call);
    add_positive_number(app, "--numerical-error", call->numerical_error_m,
                        "rms error of the predictions by mesh and step in m (default: from the noise)");
    app.add_option("--json", call->json, "file for the map as JSON")->type_name("FILE");
    return [call] { return power_command(*call); };
}

}  // namespace myo::app
