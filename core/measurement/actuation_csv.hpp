#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace myo {

/// Signals of muscles over time; piecewise linear between rows, constant outside.
struct ActuationTable {
    std::vector<std::string> muscles;
    Eigen::VectorXd time_s;      // rows, ascending
    Eigen::MatrixXd values;      // muscles x rows, target stretch a (1 = passive)
};

/// Reads `time_s,<muscle>,...`.
///
/// Errors, with file and line: no muscle, an empty or duplicated name, fields that are no numbers (nan included), ragged
/// rows, times that do not ascend, no rows.
Result<ActuationTable> read_actuation_csv(const std::filesystem::path& path);

/// Writes the same form; numbers read back exactly.
Result<void> write_actuation_csv(const std::filesystem::path& path, const ActuationTable& table);

}  // namespace myo
