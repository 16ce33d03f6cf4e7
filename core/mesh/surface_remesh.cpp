#include "mesh/surface_remesh.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>

#include "base/text.hpp"
#include "mesh/quality.hpp"
#include "mesh/surface_check.hpp"
#include "mesh/surface_distance.hpp"
#include "mesh/surface_features.hpp"
#include "mesh/surface_topology.hpp"

namespace myo::mesh {
namespace {

/// Length with two digits for notes.
std::string millimetres(double metres) { return format_number(1e3 * metres, 2) + " mm"; }

/// A count to two digits: "20000".
std::string about(double count) {
    const double unit = std::pow(10.0, std::max(0.0, std::floor(std::log10(std::max(count, 1.0))) - 1.0));
    return std::to_string(static_cast<long long>(unit * std::round(count / unit)));
}

/// Mean shortest side of the triangles [m], weighted by area: what TetGen's cells at the surface follow.
double mean_shortest_side(const SurfaceMesh& surface) {
    double sum = 0.0, whole = 0.0;
    for (const auto& t : surface.triangles.colwise()) {
        const Eigen::Matrix3d X = surface.vertices(Eigen::all, t);
        const Eigen::Vector3d a = X.col(1) - X.col(0), b = X.col(2) - X.col(1), c = X.col(0) - X.col(2);
        const double area = 0.5 * a.cross(b).norm();
        sum += area * std::min({a.norm(), b.norm(), c.norm()});
        whole += area;
    }
    return whole > 0.0 ? sum / whole : 0.0;
}

/// Moves vertices off the feature lines along their normals by the mean distance that the middles of their edges have
/// lost. The middles' mean is that of the triangles, exact for quadratic distances.
void shift_to_volume(RemeshedSurface& remeshed, const SurfaceDistance& original, double negligible) {
    SurfaceMesh& surface = remeshed.surface;
    const Eigen::Index count = surface.vertices.cols();
    std::vector<bool> held(static_cast<std::size_t>(count), false);
    for (const auto& [a, b] : remeshed.features.edges)
        held[static_cast<std::size_t>(a)] = held[static_cast<std::size_t>(b)] = true;
    // Normals at the vertices, weighted by the areas of their triangles.
    Eigen::Matrix3Xd normals = Eigen::Matrix3Xd::Zero(3, count);
    for (const auto& t : surface.triangles.colwise()) {
        const Eigen::Matrix3d X = surface.vertices(Eigen::all, t);
        const Eigen::Vector3d n = (X.col(1) - X.col(0)).cross(X.col(2) - X.col(0));
        for (const int v : t) normals.col(v) += n;
    }
    normals.colwise().normalize();
    Eigen::VectorXd lost = Eigen::VectorXd::Zero(count), edges = Eigen::VectorXd::Zero(count);
    for (const auto& t : surface.triangles.colwise())
        for (int i = 0; i < 3; ++i) {
            const int a = t[i], b = t[(i + 1) % 3];
            // Each edge once: it belongs to two triangles, which run along it in opposite directions.
            if (a > b) continue;
            const Eigen::Vector3d middle = 0.5 * (surface.vertices.col(a) + surface.vertices.col(b));
            const Eigen::Vector3d away = original.nearest(middle).point - middle;
            const double distance = away.dot((normals.col(a) + normals.col(b)).normalized());
            for (const int v : {a, b}) lost[v] += distance, edges[v] += 1.0;
        }
    for (Eigen::Index v = 0; v < count; ++v) {
        if (held[static_cast<std::size_t>(v)] || !(edges[v] > 0.0)) continue;
        const double shift = lost[v] / edges[v];
        if (std::abs(shift) > negligible) surface.vertices.col(v) += shift * normals.col(v);
    }
}

/// Puts vertices that rounding has moved off an axis-aligned face back into its plane: boxes of clamps and grids
/// compare coordinates.
void snap_to_aligned_faces(SurfaceMesh& surface, const SurfaceMesh& original, const SurfaceDistance& distance,
                           double negligible) {
    for (Eigen::Index v = 0; v < surface.vertices.cols(); ++v) {
        const int nearest = distance.nearest(surface.vertices.col(v)).triangle;
        const Eigen::Matrix3d X = original.vertices(Eigen::all, original.triangles.col(nearest));
        for (int a = 0; a < 3; ++a)
            if (X(a, 0) == X(a, 1) && X(a, 1) == X(a, 2) && std::abs(surface.vertices(a, v) - X(a, 0)) < negligible)
                surface.vertices(a, v) = X(a, 0);
    }
}

/// Surface that cells can be made of, with the parts of the original.
bool is_sound(const SurfaceMesh& surface, int parts) {
    if (surface.triangles.cols() == 0 || !surface.vertices.allFinite()) return false;
    const SurfaceReport report = check_surface(surface);
    return report.meshable() && report.oriented && report.components == parts;
}

/// The surface remeshed to one size; empty if it is not sound.
std::optional<SizedSurface> remeshed_to(double size, const SurfaceMesh& original, const FeatureLines& features,
                                        const SurfaceDistance& distance, int parts) {
    std::optional<RemeshedSurface> remeshed = isotropic_remesh(original, features, size, remesh_policy.iterations);
    if (!remeshed) return std::nullopt;
    // Rounding of coordinates, as in check_surface().
    const double negligible = 1e-8 * bounding_box(original.vertices).size().norm();
    for (int i = 0; i < remesh_policy.shifts; ++i) shift_to_volume(*remeshed, distance, negligible);
    SizedSurface result{std::move(remeshed->surface), true, size};
    snap_to_aligned_faces(result.surface, original, distance, negligible);
    if (!is_sound(result.surface, parts)) return std::nullopt;
    const double volume = enclosed_volume(original);
    result.volume_change = enclosed_volume(result.surface) / volume - 1.0;
    result.deviation_m = std::max(distance.largest_from(result.surface),
                                  SurfaceDistance(result.surface).largest_from(original));
    return result;
}

/// Note on a surface that was remeshed: from and to how many triangles, and how far off.
std::string change_of(const SizedSurface& sized, double edge, Eigen::Index triangles) {
    std::string text = "the surface's " + std::to_string(triangles) + " triangles are finer than cells of " +
                       millimetres(edge) + ": it was remeshed to " + std::to_string(sized.surface.triangles.cols()) +
                       " triangles with edges of " + millimetres(sized.edge_m);
    // A body of flat faces does not change at all.
    if (sized.deviation_m < 1e-6 * edge) return text + ", which lie on it";
    return text + ", at most " + millimetres(sized.deviation_m) + " off; its volume changed by " +
           format_number(100.0 * sized.volume_change, 2) + " %";
}

/// Note on the number of cells that will come; empty if it is not many more than asked for.
std::optional<std::string> kept_as_it_is(const SurfaceMesh& surface, double edge, double deviation) {
    const double cells = remesh_policy.cells_per_triangle * static_cast<double>(surface.triangles.cols());
    const double asked = estimate_counts(surface, CellType::tet10, edge).cells;
    if (cells < remesh_policy.told_growth * asked) return std::nullopt;
    return "the surface's " + std::to_string(surface.triangles.cols()) +
           " triangles fix the size of the cells: about " + about(cells) + " tetrahedra come instead of the " +
           about(asked) + " of " + millimetres(edge) + " asked for, because it cannot be remeshed within " +
           millimetres(deviation) + "; reduce its triangles in the program that drew it, or choose hexahedra";
}

}  // namespace

SizedSurface sized_surface(const SurfaceMesh& surface, double edge, double most_deviation, const Progress& progress) {
    SizedSurface unchanged{surface};
    const double finest = mean_shortest_side(surface);
    if (!(edge > remesh_policy.finer * finest)) return unchanged;
    const SurfaceTopology topology = surface_topology(surface);
    // The mesher says what is wrong with a broken surface.
    if (!topology.closed || !topology.manifold || !topology.oriented) return unchanged;
    if (!self_intersections(surface, 1e-8 * bounding_box(surface.vertices).size().norm()).empty()) return unchanged;
    const double allowed = std::min(remesh_policy.max_deviation * edge, most_deviation);
    const SurfaceDistance distance(surface);
    // From long edges to short ones: the first size within the deviation gives the fewest cells.
    double size = remesh_policy.first_size * edge;
    for (int i = 0; i < remesh_policy.sizes && size > finest && !progress.cancelled();
         ++i, size *= remesh_policy.size_step) {
        progress.report({"coarser surface", double(i), double(remesh_policy.sizes), "sizes", ""});
        std::optional<SizedSurface> found = remeshed_to(
            size, surface, feature_lines(surface, size, remesh_policy.line_share * allowed), distance, topology.parts);
        if (!found || found->deviation_m > allowed || std::abs(found->volume_change) > remesh_policy.max_volume_change)
            continue;
        // Smaller sizes would have even more triangles.
        if (static_cast<double>(found->surface.triangles.cols()) >
            remesh_policy.worth * static_cast<double>(surface.triangles.cols()))
            break;
        found->notes.push_back(change_of(*found, edge, surface.triangles.cols()));
        return *found;
    }
    if (progress.cancelled()) return unchanged;
    if (const auto note = kept_as_it_is(surface, edge, allowed)) unchanged.notes.push_back(*note);
    return unchanged;
}

}  // namespace myo::mesh
