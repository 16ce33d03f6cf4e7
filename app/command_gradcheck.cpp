#include <algorithm>
#include <cstdio>
#include <memory>

#include "base/text.hpp"
#include "calibration/gradcheck.hpp"
#include "commands.hpp"
#include "exit_status.hpp"
#include "experiment_command.hpp"
#include "prediction/trial_goals.hpp"
#include "report/json.hpp"

namespace myo::app {
namespace {

/// Largest relative difference between adjoint and finite differences of a passed check.
constexpr double max_relative_error = 1e-5;
/// What an early cancellation prevents, for stopped_before().
const char* const complete_check = "the check was complete";

/// Parsed call of `myoloop gradcheck`.
struct GradcheckCall : ExperimentCall {
    std::string json;
    int steps = 8;  // time steps of the checked run
};

/// One line per parameter: adjoint, finite difference, relative error.
std::string table_of(const sensitivity::GradientCheck& check) {
    char line[256];
    std::snprintf(line, sizeof line, "%-44s %16s %16s %14s", "parameter", "adjoint", "difference", "relative error");
    std::string text = line;
    for (const sensitivity::GradientCheckRow& row : check.rows) {
        std::snprintf(line, sizeof line, "\n%-44.44s %16.8e %16.8e ", row.name.c_str(), row.adjoint, row.difference);
        text += line;
        std::snprintf(line, sizeof line, "%14.2e", row.relative_error);
        text += row.has_influence ? line : "  no influence";
    }
    std::snprintf(line, sizeof line, "\n\nmedian %.2e, worst %.2e, %zu parameters", check.median_error(),
                  check.worst_error(), check.rows.size());
    return text + line;
}

/// How many rows were not compared; empty if all were.
std::string untested_sentence(const sensitivity::GradientCheck& check) {
    const auto count = std::count_if(check.rows.begin(), check.rows.end(),
                                     [](const sensitivity::GradientCheckRow& row) { return !row.has_influence; });
    return count == 0 ? ""
                      : "\n" + std::to_string(count) +
                            " parameters without influence within these steps were not compared; more --steps may help";
}

/// Content of the file of --json (schema gradcheck/1), SI units.
report::Json gradcheck_json(const setup::Setup& setup, const calibration::TrialGradientCheck& run,
                            const results::RunFacts& facts) {
    report::Json rows = report::Json::array();
    for (const sensitivity::GradientCheckRow& row : run.check.rows)
        rows.push_back({{"name", row.name},
                        {"adjoint", report::json_number(row.adjoint)},
                        {"difference", report::json_number(row.difference)},
                        {"relative_error", report::json_number(row.relative_error)},
                        {"has_influence", row.has_influence}});
    return {{"schema", "gradcheck/1"},
            {"trial", setup.trials.front().name},
            {"dofs", setup.body->dofs()},
            {"element", to_string(setup.body->kind)},
            {"integrator", to_string(setup.settings.integrator)},
            {"strategy", to_string(setup.settings.strategy)},
            {"dt_s", setup.trials.front().options.h_s},
            {"steps", run.steps},
            {"loss_m2", report::json_number(run.loss_m2)},
            {"against_trace", run.against_trace},
            {"median_relative_error", report::json_number(run.check.median_error())},
            {"worst_relative_error", report::json_number(run.check.worst_error())},
            {"limit", max_relative_error},
            {"left_out", run.left_out},
            {"seconds", run.seconds},
            {"version", facts.version},
            {"command", facts.command},
            {"parameters", rows}};
}

/// Complains about a gradient that differs from its differences. Returns the exit status.
int judge_gradient(const calibration::TrialGradientCheck& run, Console& console) {
    if (run.check.worst_error() <= max_relative_error) return status_done;
    // The message names the worst parameter, where the search for the error should begin.
    const auto worst = std::max_element(
        run.check.rows.begin(), run.check.rows.end(),
        [](const sensitivity::GradientCheckRow& a, const sensitivity::GradientCheckRow& b) {
            return a.relative_error < b.relative_error;
        });
    console.complain("the gradient differs from differences by " + format_number(worst->relative_error, 2) + " for " +
                     worst->name + ", more than " + format_number(max_relative_error, 1));
    return status_failed;
}

/// Opens the trial, compares adjoint and differences, prints the table and writes it on request.
int gradcheck_command(const GradcheckCall& call) {
    Console console(call.work.quiet, call.work.json_progress);
    const Progress progress = console.progress();
    const OpenedExperiment opening = open_command(call, TrialChoice::one, complete_check, console, progress);
    if (!opening.setup) return opening.status;
    // A trial with goals is compared with these instead of a recording.
    const Result<setup::Setup> target = prediction::with_goals(*opening.setup);
    if (!target) return console.refuse(target.error());
    const setup::Setup& setup = *target;
    for (const std::string& warning : setup.warnings) console.warn(warning);
    const setup::PreparedTrial& checked = setup.trials.front();
    console.print(setup.experiment.name + ", trial " + checked.name + ": " + std::to_string(call.steps) + " steps of " +
                  format_number(1e3 * checked.options.h_s, 4) + " ms\n" + size_line(setup));

    const double setup_s = opening.stopwatch.seconds();
    const calibration::TrialGradientCheck run = calibration::gradcheck(setup, 0, call.steps, progress);
    if (progress.cancelled()) return stopped_before(complete_check, console);
    // The run itself failed, so there is nothing to compare.
    if (!run.check.complete()) {
        console.complain("the gradient could not be checked: " + run.check.message +
                         "; a smaller --dt or fewer --steps may help");
        return status_failed;
    }
    console.print(std::string("loss: mean square distance of the markers to ") +
                  (!run.against_trace                 ? "their rest positions"
                   : prediction::follows_goals(setup) ? "the goals"
                                                      : "the measured trace") +
                  ", " + format_number(1e6 * run.loss_m2, 4) + " mm2\n\n" + table_of(run.check) + ", " +
                  format_number(run.seconds, 3) + " s" + untested_sentence(run.check) +
                  (run.left_out.empty() ? "" : "\nnot checked: " + join(run.left_out)));
    if (!call.json.empty())
        if (const Result<void> written = report::write_json(call.json,
                                                            gradcheck_json(setup, run, run_facts(call, setup_s)));
            !written)
            return console.fail(written.error());
    return judge_gradient(run, console);
}

}  // namespace

std::function<int()> declare_gradcheck(CLI::App& app) {
    const auto call = std::make_shared<GradcheckCall>();
    // Only an optional JSON file is written, so no output folder is locked.
    call->writes_folder = false;
    // A few steps are run: choosing their length would cost more than the check.
    call->step_choice = StepChoice::half_interval;
    call->outputs = [own = call.get()](const experiment::Experiment&) {
        return std::vector<std::filesystem::path>{own->json};
    };
    declare_experiment_call(app, *call);
    app.add_option("--trial", call->trial, "trial to check (default: the first with role fit)")->type_name("NAME");
    add_count(app, "--steps", call->steps, "steps of its run (default: 8)");
    app.add_option("--json", call->json, "also write the table to this file")->type_name("FILE");
    return [call] { return gradcheck_command(*call); };
}

}  // namespace myo::app
