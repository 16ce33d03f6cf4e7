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
    return {{"name", f.name},
            {"dofs", f.dofs},
            {"cells", f.cells},
            {"steps", f.steps},
            {"dt_s", f.h_s},
            {"setup_s", json_number(f.setup_s)},
            {"ms_per_step", json_number(f.ms_per_step())},
            {"us_per_dof_and_step", json_number(f.us_per_dof_and_step())},
            {"iterations_per_step", json_number(f.iterations_per_step)},
            {"factorisations_per_step", json_number(f.factorisations_per_step)},
            {"real_time_factor", json_number(f.real_time_factor())},
            {"limit_ms_per_step", f.limit_ms > 0.0 ? Json(f.limit_ms) : Json()},
            {"goal_ms_per_step", f.goal_ms ? Json(*f.goal_ms) : Json()},
            {"references", references},
            {"note", f.note}};
}

void print_heading(const BenchCase& one) {
    std::printf("\n%s: %s\n", one.id.c_str(), one.summary.c_str());
    std::printf("  %9s %7s %9s %7s %7s %9s %8s %7s  %s\n", "ms/step", "goal", "us/DOF", "iter.", "factor", "real time", "memory", "limit", "case");
    std::printf("  %9s %7s %9s %7s %7s %9s %8s %7s\n", "", "ms", "and step", "a step", "a step", "factor", "MB", "ms");
}

void print_row(const Json& row) {
    const auto optional = [&](const char* key) { return row[key].is_null() ? std::string("-") : format_number(row[key].get<double>(), 3); };
    std::printf("  %9.3f %7s %9.3f %7.2f %7.3f %9.2f %8.1f %7s  %s\n", row["ms_per_step"].get<double>(), optional("goal_ms_per_step").c_str(),
                row["us_per_dof_and_step"].get<double>(), row["iterations_per_step"].get<double>(), row["factorisations_per_step"].get<double>(),
                row["real_time_factor"].get<double>(), row["peak_memory_bytes"].get<double>() / 1e6, optional("limit_ms_per_step").c_str(),
                row["name"].get<std::string>().c_str());
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
