#include "fibre/cell_paint.hpp"

#include <algorithm>
#include <cassert>
#include <vector>

#include "fibre/cell_parts.hpp"
#include "fibre/direction_field.hpp"
#include "mesh/disjoint_sets.hpp"

namespace myo::fibre {

using Eigen::Index;

CellPaint blank_paint(const mesh::VolumeMesh& mesh) {
    return {Eigen::VectorXd::Zero(mesh.cell_count()), Eigen::Matrix3Xd::Zero(3, mesh.cell_count())};
}

CellPaint paint_of_group(const mesh::VolumeMesh& mesh, const FibreGroup& group) {
    assert(group.gradients.size() == group.points.size());
    CellPaint paint = blank_paint(mesh);
    std::vector<Eigen::Matrix3d> dyads(static_cast<std::size_t>(mesh.cell_count()), Eigen::Matrix3d::Zero());
    for (std::size_t i = 0; i < group.points.size(); ++i) {
        const FibrePoint& point = group.points[i];
        const Eigen::Vector3d line = direction_of(group, i);
        paint.weights(point.cell) += point.volume;
        dyads[static_cast<std::size_t>(point.cell)] += point.volume * line * line.transpose();
    }
    const Eigen::VectorXd volumes_m3 = mesh::cell_volumes(mesh);
    for (Index c = 0; c < paint.count(); ++c) {
        if (!(paint.weights(c) > 0.0)) continue;
        paint.weights(c) = std::min(1.0, paint.weights(c) / volumes_m3(c));
        paint.directions.col(c) = mean_line(dyads[static_cast<std::size_t>(c)]);
    }
    return paint;
}

PaintedAmount amount_of(const CellPaint& paint, const Eigen::VectorXd& volumes_m3) {
    assert(volumes_m3.size() == paint.count());
    return {static_cast<int>((paint.weights.array() > 0.0).count()), paint.weights.dot(volumes_m3)};
}

CellPaint grown(const CellPaint& paint, const Eigen::Matrix2Xi& neighbours) {
    struct Gathered {
        double weight = 0.0, count = 0.0;
        Eigen::Matrix3d dyads = Eigen::Matrix3d::Zero();
    };
    // Both orders of each pair are visited, because either cell may be the painted one.
    std::vector<Gathered> gathered(static_cast<std::size_t>(paint.count()));
    const auto give = [&](int from, int to) {
        if (!(paint.weights(from) > 0.0) || paint.weights(to) > 0.0) return;
        Gathered& at = gathered[static_cast<std::size_t>(to)];
        at.weight += paint.weights(from);
        at.count += 1.0;
        at.dyads += paint.weights(from) * paint.directions.col(from) * paint.directions.col(from).transpose();
    };
    for (const auto pair : neighbours.colwise()) {
        give(pair(0), pair(1));
        give(pair(1), pair(0));
    }
    CellPaint result = paint;
    for (Index c = 0; c < paint.count(); ++c) {
        const Gathered& at = gathered[static_cast<std::size_t>(c)];
        if (!(at.count > 0.0)) continue;
        result.weights(c) = at.weight / at.count;
        result.directions.col(c) = mean_line(at.dyads);
    }
    return result;
}

CellPaint shrunk(const CellPaint& paint, const Eigen::Matrix2Xi& neighbours) {
    CellPaint result = paint;
    const auto at_edge = [&](int cell, int other) {
        if (paint.weights(other) > 0.0) return;
        result.weights(cell) = 0.0;
        result.directions.col(cell).setZero();
    };
    for (const auto pair : neighbours.colwise()) {
        at_edge(pair(0), pair(1));
        at_edge(pair(1), pair(0));
    }
    return result;
}

CellPaint filled(const CellPaint& paint, const mesh::VolumeMesh& mesh, const Eigen::Matrix2Xi& neighbours, int cell,
                 const Eigen::Vector3d& axis) {
    assert(paint.count() == mesh.cell_count());
    if (paint.weights(cell) > 0.0) return paint;
    // Connected components of unpainted cells.
    mesh::DisjointSets pieces(static_cast<std::size_t>(paint.count()));
    std::vector<int> painted;
    for (const auto pair : neighbours.colwise())
        if (!(paint.weights(pair(0)) > 0.0) && !(paint.weights(pair(1)) > 0.0))
            pieces.join(static_cast<std::size_t>(pair(0)), static_cast<std::size_t>(pair(1)));
    for (int c = 0; c < static_cast<int>(paint.count()); ++c)
        if (paint.weights(c) > 0.0) painted.push_back(c);
    const Eigen::Matrix3Xd smooth = painted.empty()
                                        ? Eigen::Matrix3Xd(axis.replicate(1, paint.count()))
                                        : smooth_directions(mesh, painted, paint.directions(Eigen::all, painted));
    CellPaint result = paint;
    const std::size_t piece = pieces.find(static_cast<std::size_t>(cell));
    for (Index c = 0; c < paint.count(); ++c) {
        if (paint.weights(c) > 0.0 || pieces.find(static_cast<std::size_t>(c)) != piece) continue;
        result.weights(c) = 1.0;
        result.directions.col(c) = smooth.col(c);
    }
    return result;
}

}  // namespace myo::fibre
