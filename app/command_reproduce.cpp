#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "base/folder_lock.hpp"
#include "base/overwrites.hpp"
#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "base/text.hpp"
#include "bench/published_beam.hpp"
#include "commands.hpp"
#include "console.hpp"
#include "exit_status.hpp"
#include "options.hpp"
#include "reference_files.hpp"
#include "reproduce/reproduction.hpp"
#include "standard_output.hpp"

namespace myo::app {
namespace {

/// Parsed call of `myoloop reproduce`.
struct ReproduceCall {
    // Id of the case; empty: the cases are listed.
    std::string id;
    std::filesystem::path out;
    // Small meshes and few steps, to try a case.
    bool coarse = false;
    WorkOptions work;
};

/// Text of a cell; a dash for values that do not exist, as in the HTML report.
std::string cell_text(const report::Cell& cell, const report::Column& column) {
    if (const auto* text = std::get_if<std::string>(&cell.content)) return *text;
    const double value = std::get<double>(cell.content);
    return std::isfinite(value) ? format_number(value, column.digits) : "-";
}

/// Number of characters of UTF-8 text: continuation bytes do not count.
std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u; }));
}

/// Aligned columns with titles and units above.
std::string table_text(const report::Table& table) {
    // The first two rows are titles and units.
    std::vector<std::vector<std::string>> rows(2);
    for (const report::Column& column : table.columns) {
        rows[0].push_back(column.title);
        rows[1].push_back(column.unit);
    }
    for (const std::vector<report::Cell>& cells : table.rows) {
        rows.emplace_back();
        for (std::size_t i = 0; i < cells.size(); ++i) rows.back().push_back(cell_text(cells[i], table.columns[i]));
    }
    std::string text = table.caption;
    for (const std::vector<std::string>& row : rows) {
        text += "\n ";
        for (std::size_t i = 0; i < row.size(); ++i) {
            std::size_t width = 0;
            for (const std::vector<std::string>& other : rows)
                if (i < other.size()) width = std::max(width, width_of(other[i]));
            const std::string blanks(width - width_of(row[i]), ' ');
            // Names to the left, numbers to the right.
            text += " " + (i == 0 ? row[i] + blanks : blanks + row[i]) + " ";
        }
    }
    return text;
}

/// Prints id and summary of every case.
int list_cases() {
    for (const reproduce::ReproductionCase& one : reproduce::reproduction_catalogue())
        print_format("%-18s %s\n", one.id.c_str(), one.summary.c_str());
    return status_done;
}

/// The folder of the outputs, made if missing, for this process alone.
Result<FolderLock> claim_folder(const ReproduceCall& call, const reproduce::ReproductionCase& one) {
    if (call.out.empty()) return Error{"--out DIR is needed: the folder for tables, figures and report", "reproduce"};
    const std::vector<std::filesystem::path> outputs = reproduce::reproduction_files(call.out, one);
    if (const Result<void> kept = check_overwrites("--out", outputs, reference_files()); !kept) return kept.error();
    std::error_code code;
    std::filesystem::create_directories(call.out, code);
    if (code) return Error{"folder cannot be made: " + code.message(), call.out.string()};
    Result<FolderLock> lock = FolderLock::take(call.out);
    if (!lock) return Error{lock.error().text(), "--out"};
    return lock;
}

/// Settings of the case from the call; all hardware threads unless --threads limits them.
reproduce::ReproduceSettings reproduce_settings(const ReproduceCall& call) {
    reproduce::ReproduceSettings settings;
    settings.data = bench::data_folder();
    settings.threads = call.work.threads > 0 ? call.work.threads : hardware_threads();
    settings.coarse = call.coarse;
    if (call.work.seed) settings.seed = *call.work.seed;
    return settings;
}

/// Adds duration and meshes of the call to the result.
void add_call(reproduce::Reproduction& result, const ReproduceCall& call, double seconds) {
    result.values["seconds"] = seconds;
    result.values["coarse"] = call.coarse;
    // Sentences about the paper's meshes do not hold for coarse ones.
    if (call.coarse)
        result.warnings.push_back(
            "--coarse: these are not the paper's meshes; what is said about them holds for the full run only");
}

/// Prints warnings, tables and findings.
void print_reproduction(const reproduce::Reproduction& result, Console& console) {
    for (const std::string& warning : result.warnings) console.warn(warning);
    for (const report::Table& table : result.tables) console.print(table_text(table) + "\n");
    for (const std::string& finding : result.findings) console.print("- " + finding);
}

/// Runs one case and writes its results; without a case, lists all.
int reproduce_command(const ReproduceCall& call) {
    if (call.id.empty()) return list_cases();
    Console console(call.work.quiet, call.work.json_progress);
    const reproduce::ReproductionCase* const one = reproduce::find_reproduction(call.id);
    if (one == nullptr) return console.refuse({unknown_word(call.id, reproduce::reproduction_ids()), "reproduce"});
    // Held until the results are written.
    const Result<FolderLock> lock = claim_folder(call, *one);
    if (!lock) return console.refuse(lock.error());
    const reproduce::ReproduceSettings settings = reproduce_settings(call);
    const Progress progress = console.progress();
    const Stopwatch watch;
    Result<reproduce::Reproduction> result = one->run(settings, progress);
    if (progress.cancelled()) {
        console.complain("stopped; nothing was written");
        return status_stopped;
    }
    if (!result) {
        console.complain(result.error().text());
        return status_failed;
    }
    const double seconds = watch.seconds();
    add_call(*result, call, seconds);
    print_reproduction(*result, console);
    if (const Result<void> written = reproduce::write_reproduction(call.out, *one, *result); !written)
        return console.fail(written.error());
    console.print("\n" + format_number(seconds, 3) + " s; report: " + (call.out / "report.html").string());
    return status_done;
}

}  // namespace

std::function<int()> declare_reproduce(CLI::App& app) {
    const auto call = std::make_shared<ReproduceCall>();
    app.add_option("case", call->id, "One of: " + join(reproduce::reproduction_ids()) + "; lists them when left out");
    app.add_option("--out", call->out, "Folder for <case>.json, the figures and report.html")->type_name("DIR");
    app.add_flag("--coarse", call->coarse,
                 "Few cells and steps: seconds instead of minutes, numbers good to some percent");
    add_work_options(app, call->work);
    return [call] { return reproduce_command(*call); };
}

}  // namespace myo::app
