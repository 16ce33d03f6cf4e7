#include "base/files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <sstream>
#include <system_error>

namespace myo {
namespace fs = std::filesystem;

Result<std::string> read_file(const fs::path& path) {
    std::error_code code;
    if (!fs::exists(path, code)) return Error{"file not found", path.string()};
    if (fs::is_directory(path, code)) return Error{"is a folder, not a file", path.string()};
    std::ifstream stream(path, std::ios::binary);
    if (!stream) return Error{"cannot be opened for reading", path.string()};
    std::ostringstream content;
    content << stream.rdbuf();
    if (stream.bad()) return Error{"reading failed", path.string()};
    return std::move(content).str();
}

// read_symlink returns one level and a relative target refers to the folder of the link.
fs::path behind_links(fs::path path) {
    std::error_code code;
    while (fs::is_symlink(path, code)) {
        const fs::path target = fs::read_symlink(path, code);
        path = target.is_absolute() ? target : path.parent_path() / target;
    }
    return path;
}

Error not_written(const fs::path& path, int reason) {
    return {"cannot be written: " + std::generic_category().message(reason), path.string()};
}

namespace {

/// Writes all of the content, resuming after partial writes and signals. Returns 0 or errno.
int write_all(int descriptor, std::string_view content) {
    while (!content.empty()) {
        const ssize_t written = ::write(descriptor, content.data(), content.size());
        if (written < 0 && errno != EINTR) return errno;
        if (written > 0) content.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

/// Opens with the given flags, writes and closes. Returns 0 or errno.
int write_opened(const fs::path& path, int flags, std::string_view content) {
    const int descriptor = ::open(path.c_str(), flags | O_WRONLY | O_CLOEXEC | O_NOCTTY, 0666);
    if (descriptor < 0) return errno;
    const int failed = write_all(descriptor, content);
    // Some file systems report a full disk only when the file is closed.
    return ::close(descriptor) == 0 || failed != 0 ? failed : errno;
}

/// Descriptor of the standard stream that is redirected to this file, as after `myoloop ... > file`; -1 if none.
int standard_stream_of(const struct ::stat& file) {
    for (const int stream : {STDOUT_FILENO, STDERR_FILENO}) {
        struct ::stat other {};
        const bool same = ::fstat(stream, &other) == 0 && other.st_dev == file.st_dev && other.st_ino == file.st_ino;
        if (same) return stream;
    }
    return -1;
}

/// Writes to a temporary file in the same folder and renames it, which is atomic within a file system.
Result<void> replace_file(const fs::path& path, std::string_view content) {
    std::error_code code;
    if (path.has_parent_path()) fs::create_directories(path.parent_path(), code);
    if (code) return Error{"folder cannot be made: " + code.message(), path.parent_path().string()};
    const std::string name = "." + path.filename().string() + "." + std::to_string(::getpid()) + ".part";
    const fs::path temporary = path.parent_path() / name;
    int failed = write_opened(temporary, O_CREAT | O_TRUNC, content);
    if (failed == 0 && ::rename(temporary.c_str(), path.c_str()) != 0) failed = errno;
    if (failed == 0) return {};
    fs::remove(temporary, code);
    return not_written(path, failed);
}

}  // namespace

Result<void> write_file(const fs::path& path, std::string_view content) {
    struct ::stat found {};
    const int missing = ::stat(path.c_str(), &found) == 0 ? 0 : errno;
    // A loop of links fails here: behind_links() below would not return.
    if (missing == ELOOP) return not_written(path, missing);
    if (missing != 0) return replace_file(behind_links(path), content);
    if (S_ISDIR(found.st_mode)) return Error{"is a folder, not a file", path.string()};
    // Writing to a redirected standard stream continues at its current offset; opening the file again would overwrite
    // what was already printed. A character device has no such offset and can be opened again.
    const int stream = S_ISCHR(found.st_mode) ? -1 : standard_stream_of(found);
    if (stream < 0 && S_ISREG(found.st_mode)) return replace_file(behind_links(path), content);
    const int failed = stream < 0 ? write_opened(path, 0, content) : write_all(stream, content);
    return failed == 0 ? Result<void>() : not_written(path, failed);
}

}  // namespace myo
