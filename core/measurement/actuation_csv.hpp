#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace myo::measurement {

/// Signals of muscles over time; piecewise linear between rows, constant outside. Two rows of one time are a jump.
struct ActuationTable {
    std::vector<std::string> muscles;
    Eigen::VectorXd time_s;             // rows, ascending; two may be equal
    Eigen::MatrixXd values;             // muscles x rows, target stretch a (1 = passive)
    std::vector<std::string> warnings;  // for a person, with file and line
    std::vector<int> lines;             // of the rows in their file; empty for a table that was not read from one
};

/// Reads `time_s,<muscle>,...`.
///
/// A last row that goes back in time but repeats the values of the row before says nothing new, for the signal is
/// constant after its last row: some exports close with such a row. It is left out, with a warning. Errors, with file
/// and line: no muscle, an empty or duplicated name, fields that are no numbers (nan included), ragged rows, times that
/// go back, three rows of one time, no rows.
Result<ActuationTable> read_actuation_csv(const std::filesystem::path& path);

/// Writes the same form; numbers read back exactly.
Result<void> write_actuation_csv(const std::filesystem::path& path, const ActuationTable& table);

}  // namespace myo::measurement
