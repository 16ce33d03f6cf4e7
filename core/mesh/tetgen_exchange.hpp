#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <type_traits>
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
enum Code : int {
    done = 0,
    bad_call = 64,       // wrong arguments, or the request cannot be read
    cannot_write = 65,   // the answer cannot be written
    out_of_memory = 66,  // the memory limit was reached
    tetgen_error = 80,   // TetGen failed; its error code is added
};
}  // namespace worker_status

/// First bytes of an exchange file: files of other programs or versions are rejected.
inline constexpr std::array<char, 8> tetgen_exchange_magic{'M', 'Y', 'O', 'T', 'E', 'T', '1', '\0'};

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
    stream.write(tetgen_exchange_magic.data(), tetgen_exchange_magic.size());
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
    std::remove_const_t<decltype(tetgen_exchange_magic)> magic{};
    if (code || !stream.read(magic.data(), magic.size()) || magic != tetgen_exchange_magic) return false;
    return read_block(stream, size, content.points) && read_block(stream, size, content.cells) &&
           read_block(stream, size, content.holes);
}

}  // namespace myo::mesh
