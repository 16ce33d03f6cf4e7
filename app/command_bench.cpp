#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "base/files.hpp"
#include "base/overwrites.hpp"
#include "base/parallel.hpp"
#include "base/text.hpp"
#include "bench/bench_case.hpp"
#include "chart/svg.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "exit_status.hpp"
#include "options.hpp"
#include "own_process.hpp"
#include "reference_files.hpp"
#include "report/json.hpp"
#include "solver/sparse_cholesky.hpp"
#include "standard_output.hpp"

namespace myo::app {
namespace {

/// Parsed call of `myoloop bench`.
struct BenchCall {
    std::string id;      // of the case; empty: all
    std::string json;    // output file; empty: none
    std::string figure;  // output file of the scaling figure; empty: none
};

/// Published times of other programs for the case of a run; `ratio` above 1: the other program is slower.
report::Json references_json(const bench::BenchFigures& f) {
    report::Json references = report::Json::array();
    for (const bench::BenchReference& r : f.references)
        references.push_back({{"label", r.label},
                              {"ms_per_step", r.ms_per_step},
                              {"ratio", report::json_number(r.ms_per_step / f.ms_per_step())}});
    return references;
}

/// Physical results of a run; a quantity without expected value or target has null there.
report::Json quantities_json(const bench::BenchFigures& f) {
    report::Json quantities = report::Json::array();
    for (const bench::BenchQuantity& q : f.quantities)
        quantities.push_back({{"name", q.name},
                              {"value", report::json_number(q.value)},
                              {"unit", q.unit},
                              {"expected", q.expected ? report::json_number(*q.expected) : report::Json()},
                              {"error", q.error() ? report::json_number(*q.error()) : report::Json()},
                              {"target", q.target ? report::json_number(*q.target) : report::Json()}});
    return quantities;
}

/// One run as JSON. A run executes in a child process and returns its figures in this form; peak memory is added by the
/// parent, which measures it.
report::Json figures_json(const bench::BenchFigures& f) {
    const report::Json references = references_json(f);
    const report::Json quantities = quantities_json(f);
    // Keys of the file of --json; a value that does not exist is null.
    return {{"name", f.name},
            {"dofs", f.dofs},
            {"cells", f.cells},
            {"steps", f.steps},
            {"dt_s", f.h_s},
            {"setup_s", report::json_number(f.setup_s)},
            {"run_s", report::json_number(f.run_s)},
            {"ms_per_step", report::json_number(f.ms_per_step())},
            {"us_per_dof_and_step", report::json_number(f.us_per_dof_and_step())},
            {"iterations_per_step", report::json_number(f.iterations_per_step)},
            {"factorisations_per_step", report::json_number(f.factorisations_per_step)},
            {"real_time_factor", report::json_number(f.real_time_factor())},
            {"limit_ms_per_step", f.limit_ms > 0.0 ? report::Json(f.limit_ms) : report::Json()},
            {"share_of_limit", f.limit_ms > 0.0 ? report::json_number(f.share_of_limit()) : report::Json()},
            {"factor_bytes", f.factor_bytes},
            {"time_split_s",
             {{"forces", f.times.forces_s},
              {"stiffness", f.times.stiffness_s},
              {"factorisation", f.times.factorisation_s},
              {"linear", f.times.linear_s}}},
            {"goal_ms_per_step", f.goal_ms ? report::Json(*f.goal_ms) : report::Json()},
            {"references", references},
            {"quantities", quantities},
            {"note", f.note}};
}

/// Name of a case and the heads of the columns that print_figures() fills.
void print_heading(const bench::BenchCase& one) {
    print_format("\n%s: %s\n", one.id.c_str(), one.summary.c_str());
    print_format("  %9s %7s %9s %7s %7s %9s %8s %7s  %s\n", "ms/step", "goal", "us/DOF", "iter.", "factor", "real time",
                 "memory", "limit", "case");
    print_format("  %9s %7s %9s %7s %7s %9s %8s %7s\n", "", "ms", "and step", "a step", "a step", "factor", "MB", "ms");
}

/// Comparison with the target error: "; target 2 %, MISSED"; empty without a target. A target needs an expected value.
std::string aimed_at(const report::Json& quantity) {
    if (quantity["target"].is_null()) return "";
    const double target = quantity["target"].get<double>();
    const bool met = std::abs(quantity["error"].get<double>()) <= target;
    return "; target " + format_number(100.0 * target, 2) + (met ? " %" : " %, MISSED");
}

/// A physical result below its row: "tip at rest, dz  -6.74 mm (expected -6.755: -0.2 %)", with the target error if
/// there is one.
void print_quantity(const report::Json& quantity) {
    const auto number = [&](const char* key, int digits) {
        return quantity[key].is_null() ? std::string("-") : format_number(quantity[key].get<double>(), digits);
    };
    std::string text = number("value", 5) + " " + quantity["unit"].get<std::string>();
    if (!quantity["error"].is_null()) {
        // Smaller differences are rounding; + 0.0 avoids "-0".
        const double hundredths = std::round(1e4 * quantity["error"].get<double>()) + 0.0;
        text += " (expected " + number("expected", 5) + ": " + format_number(0.01 * hundredths, 2) + " %" +
                aimed_at(quantity) + ")";
    }
    print_format("  %*s  %s: %s\n", 71, "", quantity["name"].get<std::string>().c_str(), text.c_str());
}

/// One row of the table, then its quantities, references and note. Static cases have no times per step.
void print_figures(const report::Json& row) {
    const auto optional = [&](const char* key) {
        return row[key].is_null() ? std::string("-") : format_number(row[key].get<double>(), 3);
    };
    // Dashes keep the columns of cases that mix static and dynamic rows.
    if (row["steps"].get<int>() == 0) {
        print_format("  %9s %7s %9s %7s %7s %9s %8.1f %7s  %s, %.2f s\n", "-", "-", "-", "-", "-", "-",
                     row["peak_memory_bytes"].get<double>() / 1e6, "-", row["name"].get<std::string>().c_str(),
                     row["run_s"].get<double>());
    } else {
        print_format("  %9.3f %7s %9.3f %7.2f %7.3f %9.2f %8.1f %7s  %s\n", row["ms_per_step"].get<double>(),
                     optional("goal_ms_per_step").c_str(), row["us_per_dof_and_step"].get<double>(),
                     row["iterations_per_step"].get<double>(), row["factorisations_per_step"].get<double>(),
                     row["real_time_factor"].get<double>(), row["peak_memory_bytes"].get<double>() / 1e6,
                     optional("limit_ms_per_step").c_str(), row["name"].get<std::string>().c_str());
    }
    for (const report::Json& quantity : row["quantities"]) print_quantity(quantity);
    for (const report::Json& reference : row["references"])
        print_format("  %9.0f %s%*s  %s: %.0f times as long\n", reference["ms_per_step"].get<double>(), "", 61, "",
                     reference["label"].get<std::string>().c_str(), reference["ratio"].get<double>());
    if (const std::string note = row["note"].get<std::string>(); !note.empty())
        print_format("  %*s  %s\n", 71, "", note.c_str());
}

/// Shares of the solver's parts in the time of a run [%].
void print_split(const report::Json& row) {
    // Time that the solver counts for none of its parts is the rest.
    const double run = row["run_s"].get<double>();
    double rest = 100.0;
    std::string text;
    for (const auto& [part, seconds] : row["time_split_s"].items()) {
        const double share = 100.0 * seconds.get<double>() / run;
        rest -= share;
        text += part + " " + format_number(share, 2) + " %, ";
    }
    if (rest < 99.9)
        print_format("  %*s  %srest %s %%\n", 71, "", text.c_str(), format_number(std::max(rest, 0.0), 2).c_str());
}

/// Exponent p of y ~ x^p, by linear least squares on the logarithms. Rows have at least two different values of x.
double exponent(const report::Json& rows, const char* y, const char* x) {
    double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
    for (const report::Json& row : rows) {
        const double lx = std::log(row[x].get<double>()), ly = std::log(row[y].get<double>());
        n += 1.0;
        sx += lx;
        sy += ly;
        sxx += lx * lx;
        sxy += lx * ly;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// Time and memory over size on logarithmic axes, with their exponents.
std::string scaling_figure(const report::Json& rows, double time_exponent, double memory_exponent) {
    std::vector<double> dofs, ms, megabytes;
    for (const report::Json& row : rows) {
        dofs.push_back(row["dofs"].get<double>());
        ms.push_back(row["ms_per_step"].get<double>());
        megabytes.push_back(row["peak_memory_bytes"].get<double>() / 1e6);
    }
    chart::Chart chart;
    chart.title = "Time per step and memory over degrees of freedom";
    chart.x = {.label = "degrees of freedom", .logarithmic = true};
    chart.panels = {{.y = {.label = "time per step", .unit = "ms", .logarithmic = true},
                     .series = {{.name = "exponent " + format_number(time_exponent, 3),
                                 .x = dofs,
                                 .y = ms,
                                 .style = chart::SeriesStyle::line_and_dots}}},
                    {.y = {.label = "peak memory", .unit = "MB", .logarithmic = true},
                     .series = {{.name = "exponent " + format_number(memory_exponent, 3),
                                 .x = dofs,
                                 .y = megabytes,
                                 .style = chart::SeriesStyle::line_and_dots}}}};
    return chart::svg(chart);
}

/// Prints and returns the exponents of a case whose rows differ in size only.
report::Json print_scaling(const report::Json& rows, const std::string& figure, Console& console, int& status) {
    // A failed run leaves no row, so that even a case of several sizes may have one only.
    if (rows.size() < 2) return {};
    const double time = exponent(rows, "ms_per_step", "dofs"), memory = exponent(rows, "peak_memory_bytes", "dofs");
    print_format("  time per step ~ DOF^%.2f, peak memory ~ DOF^%.2f, at the largest %.1f kB per DOF\n", time, memory,
                 rows.back()["peak_memory_bytes"].get<double>() / 1e3 / rows.back()["dofs"].get<double>());
    if (!figure.empty())
        if (const Result<void> written = write_file(figure, scaling_figure(rows, time, memory)); !written)
            status = console.fail(written.error());
    return {{"time_over_dofs", time}, {"memory_over_dofs", memory}};
}

/// Runs a case and prints its rows. `status` is changed by a failure.
report::Json rows_of(const bench::BenchCase& one, Console& console, int& status) {
    report::Json rows = report::Json::array();
    for (const bench::BenchRun& run : one.runs) {
        // A process per run: peak memory is measured per run, and a crash does not end the benchmark.
        const OwnProcessResult process = run_in_own_process([&] {
            solver::use_one_blas_thread();
            Result<bench::BenchFigures> figures = Error{"did not run", run.name};
            // A task of parallel_tasks() has one thread, unless the run itself starts more: times of runs are
            // comparable.
            parallel_tasks(1, 1, [&](int) { figures = run.run(); });
            return report::json_line(figures ? figures_json(*figures)
                                             : report::Json{{"error", figures.error().text()}});
        });
        report::Json row = process.crashed ? report::Json{{"error", "the run ended before it gave a result"}}
                                           : report::Json::parse(process.output);
        if (row.contains("error")) {
            console.complain(one.id + ", " + run.name + ": " + row["error"].get<std::string>());
            status = status_failed;
            continue;
        }
        row["peak_memory_bytes"] = process.peak_bytes_over_start;
        print_figures(row);
        print_split(row);
        rows.push_back(std::move(row));
    }
    return rows;
}

/// Runs the selected cases and writes the requested files. A failed run is reported and the others continue.
int run_bench(const BenchCall& call) {
    Console console(false, false);
    // Published results must not be replaced, which is checked before minutes of computation.
    for (const auto& [option, file] : {std::pair{"--json", call.json}, std::pair{"--figure", call.figure}})
        if (const Result<void> kept = check_overwrites(option, {file}, reference_files()); !kept)
            return console.refuse(kept.error());
    report::Json cases = report::Json::array();
    bool found = call.id.empty();
    int status = status_done;
    for (const bench::BenchCase& one : bench::bench_catalogue()) {
        if (!call.id.empty() && one.id != call.id) continue;
        found = true;
        print_heading(one);
        report::Json rows = rows_of(one, console, status);
        report::Json entry{{"case", one.id}, {"summary", one.summary}};
        if (one.over_size) entry["exponents"] = print_scaling(rows, call.figure, console, status);
        entry["rows"] = std::move(rows);
        cases.push_back(std::move(entry));
    }
    if (!found) return console.refuse({unknown_word(call.id, bench::bench_ids()), "bench"});
    if (!call.json.empty())
        if (const Result<void> written = report::write_json(call.json, {{"schema", "bench/1"}, {"cases", cases}});
            !written)
            return console.fail(written.error());
    return status;
}

}  // namespace

// The shared pointer keeps the parsed call alive until the action runs, in all commands.
std::function<int()> declare_bench(CLI::App& app) {
    auto call = std::make_shared<BenchCall>();
    app.add_option("case", call->id, "One of: " + join(bench::bench_ids()) + "; all of them when left out");
    app.add_option("--json", call->json, "Also write the figures to this file");
    app.add_option("--figure", call->figure, "Also draw time and memory over size (case scaling) as SVG to this file");
    return [call] { return run_bench(*call); };
}

}  // namespace myo::app
