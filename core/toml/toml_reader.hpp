#pragma once

#include <Eigen/Core>

#include <filesystem>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/box.hpp"
#include "base/result.hpp"
#include "toml/toml_value.hpp"

namespace myo::toml {

/// Error of a TomlReader getter. Thrown by TomlReader and always caught by read_experiment.
///
/// Reading stops at the first bad value of several hundred. An exception is used here because a Result per value would
/// double the length of every reader.
struct TomlFailure {
    Error error;  // for the user
};

/// Allowed numbers and their description in messages. The bounds are allowed unless `open`.
struct NumberRange {
    double lowest = -std::numeric_limits<double>::max();  // lower bound
    double highest = std::numeric_limits<double>::max();  // upper bound
    bool open = false;                                    // bounds excluded
    std::string text = "finite";                          // completes "must be ..."

    /// True if the number is in the range. False for NaN.
    bool contains(double value) const {
        return open ? value > lowest && value < highest : value >= lowest && value <= highest;
    }
};

/// All finite numbers.
NumberRange any_number();
/// All numbers and +-inf.
NumberRange any_or_infinite();
/// Finite numbers > 0.
NumberRange positive();
/// Finite numbers >= 0.
NumberRange not_negative();
/// Numbers from lowest to highest, bounds included.
NumberRange between(double lowest, double highest);
/// Numbers between lowest and highest, bounds excluded.
NumberRange strictly_between(double lowest, double highest);

/// Hint for an unknown word: "the closest known one is X", or the list of all known words if none is close.
std::string suggest(const std::string& word, const std::vector<std::string>& known);

/// Typed access to one table of a document. Each getter checks type, length and range.
/// Errors: all getters throw TomlFailure with key, line and reason.
class TomlReader {
public:
    /// @param table       must outlive the reader
    /// @param path        key of the table itself, for example "trial[1].load[0]"; empty for the document
    /// @param known_keys  all keys the table may hold. An unknown key fails here, before a mistyped key is reported as
    ///                    missing. Getters assert that their key is among them
    TomlReader(const TomlValue& table, std::string path, std::vector<std::string> known_keys);

    /// Key of the table, for messages.
    const std::string& path() const { return path_; }
    /// File and line of the table.
    const std::string& where() const { return table_->where; }
    /// Full key of an entry, for example "trial[1].start_s".
    std::string path_of(const std::string& key) const;
    /// Keys present, in file order.
    const std::vector<std::string>& keys() const { return table_->keys; }
    /// True if the key is present. Asserts that it is known.
    bool has(const std::string& key) const;
    /// As has(), for tables whose keys are names and thus not known in advance.
    bool has_entry(const std::string& key) const;

    /// Required number within the range.
    double number(const std::string& key, const NumberRange& range = any_number()) const;
    /// Number within the range, or `fallback` if the key is absent.
    double number_or(const std::string& key, double fallback, const NumberRange& range = any_number()) const;
    /// Number within the range; empty if the key is absent.
    std::optional<double> optional_number(const std::string& key, const NumberRange& range = any_number()) const;
    /// Boolean, or `fallback` if the key is absent.
    bool boolean_or(const std::string& key, bool fallback) const;
    /// Required string; may be empty.
    std::string text(const std::string& key) const;
    /// String, or `fallback` if the key is absent.
    std::string text_or(const std::string& key, const std::string& fallback) const;
    /// Required string that can serve as a name: not empty, no blanks at either end, no control characters.
    std::string name(const std::string& key) const;
    /// Required array of strings.
    std::vector<std::string> texts(const std::string& key) const;

    /// Required string that must be one of the given words; returns the value paired with it.
    template <class Value>
    Value choice(const std::string& key, const std::vector<std::pair<std::string, Value>>& choices) const;

    /// Required array of `size` finite numbers.
    Eigen::VectorXd vector(const std::string& key, Eigen::Index size) const;
    Eigen::Vector3d vector3(const std::string& key) const { return vector(key, 3); }
    /// Required 3 x 3 matrix as an array of rows.
    Eigen::Matrix3d matrix3(const std::string& key) const;
    /// Required box [[lowest], [highest]].
    Box box(const std::string& key) const;
    /// Required array [[x, y, z], ...], returned as 3 x n.
    Eigen::Matrix3Xd points(const std::string& key) const;
    /// Rows of two finite numbers, 2 x n.
    Eigen::Matrix2Xd pairs(const std::string& key) const;

    /// Required name of an existing regular file, resolved relative to `folder`.
    std::filesystem::path file(const std::string& key, const std::filesystem::path& folder) const;

    /// Reader of a required sub-table.
    TomlReader table(const std::string& key, std::vector<std::string> known_keys) const;
    /// Reader of a required sub-table whose keys are arbitrary names.
    TomlReader table_of_names(const std::string& key) const;
    /// Readers of an array of tables with fixed keys; empty if absent.
    std::vector<TomlReader> tables(const std::string& key, const std::vector<std::string>& known_keys) const;
    /// Readers of an array of tables whose keys are not yet checked; empty if absent.
    std::vector<TomlReader> tables_of_names(const std::string& key) const;
    /// Reader of the same table with checked keys.
    TomlReader with_known_keys(std::vector<std::string> known_keys) const;
    /// True if the key is present and a string.
    bool is_text(const std::string& key) const;
    /// True if the key is present and an array.
    bool is_array(const std::string& key) const;

    /// Fails if the key is present, because another key makes it meaningless.
    void reject(const std::string& key, const std::string& sentence) const;

    /// Fails with the location of this key, or of the table if the key is absent.
    [[noreturn]] void fail(const std::string& key, const std::string& sentence) const;

private:
    /// Value of a required key.
    const TomlValue& value(const std::string& key) const;
    const TomlValue& value(const std::string& key, TomlValue::Kind kind) const;
    /// Required string that is one of the words; fails with a suggestion.
    std::string choose(const std::string& key, const std::vector<std::string>& words) const;
    Eigen::VectorXd vector(const std::string& key, const TomlValue& array, Eigen::Index size) const;

    const TomlValue* table_;
    std::string path_;
    std::vector<std::string> known_keys_;
};

template <class Value>
Value TomlReader::choice(const std::string& key, const std::vector<std::pair<std::string, Value>>& choices) const {
    std::vector<std::string> words;
    for (const auto& [word, meaning] : choices) words.push_back(word);
    const std::string chosen = choose(key, words);
    for (const auto& [word, meaning] : choices)
        if (word == chosen) return meaning;
    fail(key, "has no meaning");  // not reached: choose() returns one of the words
}

/// Location (file and line) of every key of a document, by full key.
std::map<std::string, std::string> locations(const TomlValue& document);

}  // namespace myo::toml
