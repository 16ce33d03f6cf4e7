#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <vector>

namespace myo::mesh {

/// Data exchanged with the worker process through files, in native binary format on one machine.
///
/// Request: points 3n, triangles 3m (surface, then interior facets), hole points 3k. Answer: points 3n, tetrahedra 4m,
/// no holes.
struct TetgenExchange {
    std::vector<double> points;       // coordinates in the scaled frame
    std::vector<std::int32_t> cells;  // vertex numbers from 0
    std::vector<double> holes;        // one point inside each cavity
};

/// Exit status of the worker. TetGen's own error codes (1 to 10) are added to `tetgen_error`.
namespace worker_status {
inline constexpr int done = 0;
/// Wrong arguments, or the request cannot be read.
inline constexpr int bad_call = 64;
/// The answer cannot be written.
inline constexpr int cannot_write = 65;
/// The memory limit was reached.
inline constexpr int out_of_memory = 66;
/// TetGen failed; its error code is added.
inline constexpr int tetgen_error = 80;
}  // namespace worker_status

inline constexpr std::uint64_t
    tetgen_exchange_magic = 0x31544554'4f594dULL;  // rejects files of other programs or versions

/// Writes a count and the values; false if writing failed.
template <class T>
bool write_block(std::ostream& stream, const std::vector<T>& values) {
    const std::uint64_t count = values.size();
    stream.write(reinterpret_cast<const char*>(&count), sizeof count);
    stream.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(count * sizeof(T)));
    return stream.good();
}

/// Reads a block of write_block(). The count is checked against the file size before memory is allocated.
template <class T>
bool read_block(std::istream& stream, std::uint64_t file_size, std::vector<T>& values) {
    std::uint64_t count = 0;
    if (!stream.read(reinterpret_cast<char*>(&count), sizeof count) || count > file_size / sizeof(T)) return false;
    values.resize(count);
    return count == 0 ||
           stream.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(count * sizeof(T))).good();
}

/// Writes a complete exchange file; false if writing failed.
inline bool write_exchange(const std::filesystem::path& path, const TetgenExchange& content) {
    std::ofstream stream(path, std::ios::binary);
    stream.write(reinterpret_cast<const char*>(&tetgen_exchange_magic), sizeof tetgen_exchange_magic);
    const bool written = write_block(stream, content.points) && write_block(stream, content.cells) &&
                         write_block(stream, content.holes);
    stream.close();
    return written && !stream.fail();
}

/// Reads a complete exchange file; false if it is missing, truncated or of another format.
inline bool read_exchange(const std::filesystem::path& path, TetgenExchange& content) {
    std::error_code code;
    const std::uint64_t size = std::filesystem::file_size(path, code);
    std::ifstream stream(path, std::ios::binary);
    std::uint64_t magic = 0;
    if (code || !stream.read(reinterpret_cast<char*>(&magic), sizeof magic) || magic != tetgen_exchange_magic)
        return false;
    return read_block(stream, size, content.points) && read_block(stream, size, content.cells) &&
           read_block(stream, size, content.holes);
}

}  // namespace myo::mesh
