#pragma once

#include <filesystem>
#include <mutex>
#include <vector>

#include "trust/case_record.hpp"

namespace myo {

/// Records of a trust study, one JSON line each, in the order in which they were finished; several processes may add to one file.
class RecordFile {
public:
    explicit RecordFile(std::filesystem::path file) : file_(std::move(file)) {}

    /// Those there, by number, the last of a number counting. A last line that a killed process left unfinished is passed over.
    /// Error: another line cannot be read; its number.
    Result<std::vector<CaseRecord>> read() const;
    /// Adds one at the end, at once. Error: the file cannot be written.
    Result<void> add(const CaseRecord& record);

private:
    std::filesystem::path file_;
    std::mutex mutex_;
};

}  // namespace myo
