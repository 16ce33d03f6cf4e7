#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace myo::report {

/// JSON whose keys keep the order in which they were inserted.
using Json = nlohmann::ordered_json;

/// A number; null if not finite. The key remains, so that a reader can distinguish "no value" from "not requested".
Json json_number(double value);

/// [v0, v1, ...] with null for values that are not finite.
Json json_array(const Eigen::Ref<const Eigen::VectorXd>& values);
/// json_array() of a standard vector.
Json json_array(const std::vector<double>& values);

/// One inner array per column: the points of a 3 x n matrix become [[x, y, z], ...]. Values that are not finite become
/// null.
Json json_columns(const Eigen::Ref<const Eigen::MatrixXd>& points);

/// JSON text with indentation 1 and a final newline. Non-finite numbers become null and bytes that are not UTF-8 become
/// U+FFFD, so that serialisation never throws.
std::string json_text(const Json& value);

/// As json_text(), on one line.
std::string json_line(const Json& value);

/// Writes json_text() atomically (temporary file, then rename).
/// Errors: those of writing the file.
Result<void> write_json(const std::filesystem::path& path, const Json& value);

/// Reads a JSON file.
/// Errors: those of read_file(), or the line of the syntax error.
Result<Json> read_json(const std::filesystem::path& path);

}  // namespace myo::report
