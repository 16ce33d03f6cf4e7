#include "base/folder_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>

#include "base/files.hpp"

namespace myo {
namespace {

namespace fs = std::filesystem;

/// False if the previous owner removed the lock file between our open() and flock(): our lock is then on a deleted
/// file.
bool is_still(const fs::path& file, int descriptor) {
    struct ::stat named {
    }, opened{};
    return ::stat(file.c_str(), &named) == 0 && ::fstat(descriptor, &opened) == 0 && named.st_dev == opened.st_dev &&
           named.st_ino == opened.st_ino;
}

/// ", process 1234" from the lock file; empty if the id is not yet written.
std::string owner_words(const fs::path& file) {
    const Result<std::string> id = read_file(file);
    const bool known = id && !id->empty() && id->find_first_not_of("0123456789\n") == std::string::npos;
    return known ? ", process " + id->substr(0, id->find('\n')) : "";
}

fs::path lock_file_in(const fs::path& folder) { return folder / ".myoloop.lock"; }

/// Hidden lock file beside a file.
fs::path lock_file_of(const fs::path& file) { return file.parent_path() / ("." + file.filename().string() + ".lock"); }

/// Writes the process id for messages of other runs. The lock is valid without it, for example on a full disk.
void write_owner(int descriptor) {
    const std::string id = std::to_string(::getpid()) + "\n";
    const bool written = ::ftruncate(descriptor, 0) == 0 && ::write(descriptor, id.data(), id.size()) >= 0;
    static_cast<void>(written);
}

}  // namespace

Result<FolderLock> FolderLock::take(const fs::path& folder) {
    return take(lock_file_in(folder), [&](const std::string& owner) {
        return folder.string() + " is used by another run of myoloop" + owner +
               "; wait for it or choose another folder";
    });
}

Result<bool> FolderLock::is_taken(const fs::path& folder) {
    const Result<std::optional<FolderLock>> lock = take_if_free(lock_file_in(folder));
    if (!lock) return lock.error();
    return !lock->has_value();
}

Result<FolderLock> FolderLock::take_file(const fs::path& file) {
    return take(lock_file_of(file), [&](const std::string& owner) {
        return file.filename().string() + " is open in another window of Myoloop" + owner;
    });
}

Result<std::optional<FolderLock>> FolderLock::take_file_if_free(const fs::path& file) {
    return take_if_free(lock_file_of(file));
}

Result<FolderLock> FolderLock::take(const fs::path& file,
                                    const std::function<std::string(const std::string&)>& refusal) {
    Result<std::optional<FolderLock>> taken = take_if_free(file);
    if (!taken) return taken.error();
    if (!*taken) return Error{refusal(owner_words(file)), ""};
    return **std::move(taken);
}

Result<std::optional<FolderLock>> FolderLock::take_if_free(const fs::path& file) {
    // Repeats until the locked file is also the file of that name, see is_still().
    while (true) {
        const int descriptor = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
        if (descriptor < 0) return Error{"cannot be made: " + std::generic_category().message(errno), file.string()};
        if (::flock(descriptor, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
            ::close(descriptor);
            return std::optional<FolderLock>();
        }
        if (is_still(file, descriptor)) {
            write_owner(descriptor);
            return std::optional<FolderLock>(FolderLock(file, descriptor));
        }
        ::close(descriptor);
    }
}

FolderLock::FolderLock(fs::path file, int descriptor) : file_(std::move(file)), descriptor_(descriptor) {}

FolderLock::FolderLock(FolderLock&& other) noexcept
    : file_(std::move(other.file_)), descriptor_(std::exchange(other.descriptor_, -1)) {}

FolderLock& FolderLock::operator=(FolderLock&& other) noexcept {
    release();
    file_ = std::move(other.file_);
    descriptor_ = std::exchange(other.descriptor_, -1);
    return *this;
}

FolderLock::~FolderLock() { release(); }

void FolderLock::release() {
    if (descriptor_ < 0) return;
    // Deleted while the lock is still held: after unlocking, the file may belong to another run.
    ::unlink(file_.c_str());
    ::close(std::exchange(descriptor_, -1));
}

}  // namespace myo
