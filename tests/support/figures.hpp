#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "base/text.hpp"

namespace myo::test {

/// Stores a measured number with the test's result (--gtest_output=xml).
inline void record(const std::string& name, double value) { testing::Test::RecordProperty(name, format_number(value)); }

/// As above for a list of numbers.
inline void record(const std::string& name, const std::vector<double>& values) {
    std::vector<std::string> words;
    for (const double value : values) words.push_back(format_number(value, 4));
    testing::Test::RecordProperty(name, join(words));
}

}  // namespace myo::test
