#include "mesh/surface_check.hpp"

#include <Eigen/Geometry>

#include "base/text.hpp"
#include "mesh/surface_topology.hpp"

namespace myo::mesh {
namespace {

/// "1 open edge", "3 open edges".
std::string count_text(int n, const std::string& one, const std::string& many) {
    return std::to_string(n).append(" ").append(n == 1 ? one : many);
}

/// One message per defect of the surface.
void add_messages(SurfaceReport& report, int pinched, int turned) {
    auto& messages = report.messages;
    if (report.open_edges > 0) {
        messages.push_back("the surface is not closed: " + count_text(report.open_edges, "open edge", "open edges"));
    }
    if (report.crowded_edges > 0) {
        messages.push_back(
            count_text(report.crowded_edges, "edge is", "edges are").append(" shared by more than two triangles"));
    }
    if (pinched > 0) {
        messages.push_back(count_text(pinched, "vertex joins", "vertices join").append(" parts that share no edge"));
    }
    if (turned > 0) {
        messages.push_back("neighbouring triangles turn opposite ways at " + count_text(turned, "edge", "edges"));
    }
    if (report.closed && report.oriented && !report.outward) messages.push_back("the surface is oriented inward");
    if (report.self_intersections > 0) {
        const auto& [a, b] = report.intersecting_pairs.front();
        messages.push_back("the surface intersects itself: " +
                           count_text(report.self_intersections, "pair", "pairs").append(" of triangles, first ") +
                           std::to_string(a).append(" and ").append(std::to_string(b)));
    }
    if (report.components > 1)
        messages.push_back("the surface has " + count_text(report.components, "part", "parts") +
                           ", as that of a body with a cavity");
    if (const auto size = check_plausible_size(report.size); !size) messages.push_back(size.error().what);
}

}  // namespace

Result<void> check_plausible_size(const Eigen::Vector3d& size) {
    const double extent = size.maxCoeff();
    if (extent > 10.0) {
        return Error{
            "the body is " + format_number(extent, 4) + " m long, over 10 m: the unit is almost certainly wrong", ""};
    }
    if (!(extent >= 1e-3)) {
        return Error{"the body is " + format_number(extent * 1e3, 4) +
                         " mm long, under 1 mm: the unit is almost certainly wrong",
                     ""};
    }
    return {};
}

SurfaceReport check_surface(const SurfaceMesh& surface) {
    SurfaceReport report;
    if (surface.triangles.cols() == 0) {
        report.messages = {"the surface has no triangles"};
        return report;
    }
    const SurfaceTopology topology = surface_topology(surface);
    report.open_edges = topology.open_edges;
    report.crowded_edges = topology.crowded_edges;
    report.closed = topology.closed;
    report.manifold = topology.manifold;
    report.oriented = topology.oriented;
    report.components = topology.parts;
    report.size = bounding_box(surface.vertices).size();
    report.plausible = check_plausible_size(report.size).has_value();
    for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) {
        const Eigen::Vector3d a = surface.vertices.col(surface.triangles(0, t));
        const Eigen::Vector3d b = surface.vertices.col(surface.triangles(1, t));
        const Eigen::Vector3d c = surface.vertices.col(surface.triangles(2, t));
        report.area += 0.5 * (b - a).cross(c - a).norm();
    }
    report.volume = enclosed_volume(surface);
    report.outward = report.closed && report.oriented && report.volume > 0.0;

    // 1e-8 of the diagonal: above rounding in double precision, and TetGen's tolerance for coplanar.
    auto pairs = self_intersections(surface, 1e-8 * report.size.norm());
    report.self_intersections = static_cast<int>(pairs.size());
    pairs.resize(std::min<std::size_t>(pairs.size(), 20));
    report.intersecting_pairs = std::move(pairs);
    add_messages(report, topology.pinched_vertices, topology.turned_edges);
    return report;
}

}  // namespace myo::mesh
