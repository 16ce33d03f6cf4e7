#include "fibre/fibres_along_line.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "fibre/cell_parts.hpp"
#include "mesh/cell_topology.hpp"

namespace myo::fibre {
namespace {

using Eigen::Vector3d;

struct FibresAlongLinePolicy {
    /// Edge of the smallest parts over the radius. A round wall resolved by parts of edge w encloses 1 + (w/r)^2 / 12
    /// of its volume.
    double finest_part = 1.0 / 6.0;
    /// Maximum number of subdivisions: 2^9 parts along each axis. A tube thinner than a hundredth of a cell is not
    /// resolved further.
    int max_cuts = 9;
};
constexpr FibresAlongLinePolicy fibres_along_line_policy;

/// Share of a part behind a flat wall, from the depth of its centre and its width across the wall. Exact for a brick
/// parallel to the wall.
double share_inside(double depth, double width) {
    return width > 0.0 ? std::clamp(0.5 + depth / width, 0.0, 1.0) : depth > 0.0 ? 1.0 : 0.0;
}

/// Adaptive subdivision of one cell by the distance to the tube's wall.
class TubeInCell {
public:
    TubeInCell(const mesh::VolumeMesh& mesh, int cell, const Polyline& line, double radius_m)
        : mesh_(mesh), cell_(cell), line_(line), radius_(radius_m) {}

    void collect(const CellPart& part) {
        const PartPlace place = place_of(mesh_, cell_, part);
        const BesideLine beside = beside_line(line_, place.centre_m);
        const double depth = depth_in_tube(beside, radius_);
        if (depth <= -place.radius_m) return;
        const bool inside = depth >= place.radius_m;
        if (part.depth == 0 && inside) {
            whole_ = true;
            return;
        }
        // At least two levels, the resolution of a block; then until the part is small compared with the radius.
        const bool fine = part.depth >= 2 &&
                          (inside || std::cbrt(place.volume_m3) <= fibres_along_line_policy.finest_part * radius_);
        if (!fine && part.depth < fibres_along_line_policy.max_cuts) {
            for (const CellPart& child : cut_in_eight(part)) collect(child);
            return;
        }
        // Product of the share inside the round wall and the share inside the end plane.
        const double share = inside ? 1.0
                                    : share_inside(radius_ - beside.distance_m, place.width_m(beside.away)) *
                                          share_inside(beside.inward_m, place.width_m(beside.tangent));
        if (share > 0.0) samples_.push_back({part, share * place.volume_m3, beside.tangent});
    }

    bool whole() const { return whole_; }
    const std::vector<FibreSample>& samples() const { return samples_; }

private:
    const mesh::VolumeMesh& mesh_;
    int cell_;
    const Polyline& line_;
    double radius_;
    bool whole_ = false;
    std::vector<FibreSample> samples_;
};

/// True if the axis intersects the triangle. An edge belongs to the side with positive cross product, so that adjacent
/// triangles do not both count.
bool pierces(const Vector3d& point, const Vector3d& axis, const Vector3d& a, const Vector3d& b, const Vector3d& c) {
    const auto side = [&](const Vector3d& p, const Vector3d& q) {
        return axis.dot((p - point).cross(q - point)) >= 0.0;
    };
    const bool first = side(a, b);
    return first == side(b, c) && first == side(c, a);
}

/// A hexahedron face is tested as two triangles.
bool pierces_cell(const mesh::VolumeMesh& mesh, int cell, const Vector3d& point, const Vector3d& axis) {
    const auto at = [&](int corner) -> Vector3d { return mesh.nodes.col(mesh.cells(corner, cell)); };
    if (mesh.type != mesh::CellType::hex8)
        return std::any_of(mesh::tetrahedron_faces.begin(), mesh::tetrahedron_faces.end(),
                           [&](const auto& f) { return pierces(point, axis, at(f[0]), at(f[1]), at(f[2])); });
    return std::any_of(mesh::hexahedron_faces.begin(), mesh::hexahedron_faces.end(), [&](const auto& f) {
        return pierces(point, axis, at(f[0]), at(f[1]), at(f[2])) || pierces(point, axis, at(f[0]), at(f[2]), at(f[3]));
    });
}

}  // namespace

FibreGroup fibres_along_line(const mesh::VolumeMesh& mesh, const Polyline& line, double radius_m, double stiffness_Pa,
                             std::string name) {
    assert(radius_m > 0.0);
    FibreGroup group{std::move(name), stiffness_Pa, {}, {}};
    for (int c = 0; c < static_cast<int>(mesh.cell_count()); ++c) {
        TubeInCell tube(mesh, c, line, radius_m);
        tube.collect(whole_cell(mesh.type));
        if (tube.whole())
            add_whole_cell(
                mesh, c, 1.0, [&](const Vector3d& x) { return beside_line(line, x).tangent; }, group);
        else
            add_samples(mesh, c, tube.samples(), group);
    }
    return group;
}

FibreGroup fibres_in_column(const mesh::VolumeMesh& mesh, const Vector3d& point_m, const Vector3d& axis,
                            double stiffness_Pa, std::string name) {
    FibreGroup group{std::move(name), stiffness_Pa, {}, {}};
    if (mesh.node_count() == 0) return group;
    // A point exactly between two columns must select one. The shift is smaller than any intended distance.
    const double nudge = 1e-7 * mesh::bounding_box(mesh.nodes).size().maxCoeff();
    const Vector3d across = axis.unitOrthogonal(), other = axis.cross(across);
    const Vector3d point = point_m + nudge * (0.8 * across + 0.37 * other);
    for (int c = 0; c < static_cast<int>(mesh.cell_count()); ++c)
        if (pierces_cell(mesh, c, point, axis))
            add_whole_cell(
                mesh, c, 1.0, [&](const Vector3d&) { return axis; }, group);
    return group;
}

}  // namespace myo::fibre
