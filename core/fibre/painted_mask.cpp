#include "fibre/painted_mask.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "fibre/cell_parts.hpp"
#include "mesh/box_tree.hpp"
#include "mesh/cell_traits.hpp"

namespace myo::fibre {
namespace {

using Eigen::Index;
using Eigen::Vector3d;

/// Centre of a cell from its corners; mid-side nodes are not needed.
Vector3d centroid(const mesh::VolumeMesh& mesh, Index cell) {
    const int corners = mesh::cell_traits(mesh.type).corners;
    Vector3d sum = Vector3d::Zero();
    for (int a = 0; a < corners; ++a) sum += mesh.nodes.col(mesh.cells(a, cell));
    return sum / corners;
}

double mean_edge(const mesh::VolumeMesh& mesh, Index cell) {
    const std::vector<std::array<int, 2>>& edges = mesh::cell_traits(mesh.type).edges;
    double sum = 0.0;
    for (const auto& [a, b] : edges)
        sum += (mesh.nodes.col(mesh.cells(a, cell)) - mesh.nodes.col(mesh.cells(b, cell))).norm();
    return sum / static_cast<double>(edges.size());
}

/// Nearest-element queries on a mask.
class MaskLookup {
public:
    explicit MaskLookup(const PaintedMask& mask)
        : mask_(mask), tree_(points(mask)), bounds_(mesh::bounding_box(mask.centroids_m)) {
        bounds_.lowest.array() -= mask.cell_size_m;
        bounds_.highest.array() += mask.cell_size_m;
    }

    /// Index of the nearest element within `reach` [m]; -1 if none.
    int nearest(const Vector3d& x, double reach) const {
        if (!bounds_.contains(x)) return -1;
        const auto squared_distance = [&](int i) { return (mask_.centroids_m.col(i) - x).squaredNorm(); };
        const int i = tree_.nearest(x, squared_distance);
        return squared_distance(i) <= reach * reach ? i : -1;
    }

    /// True if a ball cannot contain points within reach of any element.
    bool misses(const Vector3d& centre, double radius) const {
        return (centre.array() + radius < bounds_.lowest.array()).any() ||
               (centre.array() - radius > bounds_.highest.array()).any();
    }

private:
    static std::vector<Box> points(const PaintedMask& mask) {
        std::vector<Box> boxes;
        for (const Vector3d x : mask.centroids_m.colwise()) boxes.push_back({x, x});
        return boxes;
    }

