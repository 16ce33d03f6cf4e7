#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace myo::measurement {

/// Actuation signals of muscles over time.
///
/// Piecewise linear between rows, constant before the first and after the last. Two rows with equal time are a jump.
struct ActuationTable {
    std::vector<std::string> muscles;   // names, in column order
    Eigen::VectorXd time_s;             // one per row, ascending; two may be equal
    Eigen::MatrixXd values;             // muscles x rows, target stretch a (1 = passive)
    std::vector<std::string> warnings;  // for the user, with file and line
    std::vector<int> lines;             // line of each row in its file; empty if not read from a file
};

/// Reads a file with the header `time_s,<muscle>,...`.
///
/// Some exports end with a row that goes back in time and repeats the values before it. Since the signal is constant
/// after its last row, this row carries no information; it is omitted with a warning.
/// Errors (file and line): no muscle; an empty or duplicate name; a field that is not a number (nan included); rows of
/// unequal length; descending times; three rows with equal time; no rows.
Result<ActuationTable> read_actuation_csv(const std::filesystem::path& path);

/// Writes the format of read_actuation_csv(). Numbers read back exactly.
Result<void> write_actuation_csv(const std::filesystem::path& path, const ActuationTable& table);

}  // namespace myo::measurement
