#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "report/html_report.hpp"

namespace myo::reproduce {

/// How an experiment of the paper is repeated.
struct ReproduceSettings {
    std::filesystem::path data;  // folder with data/mocap; see data_folder()
    std::uint64_t seed = 1;      // of random starts
    int threads = 1;
    bool coarse = false;  // few cells and few steps: seconds instead of minutes, numbers good to some percent
};

/// A figure with the ending of its file: "" is <case>.svg, "trace" is <case>_trace.svg.
struct ReproductionFigure {
    std::string ending;
    report::Figure figure;
};

/// What came out: our numbers beside the paper's.
struct Reproduction {
    std::string title;
    std::vector<std::string> findings;  // sentences: what agrees, what does not and why
    std::vector<std::string> warnings;  // what is missing, and where to get it
    std::vector<report::Table> tables;
    std::vector<ReproductionFigure> figures;
    report::Json values;  // an object
};

/// An experiment of the paper: a file in this folder and a line in catalogue.cpp. It must run without the measured data
/// too and then says in a warning what to fetch. Errors: a run that failed, damaged data; "stopped" when the progress
/// was cancelled.
struct ReproductionCase {
    std::string id;
    std::string summary;
    Result<Reproduction> (*run)(const ReproduceSettings& settings, const Progress& progress);
};
const std::vector<ReproductionCase>& reproduction_catalogue();
std::vector<std::string> reproduction_ids();

/// Null when there is no case of this name.
const ReproductionCase* find_reproduction(const std::string& id);

/// The page about a reproduction.
report::HtmlReport reproduction_report(const ReproductionCase& one, const Reproduction& result);

/// The files in this folder that write_reproduction() may replace.
std::vector<std::filesystem::path> reproduction_files(const std::filesystem::path& folder, const ReproductionCase& one);

/// Writes <case>.json, the figures and report.html. Error: a file cannot be written.
Result<void> write_reproduction(const std::filesystem::path& folder, const ReproductionCase& one,
                                const Reproduction& result);

/// The cells of a table as JSON rows, keyed by its columns' titles and units.
report::Json table_json(const report::Table& table);

/// What a user reads when the files of a folder below data/mocap are not there.
std::string missing_data(const ReproduceSettings& settings, const std::string& folder);

}  // namespace myo::reproduce
