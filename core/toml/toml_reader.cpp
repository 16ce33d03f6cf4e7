#include "toml/toml_reader.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/text.hpp"

namespace myo::toml {
namespace {

using TomlKind = TomlValue::Kind;

std::string in_quotes(const std::string& word) { return "\"" + word + "\""; }

std::string size_name(Eigen::Index size) { return std::to_string(size) + " numbers"; }

}  // namespace

NumberRange any_number() { return {}; }

NumberRange any_or_infinite() {
    const double infinity = std::numeric_limits<double>::infinity();
    return {-infinity, infinity, false, "a number, inf or -inf"};
}

NumberRange positive() { return {0.0, std::numeric_limits<double>::infinity(), true, "positive and finite"}; }

NumberRange not_negative() { return {0.0, std::numeric_limits<double>::max(), false, "finite and not negative"}; }

NumberRange between(double lowest, double highest) {
    return {lowest, highest, false, "between " + format_number(lowest) + " and " + format_number(highest)};
}

NumberRange strictly_between(double lowest, double highest) {
    return {lowest, highest, true, "above " + format_number(lowest) + " and below " + format_number(highest)};
}

std::string suggest(const std::string& word, const std::vector<std::string>& known) {
    if (known.empty()) return "none is known here";
    std::string near = closest_word(word, known);
    // Edit distance misses abbreviations: "gravity" for "gravity_m_s2". Substrings are accepted from three letters on.
    for (std::size_t i = 0; near.empty() && word.size() >= 3 && i < known.size(); ++i)
        if (known[i].find(word) != std::string::npos ||
            (known[i].size() >= 3 && word.find(known[i]) != std::string::npos))
            near = known[i];
    return near.empty() ? "known are " + join(known) : "the closest known one is " + in_quotes(near);
}

TomlReader::TomlReader(const TomlValue& table, std::string path, std::vector<std::string> known_keys)
    : table_(&table), path_(std::move(path)), known_keys_(std::move(known_keys)) {
    assert(table.kind == TomlKind::table);
    for (const std::string& key : table.keys)
        if (std::find(known_keys_.begin(), known_keys_.end(), key) == known_keys_.end())
            fail(key, "unknown key; " + suggest(key, known_keys_));
}

std::string TomlReader::path_of(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }

bool TomlReader::has(const std::string& key) const {
    assert(std::find(known_keys_.begin(), known_keys_.end(), key) != known_keys_.end());
    return table_->find(key) != nullptr;
}

bool TomlReader::has_entry(const std::string& key) const { return table_->find(key) != nullptr; }

void TomlReader::fail(const std::string& key, const std::string& sentence) const {
    const TomlValue* found = table_->find(key);
    throw TomlFailure{Error{path_of(key) + ": " + sentence, found != nullptr ? found->where : table_->where}};
}

void TomlReader::reject(const std::string& key, const std::string& sentence) const {
    if (has(key)) fail(key, sentence);
}

const TomlValue& TomlReader::value(const std::string& key) const {
    if (!has(key)) fail(key, "required key is missing");
    return *table_->find(key);
}

const TomlValue& TomlReader::value(const std::string& key, TomlKind kind) const {
    const TomlValue& found = value(key);
    if (found.kind != kind) fail(key, "must be " + kind_name(kind) + ", not " + kind_name(found.kind));
    return found;
}

bool TomlReader::is_text(const std::string& key) const { return has(key) && value(key).kind == TomlKind::text; }
bool TomlReader::is_array(const std::string& key) const { return has(key) && value(key).kind == TomlKind::array; }

double TomlReader::number(const std::string& key, const NumberRange& range) const {
    const double found = value(key, TomlKind::number).number;
    // An open range also excludes infinite bounds.
    if (!range.contains(found) || (range.open && !std::isfinite(found)))
        fail(key, "must be " + range.text + ", not " + format_number(found));
    return found;
}

double TomlReader::number_or(const std::string& key, double fallback, const NumberRange& range) const {
    return has(key) ? number(key, range) : fallback;
}

std::optional<double> TomlReader::optional_number(const std::string& key, const NumberRange& range) const {
    if (!has(key)) return std::nullopt;
    return number(key, range);
}

bool TomlReader::boolean_or(const std::string& key, bool fallback) const {
    return has(key) ? value(key, TomlKind::boolean).truth : fallback;
}

std::string TomlReader::text(const std::string& key) const { return value(key, TomlKind::text).text; }

std::string TomlReader::text_or(const std::string& key, const std::string& fallback) const {
    return has(key) ? text(key) : fallback;
}

std::string TomlReader::name(const std::string& key) const {
    const std::string found = text(key);
    const auto control = [](char c) { return static_cast<unsigned char>(c) < 32 || c == 127; };
    if (found.find_first_not_of(" \t\r\n") == std::string::npos) fail(key, "must not be empty");
    if (found.front() == ' ' || found.back() == ' ') fail(key, "must not begin or end with a blank");
    if (std::any_of(found.begin(), found.end(), control)) fail(key, "must not contain tabs or line breaks");
    return found;
}

std::vector<std::string> TomlReader::texts(const std::string& key) const {
    std::vector<std::string> found;
    for (const TomlValue& item : value(key, TomlKind::array).items) {
        if (item.kind != TomlKind::text) fail(key, "must hold strings only, not " + kind_name(item.kind));
        found.push_back(item.text);
    }
    return found;
}

std::string TomlReader::choose(const std::string& key, const std::vector<std::string>& words) const {
    const std::string found = text(key);
    if (std::find(words.begin(), words.end(), found) == words.end())
        fail(key, "unknown value " + in_quotes(found) + "; " + suggest(found, words));
    return found;
}

Eigen::VectorXd TomlReader::vector(const std::string& key, const TomlValue& array, Eigen::Index size) const {
    if (array.kind != TomlKind::array)
        fail(key, "must be an array of " + size_name(size) + ", not " + kind_name(array.kind));
    if (static_cast<Eigen::Index>(array.items.size()) != size)
        fail(key, "must have " + size_name(size) + ", not " + std::to_string(array.items.size()));
    Eigen::VectorXd found(size);
    for (Eigen::Index i = 0; i < size; ++i) {
        const TomlValue& item = array.items[static_cast<std::size_t>(i)];
        if (item.kind != TomlKind::number) fail(key, "must hold numbers only, not " + kind_name(item.kind));
        if (!std::isfinite(item.number)) fail(key, "must hold finite numbers only, not " + format_number(item.number));
        found[i] = item.number;
    }
    return found;
}

Eigen::VectorXd TomlReader::vector(const std::string& key, Eigen::Index size) const {
    return vector(key, value(key), size);
}

Eigen::Matrix3d TomlReader::matrix3(const std::string& key) const {
    const TomlValue& rows = value(key, TomlKind::array);
    if (rows.items.size() != 3)
        fail(key, "must have 3 rows of 3 numbers, not " + std::to_string(rows.items.size()) + " rows");
    Eigen::Matrix3d matrix;
    for (Eigen::Index i = 0; i < 3; ++i)
        matrix.row(i) = vector(key, rows.items[static_cast<std::size_t>(i)], 3).transpose();
    return matrix;
}

Box TomlReader::box(const std::string& key) const {
    const TomlValue& corners = value(key, TomlKind::array);
    if (corners.items.size() != 2)
        fail(key,
             "must be two corners [[x, y, z], [x, y, z]], not " + std::to_string(corners.items.size()) + " elements");
    Box box{vector(key, corners.items[0], 3), vector(key, corners.items[1], 3)};
    for (Eigen::Index axis = 0; axis < 3; ++axis)
        if (box.lowest[axis] > box.highest[axis])
            fail(key, std::string("lowest corner is above the highest (") + "xyz"[axis] + " " +
                          format_number(box.lowest[axis]) + " > " + format_number(box.highest[axis]) + ")");
    return box;
}

Eigen::Matrix2Xd TomlReader::pairs(const std::string& key) const {
    const TomlValue& array = value(key, TomlKind::array);
    Eigen::Matrix2Xd rows(2, static_cast<Eigen::Index>(array.items.size()));
    for (std::size_t i = 0; i < array.items.size(); ++i)
        rows.col(static_cast<Eigen::Index>(i)) = vector(key, array.items[i], 2);
    return rows;
}

Eigen::Matrix3Xd TomlReader::points(const std::string& key) const {
    const TomlValue& array = value(key, TomlKind::array);
    Eigen::Matrix3Xd found(3, static_cast<Eigen::Index>(array.items.size()));
    for (std::size_t i = 0; i < array.items.size(); ++i)
        found.col(static_cast<Eigen::Index>(i)) = vector(key, array.items[i], 3);
    return found;
}

std::filesystem::path TomlReader::file(const std::string& key, const std::filesystem::path& folder) const {
    const std::string found = text(key);
    if (found.empty() || found.find('\0') != std::string::npos) fail(key, "must be a file name");
    // Absolute file names replace the folder in operator/.
    const std::filesystem::path path = (folder / found).lexically_normal();
    std::error_code code;
    if (!std::filesystem::exists(path, code)) fail(key, "file not found: " + path.string());
    if (!std::filesystem::is_regular_file(path, code)) fail(key, "is not a file: " + path.string());
    return path;
}

TomlReader TomlReader::table(const std::string& key, std::vector<std::string> known_keys) const {
    return {value(key, TomlKind::table), path_of(key), std::move(known_keys)};
}

TomlReader TomlReader::table_of_names(const std::string& key) const {
    const TomlValue& found = value(key, TomlKind::table);
    return {found, path_of(key), found.keys};
}

std::vector<TomlReader> TomlReader::tables_of_names(const std::string& key) const {
    std::vector<TomlReader> readers;
    if (!has(key)) return readers;
    const TomlValue& found = value(key);
    const std::string advice = "; write [[" + path_of(key) + "]]";
    if (found.kind != TomlKind::array) fail(key, "must be an array of tables, not " + kind_name(found.kind) + advice);
    for (const TomlValue& item : found.items) {
        if (item.kind != TomlKind::table) fail(key, "must hold tables only, not " + kind_name(item.kind) + advice);
        readers.emplace_back(item, path_of(key) + "[" + std::to_string(readers.size()) + "]", item.keys);
    }
    return readers;
}

std::vector<TomlReader> TomlReader::tables(const std::string& key, const std::vector<std::string>& known_keys) const {
    std::vector<TomlReader> readers = tables_of_names(key);
    // Keys are checked after the type of all elements, so that a wrong type is reported first.
    for (TomlReader& reader : readers) reader = reader.with_known_keys(known_keys);
    return readers;
}

TomlReader TomlReader::with_known_keys(std::vector<std::string> known_keys) const {
    return {*table_, path_, std::move(known_keys)};
}

namespace {

/// Depth-first collection of locations.
void collect(const TomlValue& value, const std::string& path, std::map<std::string, std::string>& found) {
    if (!path.empty()) found.emplace(path, value.where);
    for (std::size_t i = 0; i < value.items.size(); ++i) {
        const std::string part = value.kind == TomlKind::table ? (path.empty() ? "" : ".") + value.keys[i]
                                                               : "[" + std::to_string(i) + "]";
        collect(value.items[i], path + part, found);
    }
}

}  // namespace

std::map<std::string, std::string> locations(const TomlValue& document) {
    std::map<std::string, std::string> found;
    collect(document, "", found);
    return found;
}

}  // namespace myo::toml
