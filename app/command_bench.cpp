#include <cstdio>
#include <filesystem>
#include <memory>

#include "base/text.hpp"
#include "bench/bench_case.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "exit_status.hpp"
#include "options.hpp"
#include "own_process.hpp"
#include "report/json.hpp"
#include "solver/sparse_cholesky.hpp"

namespace myo {
namespace {

struct BenchCall {
    std::string id;
    std::string json;
};

Json figures_json(const BenchFigures& f) {
    Json references = Json::array();
    for (const BenchReference& r : f.references)
        references.push_back({{"label", r.label}, {"ms_per_step", r.ms_per_step}, {"ratio", json_number(r.ms_per_step / f.ms_per_step())}});
    Json quantities = Json::array();
    for (const BenchQuantity& q : f.quantities)
        quantities.push_back({{"name", q.name},
                              {"value", json_number(q.value)},
                              {"unit", q.unit},
                              {"expected", q.expected ? json_number(*q.expected) : Json()},
                              {"error", q.error() ? json_number(*q.error()) : Json()}});
    return {{"name", f.name},
            {"dofs", f.dofs},
            {"cells", f.cells},
            {"steps", f.steps},
            {"dt_s", f.h_s},
            {"setup_s", json_number(f.setup_s)},
            {"run_s", json_number(f.run_s)},
            {"ms_per_step", json_number(f.ms_per_step())},
            {"us_per_dof_and_step", json_number(f.us_per_dof_and_step())},
            {"iterations_per_step", json_number(f.iterations_per_step)},
            {"factorisations_per_step", json_number(f.factorisations_per_step)},
            {"real_time_factor", json_number(f.real_time_factor())},
            {"limit_ms_per_step", f.limit_ms > 0.0 ? Json(f.limit_ms) : Json()},
            {"goal_ms_per_step", f.goal_ms ? Json(*f.goal_ms) : Json()},
            {"references", references},
            {"quantities", quantities},
            {"note", f.note}};
}

void print_heading(const BenchCase& one) {
    std::printf("\n%s: %s\n", one.id.c_str(), one.summary.c_str());
    std::printf("  %9s %7s %9s %7s %7s %9s %8s %7s  %s\n", "ms/step", "goal", "us/DOF", "iter.", "factor", "real time", "memory", "limit", "case");
    std::printf("  %9s %7s %9s %7s %7s %9s %8s %7s\n", "", "ms", "and step", "a step", "a step", "factor", "MB", "ms");
}

/// A physical result below its row: "tip at rest, dz  -6.74 mm (expected -6.755: -0.2 %)".
void print_quantity(const Json& quantity) {
    const auto number = [&](const char* key, int digits) { return quantity[key].is_null() ? std::string("-") : format_number(quantity[key].get<double>(), digits); };
    std::string text = number("value", 5) + " " + quantity["unit"].get<std::string>();
    if (!quantity["error"].is_null())
        text += " (expected " + number("expected", 5) + ": " + format_number(100.0 * quantity["error"].get<double>(), 2) + " %)";
    std::printf("  %*s  %s: %s\n", 71, "", quantity["name"].get<std::string>().c_str(), text.c_str());
}

void print_row(const Json& row) {
    const auto optional = [&](const char* key) { return row[key].is_null() ? std::string("-") : format_number(row[key].get<double>(), 3); };
    if (row["steps"].get<int>() == 0) {
        std::printf("  %9s %7s %9s %7s %7s %9s %8.1f %7s  %s, %.2f s\n", "-", "-", "-", "-", "-", "-", row["peak_memory_bytes"].get<double>() / 1e6, "-",
                    row["name"].get<std::string>().c_str(), row["run_s"].get<double>());
    } else {
        std::printf("  %9.3f %7s %9.3f %7.2f %7.3f %9.2f %8.1f %7s  %s\n", row["ms_per_step"].get<double>(), optional("goal_ms_per_step").c_str(),
                    row["us_per_dof_and_step"].get<double>(), row["iterations_per_step"].get<double>(), row["factorisations_per_step"].get<double>(),
                    row["real_time_factor"].get<double>(), row["peak_memory_bytes"].get<double>() / 1e6, optional("limit_ms_per_step").c_str(),
                    row["name"].get<std::string>().c_str());
    }
    for (const Json& quantity : row["quantities"]) print_quantity(quantity);
    for (const Json& reference : row["references"])
        std::printf("  %9.0f %s%*s  %s: %.0f times as long\n", reference["ms_per_step"].get<double>(), "", 61, "", reference["label"].get<std::string>().c_str(),
                    reference["ratio"].get<double>());
    if (const std::string note = row["note"].get<std::string>(); !note.empty()) std::printf("  %*s  %s\n", 71, "", note.c_str());
    std::fflush(stdout);
}

int run_bench(const BenchCall& call) {
    Console console(false, false);
    Json cases = Json::array();
    bool found = call.id.empty();
    int status = status_done;
    for (const BenchCase& one : bench_catalogue()) {
        if (!call.id.empty() && one.id != call.id) continue;
        found = true;
        print_heading(one);
        Json rows = Json::array();
        for (const BenchRun& run : one.runs) {
            const OwnProcessResult process = run_in_own_process([&] {
                use_one_blas_thread();
                const Result<BenchFigures> figures = run.run();
                return json_line(figures ? figures_json(*figures) : Json{{"error", figures.error().text()}});
            });
            Json row = process.crashed ? Json{{"error", "the run ended before it gave a result"}} : Json::parse(process.output);
            if (row.contains("error")) {
                console.complain(one.id + ", " + run.name + ": " + row["error"].get<std::string>());
                status = status_failed;
                continue;
            }
            row["peak_memory_bytes"] = process.peak_bytes_over_start;
            print_row(row);
            rows.push_back(std::move(row));
        }
        cases.push_back({{"case", one.id}, {"summary", one.summary}, {"rows", rows}});
    }
    if (!found) return console.refuse({unknown_word(call.id, bench_ids()), "bench"});
    if (!call.json.empty())
        if (const Result<void> written = write_json(call.json, {{"schema", "bench/1"}, {"cases", cases}}); !written) return console.refuse(written.error());
    return status;
}

}  // namespace

std::function<int()> declare_bench(CLI::App& app) {
    auto call = std::make_shared<BenchCall>();
    app.add_option("case", call->id, "One of: " + join(bench_ids()) + "; all of them when left out");
    app.add_option("--json", call->json, "Also write the figures to this file");
    return [call] { return run_bench(*call); };
}

}  // namespace myo
