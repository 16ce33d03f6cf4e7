#pragma once

#include <string>
#include <vector>

#include "report/html_report.hpp"
#include "sweep/sweep_table.hpp"

namespace myo::sweep {

/// Page of a sweep: counts, failed cases, figures, the table and the sweep file.
///
/// @param call  command line, for the footer
report::HtmlReport sweep_report(const SweepTable& table, const std::string& call);

/// Writes sweep.csv, sweep.json and sweep.html into a folder.
///
/// @param out      holds the cases; must exist
/// @param version  of the program
/// @param command  command line, word by word
/// Errors: a file cannot be written.
Result<void> write_sweep(const SweepTable& table, const std::filesystem::path& out, const std::string& version,
                         const std::vector<std::string>& command);

}  // namespace myo::sweep
