#include "mesh/surface_reader.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

#include "mesh/file_formats.hpp"

namespace myo::mesh {
namespace {

/// Extension of a file in lower case, with its dot.
std::string lower_extension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

/// Selects the reader by the extension.
Result<PolygonSoup> read_polygons(const std::filesystem::path& path) {
    const std::string extension = lower_extension(path);
    if (extension == ".stl") return read_stl(path);
    if (extension == ".obj") return read_obj(path);
    if (extension == ".ply") return read_ply(path);
    if (extension == ".vtp") return read_vtp(path);
    return Error{"unknown kind of surface file '" + extension + "': .stl, .obj, .ply and .vtp are read", path.string()};
}

}  // namespace

Result<SurfaceMesh> read_surface(const std::filesystem::path& path, double metres_per_unit,
                                 const Eigen::Matrix3d& rotation, std::vector<std::string>* warnings) {
    // Both come from declarations and command lines, hence an error instead of an assertion.
    if (!(metres_per_unit > 0.0) || !std::isfinite(metres_per_unit))
        return Error{"the length unit must be positive", path.string()};
    if (!rotation.allFinite() || !(rotation.transpose() * rotation).isIdentity(1e-6) || rotation.determinant() < 0.0) {
        return Error{"the rotation is not a rotation: its rows must be orthonormal and its determinant 1",
                     path.string()};
    }
    const auto soup = read_polygons(path);
    if (!soup) return soup.error();
    if (warnings != nullptr)
        for (const std::string& warning : soup->warnings)
            warnings->push_back(path.filename().string() + ": " + warning);
    if (soup->triangles.empty()) return Error{"the file holds no triangles", path.string()};

    SurfaceMesh surface;
    surface.vertices.resize(3, static_cast<Eigen::Index>(soup->vertices.size()));
    for (std::size_t v = 0; v < soup->vertices.size(); ++v) {
        surface.vertices.col(static_cast<Eigen::Index>(v)) = rotation * (soup->vertices[v] * metres_per_unit);
    }
    surface.triangles.resize(3, static_cast<Eigen::Index>(soup->triangles.size()));
    // Indices are checked here for all formats.
    for (std::size_t t = 0; t < soup->triangles.size(); ++t) {
        for (std::size_t i = 0; i < 3; ++i) {
            const int v = soup->triangles[t][i];
            if (v < 0 || static_cast<std::size_t>(v) >= soup->vertices.size()) {
                return Error{
                    "triangle " + std::to_string(t).append(" (counted from 0) names a vertex that does not exist"),
                    path.string()};
            }
            surface.triangles(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(t)) = v;
            if (!soup->vertices[static_cast<std::size_t>(v)].allFinite()) {
                return Error{"vertex " + std::to_string(v).append(
                                             " (counted from 0) has coordinates that are not finite numbers"),
                             path.string()};
            }
        }
    }
    // Unused vertices may have any coordinates and must not affect the bounding box.
    std::vector<int> number(soup->vertices.size(), -1);
    for (const int v : surface.triangles.reshaped()) number[static_cast<std::size_t>(v)] = 0;
    std::vector<Eigen::Index> used;
    for (std::size_t v = 0; v < number.size(); ++v) {
        if (number[v] < 0) continue;
        number[v] = static_cast<int>(used.size());
        used.push_back(static_cast<Eigen::Index>(v));
    }
    surface.vertices = surface.vertices(Eigen::all, used).eval();
    for (int& v : surface.triangles.reshaped()) v = number[static_cast<std::size_t>(v)];
    return surface;
}

}  // namespace myo::mesh
