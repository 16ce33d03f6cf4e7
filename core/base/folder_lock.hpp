#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "base/result.hpp"

namespace myo {

/// Exclusive use of a results folder for the lifetime of the object: two concurrent runs would mix their files.
///
/// The file `.myoloop.lock` in the folder holds the process id and carries an flock. The system releases the flock when
/// the process ends, so the lock of a killed process can be taken even if its id has been reused.
class FolderLock {
public:
    /// Takes the lock without waiting.
    /// Errors: "DIR is used by another run of myoloop, process 1234; wait for it or choose another folder"; or the lock
    /// file cannot be created.
    static Result<FolderLock> take(const std::filesystem::path& folder);
    /// Whether another process has the lock of a folder now.
    /// Errors: the lock file cannot be created.
    static Result<bool> is_taken(const std::filesystem::path& folder);
    /// Takes the lock of one file without waiting, by a hidden lock file beside it: `.NAME.lock`.
    /// Errors: "FILE is open in another window of Myoloop, process 1234"; or the lock file cannot be created.
    static Result<FolderLock> take_file(const std::filesystem::path& file);
    /// take_file() for work that can be left to another process: empty if that has the lock.
    /// Errors: the lock file cannot be created.
    static Result<std::optional<FolderLock>> take_file_if_free(const std::filesystem::path& file);

    FolderLock(FolderLock&& other) noexcept;
    FolderLock& operator=(FolderLock&& other) noexcept;
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;
    ~FolderLock();

private:
    FolderLock(std::filesystem::path file, int descriptor);
    /// Empty if another process has the lock.
    static Result<std::optional<FolderLock>> take_if_free(const std::filesystem::path& lock_file);
    /// @param refusal  the message if another process has the lock, from the words about its owner
    static Result<FolderLock> take(const std::filesystem::path& lock_file,
                                   const std::function<std::string(const std::string&)>& refusal);
    void release();

    std::filesystem::path file_;
    int descriptor_ = -1;  // file descriptor with the flock; -1: the object was moved from
};

}  // namespace myo
