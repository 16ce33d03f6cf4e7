#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/result.hpp"

namespace myo::report {

/// JSON with its keys in the order in which they were written.
using Json = nlohmann::ordered_json;

/// A number; null when it is not finite. The key stays, so that a reader can tell "asked, but no value" from "not
/// asked".
Json json_number(double value);

/// [v0, v1, ...], null where a value is not finite.
Json json_array(const Eigen::Ref<const Eigen::VectorXd>& values);
Json json_array(const std::vector<double>& values);

/// One inner array per column: points of a 3 x n matrix become [[x, y, z], ...].
Json json_columns(const Eigen::Ref<const Eigen::MatrixXd>& points);

/// Text with indentation 1 and a final newline. Non-finite numbers are null wherever they stand, bytes that are not
/// UTF-8 become U+FFFD: dumping never throws.
std::string json_text(const Json& value);

/// As json_text, on one line.
std::string json_line(const Json& value);

/// Writes json_text() at once (temporary name, then renamed).
Result<void> write_json(const std::filesystem::path& path, const Json& value);

/// Reads a JSON file. Error: what read_file says, or the line where the text is broken.
Result<Json> read_json(const std::filesystem::path& path);

}  // namespace myo::report
