#include "fibre/mask_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text.hpp"
#include "mesh/box_tree.hpp"

namespace myo::fibre {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

std::vector<Box> places(const PaintedMask& mask) {
    std::vector<Box> boxes;
    for (const Vector3d x : mask.centroids_m.colwise()) boxes.push_back({x, x});
    return boxes;
}

/// Median distance to the nearest other element; NaN if there is none. Coincident elements are skipped.
double spacing(const PaintedMask& mask) {
    constexpr double nowhere = std::numeric_limits<double>::max();
    const mesh::BoxTree tree(places(mask));
    std::vector<double> distances;
    for (Index i = 0; i < mask.count(); ++i) {
        const Vector3d x = mask.centroids_m.col(i);
        const auto elsewhere = [&](int k) {
            const double squared = (mask.centroids_m.col(k) - x).squaredNorm();
            return squared > 0.0 ? squared : nowhere;
        };
        const double squared = elsewhere(tree.nearest(x, elsewhere));
        if (squared < nowhere) distances.push_back(std::sqrt(squared));
    }
    if (distances.empty()) return std::nan("");
    const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
    std::nth_element(distances.begin(), middle, distances.end());
    return *middle;
}

std::string in_mm(double length_m) { return format_number(1e3 * length_m, 3) + " mm"; }

/// True if two rows are equal in weight and fibre direction.
bool same_paint(const PaintedMask& mask, int a, int b) {
    if (mask.weights(a) != mask.weights(b)) return false;
    return !(mask.weights(a) > 0.0) || mask.directions.col(a).cross(mask.directions.col(b)).norm() < 1e-3;
}

}  // namespace

std::vector<std::string> contradictions(const PaintedMask& mask, const MaskRule& rule) {
    std::vector<std::string> found;
    if (mask.count() < 2) return found;
    const double apart = spacing(mask), size = mask.cell_size_m / apart;
    if (mask.count() >= rule.min_places && !(size >= rule.min_size && size <= rule.max_size))
        found.push_back(
            "cell_size_m says " + in_mm(mask.cell_size_m) + ", but its places are " + in_mm(apart) +
            " apart: " + (size < 1.0 ? "most of the room between them stays unpainted" : "paint spreads beyond them"));
    Index twice = 0;
    Vector3d first = Vector3d::Zero();
    mesh::BoxTree(places(mask))
        .overlapping_pairs(rule.same_place * std::min(apart, mask.cell_size_m), [&](int a, int b) {
            if (same_paint(mask, a, b)) return true;
            if (twice++ == 0) first = mask.centroids_m.col(a);
            return true;
        });
    if (twice > 0)
        found.push_back(std::to_string(twice) + (twice == 1 ? " place is" : " places are") +
                        " listed twice with other weights or fibres, one at (" + format_number(first.x(), 4) + ", " +
                        format_number(first.y(), 4) + ", " + format_number(first.z(), 4) +
                        ") m; which of the rows counts is not defined");
    return found;
}

// Distance to the bounding boxes of cells: a cheap lower bound of the distance to the mesh.
Index elements_off_mesh(const mesh::VolumeMesh& mesh, const PaintedMask& mask) {
    if (mask.count() == 0) return 0;
    std::vector<Box> cells;
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        Eigen::Matrix3Xd corners(3, mesh.cells.rows());
        for (Index a = 0; a < corners.cols(); ++a) corners.col(a) = mesh.nodes.col(mesh.cells(a, c));
        cells.push_back(mesh::bounding_box(corners));
    }
    const mesh::BoxTree tree(cells);
    const double apart = mask.count() > 1 ? spacing(mask) : mask.cell_size_m;
    Index off = 0;
    for (Index i = 0; i < mask.count(); ++i) {
        if (!(mask.weights(i) > 0.0)) continue;
        const Vector3d x = mask.centroids_m.col(i);
        const auto squared = [&](int c) {
            const Box& cell = cells[static_cast<std::size_t>(c)];
            return (x.cwiseMax(cell.lowest).cwiseMin(cell.highest) - x).squaredNorm();
        };
        const int nearest = tree.nearest(x, squared);
        const double allowed = 0.5 * (apart + cells[static_cast<std::size_t>(nearest)].size().mean());
        if (squared(nearest) > allowed * allowed) ++off;
    }
    return off;
}

}  // namespace myo::fibre
