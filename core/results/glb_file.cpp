#include "results/glb_file.hpp"

#include <cassert>
#include <cmath>
#include <cstdint>
#include <string>

#include <Eigen/Geometry>

#include "base/files.hpp"
#include "report/json.hpp"

namespace myo::results {
namespace {

using Eigen::Index;
using report::Json;

// Numbers of the specification.
enum ComponentType : int { float_type = 5126, unsigned_int_type = 5125 };
enum BufferTarget : int { array_buffer = 34962, element_array_buffer = 34963 };
constexpr std::uint32_t magic = 0x46546C67, version = 2, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;

struct GlbLookPolicy {
    double grey = 0.6;       // linear colour of a body without colours: neither burns out nor vanishes in viewers
    double roughness = 0.8;  // 0 ... 1; dull, so that highlights do not hide the colours
};
constexpr GlbLookPolicy glb_look_policy;

/// sRGB to linear, IEC 61966-2-1.
float linear(float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); }

/// Unit normals of the vertices; a triangle counts by its area.
/// The length of the cross product is twice the area, so that the plain sum is the weighted one.
Eigen::Matrix3Xf normals_of(const mesh::SurfaceMesh& surface) {
    Eigen::Matrix3Xd normals = Eigen::Matrix3Xd::Zero(3, surface.vertices.cols());
    for (Index t = 0; t < surface.triangles.cols(); ++t) {
        const auto corner = [&](Index i) -> Eigen::Vector3d { return surface.vertices.col(surface.triangles(i, t)); };
        const Eigen::Vector3d doubled_area = (corner(1) - corner(0)).cross(corner(2) - corner(0));
        for (Index i = 0; i < 3; ++i) normals.col(surface.triangles(i, t)) += doubled_area;
    }
    for (auto normal : normals.colwise()) {
        // A vertex without area has no direction, but the format demands unit length.
        if (normal.squaredNorm() > 0.0)
            normal.normalize();
        else
            normal = Eigen::Vector3d::UnitZ();
    }
    return normals.cast<float>();
}

/// The binary part, with its views and accessors.
struct Buffer {
    std::string bytes;
    Json views = Json::array(), accessors = Json::array();

    /// Appends a vector per vertex. Returns the number of its accessor.
    std::size_t add_vectors(const Eigen::Matrix3Xf& vectors, bool with_bounds) {
        Json accessor{{"bufferView", views.size()},
                      {"componentType", static_cast<int>(float_type)},
                      {"count", vectors.cols()},
                      {"type", "VEC3"}};
        if (with_bounds) {
            // Bounds of the numbers as stored, so that they hold exactly.
            const Eigen::Vector3f least = vectors.rowwise().minCoeff(), greatest = vectors.rowwise().maxCoeff();
            // The format demands bounds of positions only.
            accessor["min"] = {least.x(), least.y(), least.z()};
            accessor["max"] = {greatest.x(), greatest.y(), greatest.z()};
        }
        return append(vectors.data(), static_cast<std::size_t>(vectors.size()) * sizeof(float), array_buffer,
                      std::move(accessor));
    }
    /// Appends three indices per triangle, 32 bits each. Returns the number of its accessor.
    std::size_t add_indices(const Eigen::Matrix3Xi& triangles) {
        const Eigen::Matrix<std::uint32_t, 3, Eigen::Dynamic> indices = triangles.cast<std::uint32_t>();
        return append(indices.data(), static_cast<std::size_t>(indices.size()) * sizeof(std::uint32_t),
                      element_array_buffer,
                      Json{{"bufferView", views.size()},
                           {"componentType", static_cast<int>(unsigned_int_type)},
                           {"count", indices.size()},
                           {"type", "SCALAR"}});
    }

private:
    /// Appends bytes with a view, and an accessor that refers to it. All entries are multiples of four bytes, as the
    /// alignment of floats and indices demands.
    std::size_t append(const void* data, std::size_t size, BufferTarget target, Json accessor) {
        views.push_back(Json{
            {"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", size}, {"target", static_cast<int>(target)}});
        bytes.append(static_cast<const char*>(data), size);
        accessors.push_back(std::move(accessor));
        return accessors.size() - 1;
    }
};

/// Little-endian, whatever the machine.
void append_number(std::string& content, std::uint32_t value) {
    for (int shift = 0; shift < 32; shift += 8) content += static_cast<char>((value >> shift) & 0xFFu);
}

/// A chunk, padded to a multiple of four bytes.
void append_chunk(std::string& content, std::uint32_t type, std::string bytes, char padding) {
    while (bytes.size() % 4 != 0) bytes += padding;
    append_number(content, static_cast<std::uint32_t>(bytes.size()));
    append_number(content, type);
    content += bytes;
}

}  // namespace

Result<void> write_glb(const std::filesystem::path& path, const mesh::SurfaceMesh& surface,
                       const Eigen::Matrix3Xf& colours) {
    assert(colours.cols() == 0 || colours.cols() == surface.vertices.cols());
    if (surface.triangles.cols() == 0) return Error{"there is no surface to write", path.string()};
    Buffer buffer;
    Json attributes;
    attributes["POSITION"] = buffer.add_vectors(surface.vertices.cast<float>(), true);
    attributes["NORMAL"] = buffer.add_vectors(normals_of(surface), false);
    if (colours.cols() > 0) attributes["COLOR_0"] = buffer.add_vectors(colours.unaryExpr(&linear), false);
    const std::size_t indices = buffer.add_indices(surface.triangles);
    const double half = std::sqrt(0.5);  // a quarter turn about x
    // Colours of vertices are multiplied by the base colour, which is white then.
    const double grey = colours.cols() > 0 ? 1.0 : glb_look_policy.grey;
    Json json;
    json["asset"] = {{"version", "2.0"}, {"generator", "Myoloop"}};
    json["scene"] = 0;
    json["scenes"] = Json::array({Json{{"nodes", Json::array({0})}}});
    json["nodes"] = Json::array({Json{{"mesh", 0}, {"name", "body"}, {"rotation", {-half, 0.0, 0.0, half}}}});
    json["meshes"] = Json::array(
        {Json{{"primitives",
               Json::array({Json{{"attributes", attributes}, {"indices", indices}, {"material", 0}, {"mode", 4}}})}}});
    json["materials"] = Json::array({Json{{"pbrMetallicRoughness",
                                           {{"baseColorFactor", {grey, grey, grey, 1.0}},
                                            {"metallicFactor", 0.0},
                                            {"roughnessFactor", glb_look_policy.roughness}}}}});
    json["accessors"] = buffer.accessors;
    json["bufferViews"] = buffer.views;
    json["buffers"] = Json::array({Json{{"byteLength", buffer.bytes.size()}}});
    std::string chunks;
    append_chunk(chunks, json_chunk, report::json_line(json), ' ');
    append_chunk(chunks, binary_chunk, std::move(buffer.bytes), '\0');
    std::string content;
    append_number(content, magic);
    append_number(content, version);
    // Length of the whole file: a header of three numbers, and the chunks.
    append_number(content, static_cast<std::uint32_t>(12 + chunks.size()));
    return write_file(path, content + chunks);
}

}  // namespace myo::results