    const PaintedMask& mask_;
    mesh::BoxTree tree_;
    Box bounds_;
};

/// Samples the parts of a cell after `cuts` subdivisions. `whole` accumulates their volume.
void collect(const mesh::VolumeMesh& mesh, int cell, const CellPart& part, int cuts, const PaintedMask& mask,
             const MaskLookup& lookup, std::vector<FibreSample>& samples, double& whole) {
    if (cuts > 0) {
        for (const CellPart& child : cut_in_eight(part))
            collect(mesh, cell, child, cuts - 1, mask, lookup, samples, whole);
        return;
    }
    const PartPlace place = place_of(mesh, cell, part);
    whole += place.volume_m3;
    const int i = lookup.nearest(place.centre_m, mask.cell_size_m);
    if (i >= 0 && mask.weights(i) > 0.0)
        samples.push_back({part, mask.weights(i) * place.volume_m3, mask.directions.col(i)});
}

/// True if weight and direction are uniform: such a cell is described by its volume fraction and direction alone.
bool evenly_painted(const std::vector<FibreSample>& samples, double volume_m3, double whole_m3) {
    if (samples.empty() || std::abs(volume_m3 - whole_m3) > 1e-9 * whole_m3) return false;
    const Vector3d& first = samples.front().direction;
    for (const FibreSample& sample : samples)
        if (sample.direction.cross(first).norm() > 1e-9) return false;
    return true;
}

/// Samples of a cell that does not coincide with a mask element, at a spacing of a quarter of the mask's cell size.
struct ResampledCell {
    std::vector<FibreSample> samples;
    double volume = 0.0, whole = 0.0;  // volume of muscle and of the cell, summed over samples [m3]
};
ResampledCell resample(const mesh::VolumeMesh& mesh, int cell, const PartPlace& place, const PaintedMask& mask,
                       const MaskLookup& lookup) {
    const double spacing = 0.25 * mask.cell_size_m,
                 edge = 1.15 * place.radius_m;  // 2 / sqrt(3): edge of a cube with this circumradius
    const int cuts = std::clamp(static_cast<int>(std::ceil(std::log2(edge / spacing) - 1e-6)), 0, 5);
    ResampledCell result;
    collect(mesh, cell, whole_cell(mesh.type), cuts, mask, lookup, result.samples, result.whole);
    for (const FibreSample& sample : result.samples) result.volume += sample.volume_m3;
    return result;
}

// Uniform cells use the quadrature points of the element, which integrate bending exactly.
void add_resampled_cell(const mesh::VolumeMesh& mesh, int cell, const ResampledCell& resampled, FibreGroup& group) {
    const auto& [samples, volume, whole] = resampled;
    if (samples.size() == 1 || evenly_painted(samples, volume, whole)) {
        const Vector3d direction = samples.front().direction;
        add_whole_cell(
            mesh, cell, volume / whole, [&](const Vector3d&) { return direction; }, group);
    } else {
        add_samples(mesh, cell, samples, group);
    }
}

/// Calls itself(cell, i) for cells that coincide with element i, and resampled(cell, samples) for other cells within
/// reach of the mask.
template <class Itself, class Resampled>
void for_painted_cells(const mesh::VolumeMesh& mesh, const PaintedMask& mask, const Itself& itself,
                       const Resampled& resampled) {
    if (mask.count() == 0) return;
    assert(mask.cell_size_m > 0.0);
    const MaskLookup lookup(mask);
    const CellPart whole = whole_cell(mesh.type);
    for (int c = 0; c < static_cast<int>(mesh.cell_count()); ++c) {
        const PartPlace place = place_of(mesh, c, whole);
        if (lookup.misses(place.centre_m, place.radius_m)) continue;
        // Tolerance: the centroid of a painted cell differs from the stored one by the rounding of the text file only.
        const int i = lookup.nearest(centroid(mesh, c), 1e-6 * mask.cell_size_m);
        if (i < 0)
            resampled(c, resample(mesh, c, place, mask, lookup));
        else if (mask.weights(i) > 0.0)
            itself(c, i);
    }
}

}  // namespace

PaintedMask mask_of_cells(const mesh::VolumeMesh& mesh, const CellPaint& paint) {
    const auto& [weights, directions] = paint;
    assert(weights.size() == mesh.cell_count() && directions.cols() == mesh.cell_count());
    // Nodes of painted cells mark the neighbours to be kept with weight 0.
    std::vector<bool> at_paint(static_cast<std::size_t>(mesh.node_count()), false);
    double edges = 0.0;
    Index painted = 0;
    for (Index c = 0; c < mesh.cell_count(); ++c) {
        if (!(weights(c) > 0.0)) continue;
        edges += mean_edge(mesh, c);
        ++painted;
        for (const int n : mesh.cells.col(c)) at_paint[static_cast<std::size_t>(n)] = true;
    }
    std::vector<Index> kept;
    for (Index c = 0; c < mesh.cell_count(); ++c)
        for (const int n : mesh.cells.col(c))
            if (at_paint[static_cast<std::size_t>(n)]) {
                kept.push_back(c);
                break;
            }
    PaintedMask mask;
    mask.cell_size_m = painted > 0 ? edges / static_cast<double>(painted) : 0.0;
    mask.centroids_m.resize(3, static_cast<Index>(kept.size()));
    for (std::size_t i = 0; i < kept.size(); ++i) mask.centroids_m.col(static_cast<Index>(i)) = centroid(mesh, kept[i]);
    mask.weights = weights(kept);
    mask.directions = directions(Eigen::all, kept);
    for (Index i = 0; i < mask.count(); ++i)
        if (!(mask.weights(i) > 0.0)) mask.weights(i) = 0.0, mask.directions.col(i).setZero();
    return mask;
}

FibreGroup fibres_of_mask(const mesh::VolumeMesh& mesh, const PaintedMask& mask, double stiffness_Pa,
                          std::string name) {
    FibreGroup group{std::move(name), stiffness_Pa, {}, {}};
    for_painted_cells(
        mesh, mask,
        [&](int cell, int i) {
            add_whole_cell(
                mesh, cell, mask.weights(i), [&](const Vector3d&) -> Vector3d { return mask.directions.col(i); },
                group);
        },
        [&](int cell, const ResampledCell& resampled) {
            if (!resampled.samples.empty()) add_resampled_cell(mesh, cell, resampled, group);
        });
    return group;
}

CellPaint paint_of_mask(const mesh::VolumeMesh& mesh, const PaintedMask& mask) {
    CellPaint paint = blank_paint(mesh);
    for_painted_cells(
        mesh, mask,
        [&](int cell, int i) {
            paint.weights(cell) = mask.weights(i);
            paint.directions.col(cell) = mask.directions.col(i);
        },
        [&](int cell, const ResampledCell& resampled) {
            if (!(resampled.volume > 0.0)) return;
            Eigen::Matrix3d dyads = Eigen::Matrix3d::Zero();
            for (const FibreSample& sample : resampled.samples)
                dyads += sample.volume_m3 * sample.direction * sample.direction.transpose();
            paint.weights(cell) = std::min(1.0, resampled.volume / resampled.whole);
            paint.directions.col(cell) = mean_line(dyads);
        });
    return paint;
}

}  // namespace myo::fibre
