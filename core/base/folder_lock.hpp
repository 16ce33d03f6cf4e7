#pragma once

#include <filesystem>

#include "base/result.hpp"

namespace myo {

/// Keeps other runs out of a folder of results until it is destroyed: two runs at once would mix their files.
///
/// The file `.myoloop.lock` in the folder holds the process id. It is also locked for the system, which ends that with
/// the process: what a killed process left behind is taken over, even where its id was given to another process.
class FolderLock {
public:
    /// Error: "DIR is used by another run of myoloop, process 1234; wait for it or choose another folder"; the file
    /// cannot be made.
    static Result<FolderLock> take(const std::filesystem::path& folder);

    FolderLock(FolderLock&& other) noexcept;
    FolderLock& operator=(FolderLock&& other) noexcept;
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;
    ~FolderLock();

private:
    FolderLock(std::filesystem::path file, int descriptor);
    void release();

    std::filesystem::path file_;
    int descriptor_ = -1;  // -1: holds nothing
};

}  // namespace myo
