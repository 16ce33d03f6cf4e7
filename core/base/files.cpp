#include "base/files.hpp"

#include <unistd.h>

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

Result<void> write_file_with(const fs::path& path, const std::function<bool(const fs::path&)>& write) {
    std::error_code code;
    if (path.has_parent_path()) fs::create_directories(path.parent_path(), code);
    if (code) return Error{"folder cannot be made: " + code.message(), path.parent_path().string()};
    // The extension stays at the end: some writers choose the format by it.
    const std::string name = std::string(".") + path.stem().string() + "." + std::to_string(::getpid()) + ".part";
    fs::path temporary = path.parent_path() / name;
    temporary += path.extension();
    if (!write(temporary)) {
        fs::remove(temporary, code);
        return Error{"cannot be written", path.string()};
    }
    fs::rename(temporary, path, code);
    if (code) {
        const std::string reason = code.message();
        fs::remove(temporary, code);
        return Error{"cannot be written: " + reason, path.string()};
    }
    return {};
}

Result<void> write_file(const fs::path& path, std::string_view content) {
    return write_file_with(path, [&](const fs::path& temporary) {
        std::ofstream stream(temporary, std::ios::binary);
        stream.write(content.data(), static_cast<std::streamsize>(content.size()));
        stream.close();
        return !stream.fail();
    });
}

}  // namespace myo
