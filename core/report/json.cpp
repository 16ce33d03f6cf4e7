#include "report/json.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "base/files.hpp"

namespace myo::report {
namespace {

/// [v0, v1, ...] with null for values that are not finite.
Json array_of(std::span<const double> values) {
    Json array = Json::array();
    for (const double value : values) array.push_back(json_number(value));
    return array;
}

/// Invalid UTF-8 in strings becomes U+FFFD instead of an exception.
constexpr auto replace_bad_bytes = Json::error_handler_t::replace;

}  // namespace

Json json_number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json json_array(const Eigen::Ref<const Eigen::VectorXd>& values) {
    return array_of({values.data(), static_cast<std::size_t>(values.size())});
}

Json json_array(const std::vector<double>& values) { return array_of(values); }

Json json_columns(const Eigen::Ref<const Eigen::MatrixXd>& points) {
    Json array = Json::array();
    for (Eigen::Index i = 0; i < points.cols(); ++i)
        array.push_back(array_of({points.col(i).data(), static_cast<std::size_t>(points.rows())}));
    return array;
}

// The library itself writes non-finite numbers as null.
std::string json_text(const Json& value) { return value.dump(1, ' ', false, replace_bad_bytes) + "\n"; }

std::string json_line(const Json& value) { return value.dump(-1, ' ', false, replace_bad_bytes); }

Result<void> write_json(const std::filesystem::path& path, const Json& value) {
    return write_file(path, json_text(value));
}

Result<Json> read_json(const std::filesystem::path& path) {
    const Result<std::string> text = read_file(path);
    if (!text) return text.error();
    try {
        return Json::parse(*text);
    } catch (const nlohmann::json::parse_error& error) {
        // The library reports a byte position; people need the line.
        const std::size_t end = std::min(error.byte, text->size());
        const auto line = 1 + std::count(text->begin(), text->begin() + static_cast<std::ptrdiff_t>(end), '\n');
        return Error{"is not valid JSON near this line", path.string() + ":" + std::to_string(line)};
    } catch (const nlohmann::json::exception&) {
        // E.g. a number too large for a double.
        return Error{"holds JSON that cannot be read", path.string()};
    }
}

}  // namespace myo::report
