#pragma once

#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "base/result.hpp"
#include "sweep/sweep_file.hpp"

namespace myo::sweep {

/// A number of a report, in SI units.
struct CaseNumber {
    std::string name;  // "youngs_modulus_Pa", "rms of drop"
    std::string unit;  // "Pa"; empty: a plain number
    double value = std::numeric_limits<double>::quiet_NaN();
    double deviation = std::numeric_limits<double>::quiet_NaN();  // standard deviation; NaN: it has none
    bool shown = true;                                            // on the page; otherwise in the files only
};

/// What the report of a case says.
struct CaseNumbers {
    // One word or phrase for the table.
    std::string verdict;  // "converged", "quadratic_drag", "reached"; empty for simulate
    std::vector<CaseNumber> numbers;
};

/// File of the report of a command in its output folder: "<command>.json", "report.json" of a diagnosis.
std::filesystem::path report_of(CaseCommand command, const std::filesystem::path& folder);

/// Reads the numbers of a report: rms of the fit, of the validation trials and of each trial; fitted values with
/// standard deviations; confidence and parameters of a diagnosis; signals that are held and moduli that were sought;
/// where the markers come to rest.
///
/// What a report does not hold, or holds as null, is left out.
/// Errors: the report is missing or has another form.
Result<CaseNumbers> read_case_numbers(CaseCommand command, const std::filesystem::path& folder);

}  // namespace myo::sweep
