#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "report/html_report.hpp"

namespace myo::reproduce {

/// How a case of the paper is reproduced.
struct ReproduceSettings {
    std::filesystem::path data;  // folder with data/mocap; see data_folder()
    std::uint64_t seed = 1;      // of random starts
    // Cases run their fits and simulations in parallel on these.
    int threads = 1;
    bool coarse = false;  // few cells and steps: seconds instead of minutes, numbers good to some percent
};

/// A figure with the suffix of its file: "" is <case>.svg, "trace" is <case>_trace.svg.
struct ReproductionFigure {
    std::string ending;
    report::Figure figure;
};

/// Result of a case: our numbers and the paper's.
struct Reproduction {
    std::string title;
    std::vector<std::string> findings;  // sentences: what agrees, what does not and why
    std::vector<std::string> warnings;  // what is missing, and where to get it
    std::vector<report::Table> tables;
    std::vector<ReproductionFigure> figures;
    // Numbers for scripts, which the file holds at its top level.
    report::Json values;  // a JSON object
};

/// A case of the paper: a file in this folder and a line in catalogue.cpp. It must also run without the measured data
/// and then say in a warning what to fetch.
struct ReproductionCase {
    std::string id;
    std::string summary;
    /// Errors: a run that failed, damaged data; "stopped" if the progress was cancelled.
    Result<Reproduction> (*run)(const ReproduceSettings& settings, const Progress& progress);
};
/// All cases.
const std::vector<ReproductionCase>& reproduction_catalogue();
/// Ids of all cases, in the order of the catalogue.
std::vector<std::string> reproduction_ids();

/// The case with this id, or null.
const ReproductionCase* find_reproduction(const std::string& id);

/// HTML report of a case: warnings, findings, figures, tables, and the values as embedded JSON.
report::HtmlReport reproduction_report(const ReproductionCase& one, const Reproduction& result);

/// Files in this folder that write_reproduction() may replace; the folder need not exist.
std::vector<std::filesystem::path> reproduction_files(const std::filesystem::path& folder, const ReproductionCase& one);

/// Writes <case>.json (schema reproduce/1), the figures and report.html. Errors: a file cannot be written.
Result<void> write_reproduction(const std::filesystem::path& folder, const ReproductionCase& one,
                                const Reproduction& result);

/// Cells of a table as JSON rows, keyed by column title and unit.
report::Json table_json(const report::Table& table);

/// Message for the user if the files of a folder below data/mocap are missing.
std::string missing_data(const ReproduceSettings& settings, const std::string& folder);

}  // namespace myo::reproduce
