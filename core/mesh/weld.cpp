#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <set>
#include <unordered_map>

#include "mesh/surface_check.hpp"

namespace myo::mesh {
namespace {

using GridCell = std::array<std::int64_t, 3>;

/// Hash of a grid cell for spatial hashing.
struct GridHash {
    std::size_t operator()(const GridCell& c) const {
        std::uint64_t h = 0;
        for (const std::int64_t i : c) h = (h ^ static_cast<std::uint64_t>(i)) * 0x9E3779B97F4A7C15ULL, h ^= h >> 29;
        return static_cast<std::size_t>(h);
    }
};

// For each vertex a vertex within the tolerance that represents itself: the first one of the first grid cell around it
// that has any; the vertex itself if none has.
std::vector<int> representatives(const Eigen::Matrix3Xd& x, double tolerance) {
    std::vector<int> stands_for(static_cast<std::size_t>(x.cols()));
    std::unordered_map<GridCell, std::vector<int>, GridHash> grid;
    grid.reserve(stands_for.size());
    // Cells of the size of the tolerance: a partner is at most one cell away. Tolerance 0 merges equal points only.
    const double width = tolerance > 0.0 ? tolerance : 1e-300;
    const Eigen::Vector3d origin = x.cols() > 0 ? Eigen::Vector3d(x.rowwise().minCoeff()) : Eigen::Vector3d::Zero();
    for (Eigen::Index v = 0; v < x.cols(); ++v) {
        GridCell cell{};
        for (std::size_t a = 0; a < 3; ++a) {
            const auto i = static_cast<Eigen::Index>(a);
            // Very distant points (and NaN) share the last cell; the distance is compared there anyway.
            const double place = std::floor((x(i, v) - origin[i]) / width);
            cell[a] = static_cast<std::int64_t>(std::abs(place) < 9e15 ? place : 9e15);
        }
        int found = -1;
        for (std::int64_t k = 0; k < 27 && found < 0; ++k) {
            const auto bucket = grid.find({cell[0] + k % 3 - 1, cell[1] + k / 3 % 3 - 1, cell[2] + k / 9 - 1});
            if (bucket == grid.end()) continue;
            for (const int other : bucket->second) {
                if ((x.col(v) - x.col(other)).norm() <= tolerance && (found < 0 || other < found)) found = other;
            }
        }
        // Only representatives are stored: chains of close vertices do not merge over long distances.
        if (found < 0) grid[cell].push_back(static_cast<int>(v));
        stands_for[static_cast<std::size_t>(v)] = found < 0 ? static_cast<int>(v) : found;
    }
    return stands_for;
}

}  // namespace

double weld_tolerance(const SurfaceMesh& surface) {
    if (surface.vertices.cols() == 0) return 0.0;
    const double diagonal = bounding_box(surface.vertices).size().norm();
    return std::max(1e-6 * diagonal, 4.0 * 6e-8 * surface.vertices.cwiseAbs().maxCoeff());
}

SurfaceMesh weld(const SurfaceMesh& surface, double tolerance) {
    assert(tolerance >= 0.0);
    // Triangles are kept or removed by their merged corners; then unused vertices are dropped and the rest renumbered.
    const std::vector<int> stands_for = representatives(surface.vertices, tolerance);
    std::vector<std::array<int, 3>> kept;
    std::set<std::array<int, 3>> seen;
    for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) {
        std::array<int, 3> corners{};
        for (std::size_t i = 0; i < 3; ++i) {
            corners[i] = stands_for[static_cast<std::size_t>(surface.triangles(static_cast<Eigen::Index>(i), t))];
        }
        // Two merged corners: the triangle has collapsed to an edge.
        if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
        std::array<int, 3> key = corners;
        // Duplicates are recognised regardless of orientation and starting corner.
        std::sort(key.begin(), key.end());
        if (seen.insert(key).second) kept.push_back(corners);
    }

    std::vector<int> new_number(stands_for.size(), -1);
    for (const auto& corners : kept) {
        for (const int v : corners) new_number[static_cast<std::size_t>(v)] = 0;
    }
    SurfaceMesh welded;
    welded.vertices.resize(3, std::count(new_number.begin(), new_number.end(), 0));
    int next = 0;
    for (std::size_t v = 0; v < new_number.size(); ++v) {
        if (new_number[v] < 0) continue;
        welded.vertices.col(next) = surface.vertices.col(static_cast<Eigen::Index>(v));
        new_number[v] = next++;
    }
    welded.triangles.resize(3, static_cast<Eigen::Index>(kept.size()));
    for (std::size_t t = 0; t < kept.size(); ++t) {
        for (std::size_t i = 0; i < 3; ++i) {
            welded.triangles(static_cast<Eigen::Index>(i),
                             static_cast<Eigen::Index>(t)) = new_number[static_cast<std::size_t>(kept[t][i])];
        }
    }
    return welded;
}

SurfaceMesh weld(const SurfaceMesh& surface) { return weld(surface, weld_tolerance(surface)); }

SurfaceMesh flipped(SurfaceMesh surface) {
    surface.triangles.row(1).swap(surface.triangles.row(2));
    return surface;
}

}  // namespace myo::mesh
