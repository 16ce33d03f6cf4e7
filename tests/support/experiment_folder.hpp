#pragma once

#include <gtest/gtest.h>

#include <string>

#include "support/folder.hpp"

namespace myo::testing_support {

/// Tests of experiments use the folder without its namespace.
using test::Folder;

/// Replaces the first occurrence of `from`. Fails the test if there is none, so that a test notices a changed template.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << "the test's text has no: " << from;
    if (at != std::string::npos) text.replace(at, from.size(), to);
    return text;
}

/// Number of the line with the first occurrence, counted from 1; 0 if there is none. For error messages with line
/// numbers.
inline int line_of(const std::string& text, const std::string& part) {
    const std::size_t at = text.find(part);
    if (at == std::string::npos) return 0;
    int line = 1;
    for (std::size_t i = 0; i < at; ++i) line += text[i] == '\n';
    return line;
}

}  // namespace myo::testing_support
