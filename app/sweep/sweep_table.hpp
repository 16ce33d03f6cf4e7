#pragma once

#include <string>
#include <vector>

#include "report/json.hpp"
#include "sweep/case_folder.hpp"
#include "sweep/case_numbers.hpp"

namespace myo::sweep {

/// A case and what came out of it.
struct SweepRow {
    int number = 1;
    std::vector<std::size_t> choice;  // see SweepCase
    CaseState state = CaseState::not_run;
    std::string message;   // of a failure
    double seconds = 0.0;  // wall-clock time of the command
    CaseNumbers result;    // empty if there is no report
    /// The number of a name, or null.
    const CaseNumber* find(const std::string& name) const;
};

/// A column of numbers.
struct SweepColumn {
    std::string name;
    std::string unit;            // see CaseNumber
    bool has_deviation = false;  // in some row
    // On the page; otherwise in the files only.
    bool shown = true;
};

/// All cases of a sweep, by number.
struct SweepTable {
    Sweep sweep;
    std::string experiment_name;
    std::vector<SweepRow> rows;
    std::vector<SweepColumn> columns;  // the numbers of all rows, in the order in which they first occur

    int count(CaseState state) const;
    /// Cases that have not ended: not run, at work or stopped.
    int missing() const;
};

/// A case with the report in its folder. A report that cannot be read makes it a failed row.
SweepRow sweep_row(const PreparedSweep& sweep, const SweepCase& sweep_case, const CaseMarker& marker,
                   const std::filesystem::path& out);

/// Reads the markers and reports of all cases, also while other processes run some of them.
SweepTable sweep_table(const PreparedSweep& sweep, const std::filesystem::path& out);

/// The table as CSV (RFC 4180): case, varied values, state, verdict, numbers in SI with deviation, seconds, message.
/// Numbers that a case does not have are empty fields.
std::string csv_text(const SweepTable& table);

/// The table as JSON (schema sweep_result/1), with everything in SI units.
report::Json sweep_json(const SweepTable& table, const std::string& version, const std::vector<std::string>& command);

/// One line of a case for the terminal: "   3  material.youngs_modulus_Pa = 320000  done  rms of drop 1.23 mm   4.1 s".
std::string row_line(const Sweep& sweep, const SweepRow& row);

}  // namespace myo::sweep
