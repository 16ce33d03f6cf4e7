#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace myo::testing_support {

/// An experiment folder written by a test; body, traces and signals are small but real files.
class ExperimentFolder {
public:
    explicit ExperimentFolder(const std::string& name)
        : path_(std::filesystem::path(::testing::TempDir()) / ("myoloop_" + name + "_" + std::to_string(::getpid()))) {
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
    }
    ~ExperimentFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    ExperimentFolder(const ExperimentFolder&) = delete;
    ExperimentFolder& operator=(const ExperimentFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }
    void write(const std::string& file, const std::string& content) const { std::ofstream(path_ / file, std::ios::binary) << content; }

private:
    std::filesystem::path path_;
};

/// Where the shared data lies, or an empty path.
inline std::filesystem::path data_folder() {
    const char* const named = std::getenv("MYOLOOP_DATA");
    const std::filesystem::path folder =
        named != nullptr ? std::filesystem::path(named) : std::filesystem::path(MYOLOOP_SOURCE_DIR) / ".." / "shared";
    return std::filesystem::is_directory(folder / "experiments") ? folder : std::filesystem::path();
}

/// Replaces the first occurrence; fails the test when there is none.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << "the test's text has no: " << from;
    if (at != std::string::npos) text.replace(at, from.size(), to);
    return text;
}

/// 1-based line of the first occurrence, 0 when there is none.
inline int line_of(const std::string& text, const std::string& part) {
    const std::size_t at = text.find(part);
    if (at == std::string::npos) return 0;
    int line = 1;
    for (std::size_t i = 0; i < at; ++i) line += text[i] == '\n';
    return line;
}

}  // namespace myo::testing_support
