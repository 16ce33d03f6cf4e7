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

/// Thrown by TomlReader and caught by read_experiment, never outside: some hundred values are read one after the
/// other and the first bad one ends it all, so a Result per value would double the length of every reader.
struct TomlFailure {
    Error error;
};

/// Which numbers are allowed, and how to say so. Bounds themselves are allowed unless `open`.
struct NumberRange {
    double lowest = -std::numeric_limits<double>::max();
    double highest = std::numeric_limits<double>::max();
    bool open = false;
    std::string text = "finite";

    bool contains(double value) const {
        return open ? value > lowest && value < highest : value >= lowest && value <= highest;
    }
};

NumberRange any_number();
NumberRange any_or_infinite();
NumberRange positive();
NumberRange not_negative();
NumberRange between(double lowest, double highest);  // bounds included
NumberRange strictly_between(double lowest, double highest);

/// "the closest known one is X", or the list of all when none is near.
std::string suggest(const std::string& word, const std::vector<std::string>& known);

/// Reads one table of a document: each getter checks kind, length and range, and fails with key, line and reason.
class TomlReader {
public:
    /// @param path        the table's own key, e.g. "trial[1].load[0]"; empty for the document
    /// @param known_keys  every key the table may hold; any other one fails here, before what a mistyped key would
    ///                    leave missing. Getters assert that their key is among them.
    TomlReader(const TomlValue& table, std::string path, std::vector<std::string> known_keys);

    const std::string& path() const { return path_; }
    const std::string& where() const { return table_->where; }
    std::string path_of(const std::string& key) const;
    const std::vector<std::string>& keys() const { return table_->keys; }  // those present, in order
    bool has(const std::string& key) const;
    bool has_entry(const std::string& key) const;  // as has(), for tables whose keys are names

    double number(const std::string& key, const NumberRange& range = any_number()) const;
    double number_or(const std::string& key, double fallback, const NumberRange& range = any_number()) const;
    std::optional<double> optional_number(const std::string& key, const NumberRange& range = any_number()) const;
    bool boolean_or(const std::string& key, bool fallback) const;
    std::string text(const std::string& key) const;
    std::string text_or(const std::string& key, const std::string& fallback) const;
    std::string name(const std::string& key) const;  // text, not empty, no blanks around it, no control characters
    std::vector<std::string> texts(const std::string& key) const;

    /// One of a few words.
    template <class Value>
    Value choice(const std::string& key, const std::vector<std::pair<std::string, Value>>& choices) const;

    Eigen::VectorXd vector(const std::string& key, Eigen::Index size) const;
    Eigen::Vector3d vector3(const std::string& key) const { return vector(key, 3); }
    Eigen::Matrix3d matrix3(const std::string& key) const;
    Box box(const std::string& key) const;                  // [[lowest], [highest]]
    Eigen::Matrix3Xd points(const std::string& key) const;  // [[x, y, z], ...], 3 x n

    /// A file that must exist, resolved against the folder.
    std::filesystem::path file(const std::string& key, const std::filesystem::path& folder) const;

    TomlReader table(const std::string& key, std::vector<std::string> known_keys) const;
    TomlReader table_of_names(const std::string& key) const;  // any key is allowed
    std::vector<TomlReader> tables(const std::string& key, const std::vector<std::string>& known_keys) const;
    std::vector<TomlReader> tables_of_names(const std::string& key) const;
    TomlReader with_known_keys(std::vector<std::string> known_keys) const;  // the same table, checked
    bool is_text(const std::string& key) const;
    bool is_array(const std::string& key) const;

    /// Fails when the key is present, because it has no meaning next to another key's value.
    void reject(const std::string& key, const std::string& sentence) const;

    /// Fails with this key and its line; the table's line when the key is absent.
    [[noreturn]] void fail(const std::string& key, const std::string& sentence) const;

private:
    const TomlValue& value(const std::string& key) const;
    const TomlValue& value(const std::string& key, TomlValue::Kind kind) const;
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

/// Where every key of a document stands, by its path.
std::map<std::string, std::string> locations(const TomlValue& document);

}  // namespace myo::toml
