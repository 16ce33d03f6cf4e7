#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>
#include <string>

#include "base/files.hpp"
#include "base/text.hpp"
#include "support/value_lines.hpp"

namespace myo::test {

/// A file or folder that the program of commit 8efc898 wrote, see tests/corpus/8efc898/README.md.
inline std::filesystem::path corpus(const std::string& name) {
    return std::filesystem::path(MYOLOOP_SOURCE_DIR) / "tests/corpus/8efc898" / name;
}

/// Content of a JSON file of the corpus.
inline nlohmann::json corpus_json(const std::string& name) {
    const Result<std::string> text = read_file(corpus(name));
    EXPECT_TRUE(text) << text.error().text();
    return nlohmann::json::parse(*text);
}

/// Whether two lines have the same words, numbers to rounding.
inline bool same_words(const std::string& a, const std::string& b) {
    std::istringstream as(a), bs(b);
    std::string x, y;
    while (as >> x) {
        if (!(bs >> y)) return false;
        double p = 0.0, q = 0.0;
        const bool numbers = parse_number(x, p) && parse_number(y, q);
        if (x != y && !(numbers && std::abs(p - q) <= 1e-14 * std::abs(p))) return false;
    }
    return !(bs >> y);
}

/// Expects every line of a record of the corpus among the values that were read now; these may have further lines.
inline void expect_values_of(const ValueLines& read, const std::string& record) {
    std::istringstream lines(*read_file(corpus(record)));
    std::string line;
    int count = 0;
    for (; std::getline(lines, line); ++count) {
        const std::size_t equals = line.find(" = ");
        const std::string key = line.substr(0, equals), held = line.substr(equals + 3);
        const auto found = read.lines().find(key);
        ASSERT_NE(found, read.lines().end()) << key << " is not read";
        EXPECT_TRUE(same_words(found->second, held)) << key << " is " << found->second << ", was " << held;
    }
    EXPECT_GT(count, 10);
}

/// Paths of all keys; elements of lists share one, and so do the entries of objects whose keys are names.
inline std::set<std::string> key_paths(const nlohmann::json& json, const std::set<std::string>& of_names,
                                       const std::string& path = {}) {
    std::set<std::string> paths;
    for (const auto& [key, value] : json.items()) {
        const std::string here = path + "." + (json.is_array() ? "[]" : of_names.contains(path) ? "*" : key);
        paths.insert(here);
        if (value.is_structured()) paths.merge(key_paths(value, of_names, here));
    }
    return paths;
}

/// Expects all keys of a JSON file of the corpus in what is written now: scripts read them.
inline void expect_keys_of(const nlohmann::json& written, const std::string& record,
                           const std::set<std::string>& of_names = {}) {
    const std::set<std::string> now = key_paths(written, of_names);
    for (const std::string& key : key_paths(corpus_json(record), of_names))
        EXPECT_TRUE(now.contains(key)) << record << ": " << key << " is no longer written";
}

}  // namespace myo::test
