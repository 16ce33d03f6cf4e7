#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace myo::test {

/// A temporary folder for one test, deleted in the destructor. The process id in its name separates tests that run in
/// parallel.
class Folder {
public:
    explicit Folder(const std::string& name)
        : path_(std::filesystem::path(::testing::TempDir()) / ("myoloop_" + name + "_" + std::to_string(::getpid()))) {
        std::filesystem::remove_all(path_);
        std::filesystem::create_directories(path_);
    }
    ~Folder() {
        // A failure to delete must not hide the result of the test.
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;

    // Paths and content. write() creates missing folders; `file` may contain a folder.
    const std::filesystem::path& path() const { return path_; }
    std::string str(const std::string& file) const { return (path_ / file).string(); }
    void write(const std::string& file, const std::string& content) const {
        std::filesystem::create_directories((path_ / file).parent_path());
        std::ofstream(path_ / file, std::ios::binary) << content;
    }
    bool has(const std::string& file) const { return std::filesystem::exists(path_ / file); }

private:
    std::filesystem::path path_;
};

}  // namespace myo::test
