#include "mesh/region_facets.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "mesh/contour_fill.hpp"
#include "mesh/plane_cut.hpp"
#include "mesh/short_edges.hpp"
#include "mesh/winding_number.hpp"

namespace myo::mesh {
namespace {

using DirectedEdges = std::vector<std::pair<int, int>>;

// Tolerances in units of the cells' edge length.
struct FacetTolerances {
    double bounds = 0.1;   // plane and the body's bounds; as for the planes of a hexahedral grid
    double vertex = 0.01;  // plane and vertex; also the largest displacement of the surface
    double volume = 3e-3;  // relative change of the body's volume that is rejected
};
constexpr FacetTolerances tolerances;

/// Whether two boxes have a common volume; touching is not enough.
bool overlaps(const Box& a, const Box& b) {
    return (a.lowest.array() < b.highest.array()).all() && (b.lowest.array() < a.highest.array()).all();
}

/// Face planes of the regions that cut the body, without those near its bounds and without duplicates.
GridPlanes cutting_planes(const std::vector<Box>& regions, const Box& bounds, double edge) {
    GridPlanes planes;
    // Planes closer than this are one plane, as in grid_lines().
    const double same = 1e-6 * bounds.size().maxCoeff();
    for (const Box& region : regions) {
        if (!overlaps(region, bounds)) continue;
        for (std::size_t a = 0; a < 3; ++a) {
            const auto i = static_cast<Eigen::Index>(a);
            for (const double p : {region.lowest(i), region.highest(i)}) {
                const bool inside = p > bounds.lowest(i) + tolerances.bounds * edge &&
                                    p < bounds.highest(i) - tolerances.bounds * edge;
                const bool known = std::any_of(planes[a].begin(), planes[a].end(),
                                               [&](double q) { return std::abs(p - q) < same; });
                if (inside && !known) planes[a].push_back(p);
            }
        }
    }
    for (std::vector<double>& list : planes) std::sort(list.begin(), list.end());
    return planes;
}

// Range in which the surface is cut: the hull of all regions, unbounded where they end at the body's bounds.
Box cut_range(const std::vector<Box>& regions, const Box& bounds, double edge) {
    // A side that is not cut selects the whole end of the body, however the surface bulges there.
    const double near = tolerances.bounds * edge, far = std::numeric_limits<double>::infinity();
    Box all = regions.front();
    for (const Box& region : regions) {
        all.lowest = all.lowest.cwiseMin(region.lowest);
        all.highest = all.highest.cwiseMax(region.highest);
    }
    for (int a = 0; a < 3; ++a) {
        if (all.lowest(a) <= bounds.lowest(a) + near) all.lowest(a) = -far;
        if (all.highest(a) >= bounds.highest(a) - near) all.highest(a) = far;
    }
    return all;
}

/// Rectangle of a plane between neighbouring planes of the two other axes, unbounded beyond the last plane.
struct PlaneCell {
    std::array<double, 2> lowest, highest;  // along the two axes after the plane's axis
};

// Triangulates the sections of a cut body. Each plane is divided by the planes of the other axes and filled rectangle
// by rectangle, so that sections in different planes share complete edges.
class SectionFiller {
public:
    SectionFiller(SurfaceMesh surface, const GridPlanes& planes, const std::vector<Box>& regions)
        : surface_(std::move(surface)),
          body_(surface_),
          bounds_(bounding_box(surface_.vertices)),
          planes_(planes),
          regions_(regions) {
        for (Eigen::Index t = 0; t < body_.triangles.cols(); ++t)
            for (int i = 0; i < 3; ++i)
                sides_.insert(std::minmax(body_.triangles(i, t), body_.triangles((i + 1) % 3, t)));
    }

    /// Triangles of all sections.
    Result<RegionFacets> filled() {
        std::vector<std::array<int, 3>> all;
        for (int axis = 0; axis < 3; ++axis)
            for (const double at : planes_[static_cast<std::size_t>(axis)]) {
                const DirectedEdges contours = section_contours({axis, at});
                // Each rectangle is filled on its own, so that all rectangles agree on their common sides.
                for (const PlaneCell& cell : wanted_cells({axis, at})) {
                    const DirectedEdges edges = cell_contours({axis, at}, cell, contours);
                    const auto triangles = fill_contours(surface_.vertices, edges, Eigen::Vector3d::Unit(axis));
                    if (!triangles) return triangles.error();
                    all.insert(all.end(), triangles->begin(), triangles->end());
                }
            }
        RegionFacets facets{surface_, {}};
        facets.inner.resize(3, static_cast<Eigen::Index>(all.size()));
        for (std::size_t t = 0; t < all.size(); ++t)
            facets.inner.col(static_cast<Eigen::Index>(t)) << all[t][0], all[t][1], all[t][2];
        return facets;
    }

private:
    // Boundary of the section with material on both sides, interior on the left. Below the plane the body is bounded by
    // its triangles and by the section; where the body ends at the plane, upward-facing triangles replace the section.
    // The boundary of the section is therefore the reverse of the edges of all these.
    DirectedEdges section_contours(const AxisPlane& plane) const {
        std::map<std::pair<int, int>, int> count;
        for (Eigen::Index t = 0; t < body_.triangles.cols(); ++t) {
            const Eigen::Vector3i v = body_.triangles.col(t);
            const auto height = [&](int i) { return body_.vertices(plane.axis, v[i]) - plane.at; };
            // Exact zeros: cutting has set the coordinate of the plane on all vertices of it.
            const bool flat = height(0) == 0.0 && height(1) == 0.0 && height(2) == 0.0;
            if (std::max({height(0), height(1), height(2)}) > 0.0 || (flat && !faces_up(v, plane.axis))) continue;
            for (int i = 0; i < 3; ++i) {
                const int j = (i + 1) % 3;
                if (height(i) != 0.0 || height(j) != 0.0) continue;
                int& opposite = count[{v[i], v[j]}];
                // Edges used in both directions cancel; what remains is the boundary.
                if (opposite > 0)
                    --opposite;
                else
                    ++count[{v[j], v[i]}];
            }
        }
        DirectedEdges contours;
        for (const auto& [edge, times] : count)
            if (times > 0) contours.push_back(edge);
        return contours;
    }

    /// True if a triangle in a plane faces the positive axis.
    bool faces_up(const Eigen::Vector3i& v, int axis) const {
        const int b = (axis + 1) % 3, c = (axis + 2) % 3;
        const auto x = [&](int i, int a) { return body_.vertices(a, v[i]) - body_.vertices(a, v[0]); };
        return x(1, b) * x(2, c) - x(1, c) * x(2, b) > 0.0;
    }

    // Rectangles of the plane that belong to a face of a region.
    std::vector<PlaneCell> wanted_cells(const AxisPlane& plane) const {
        const std::vector<double> first = stops((plane.axis + 1) % 3), second = stops((plane.axis + 2) % 3);
        std::vector<PlaneCell> cells;
        for (std::size_t i = 0; i + 1 < first.size(); ++i)
            for (std::size_t j = 0; j + 1 < second.size(); ++j) {
                const PlaneCell cell{{first[i], second[j]}, {first[i + 1], second[j + 1]}};
                if (std::any_of(regions_.begin(), regions_.end(),
                                [&](const Box& r) { return is_face_part(r, plane, cell); }))
                    cells.push_back(cell);
            }
        return cells;
    }

    /// Planes of an axis with infinite ends.
    std::vector<double> stops(int axis) const {
        std::vector<double> list = planes_[static_cast<std::size_t>(axis)];
        list.insert(list.begin(), -std::numeric_limits<double>::infinity());
        list.push_back(std::numeric_limits<double>::infinity());
        return list;
    }

    /// True if a rectangle lies in a face of the region.
    bool is_face_part(const Box& region, const AxisPlane& plane, const PlaneCell& cell) const {
        const double same = 1e-6 * bounds_.size().maxCoeff();
        if (std::abs(region.lowest(plane.axis) - plane.at) > same &&
            std::abs(region.highest(plane.axis) - plane.at) > same)
            return false;
        for (std::size_t k = 0; k < 2; ++k) {
            const int a = (plane.axis + 1 + static_cast<int>(k)) % 3;
            // Unbounded rectangles are limited to the body before their centre is tested.
            const double middle = 0.5 * (std::max(cell.lowest[k], bounds_.lowest(a)) +
                                         std::min(cell.highest[k], bounds_.highest(a)));
            if (middle < region.lowest(a) || middle > region.highest(a)) return false;
        }
        return true;
    }

    // Boundary of the section inside a rectangle, plus the rectangle's own sides inside the body.
    DirectedEdges cell_contours(const AxisPlane& plane, const PlaneCell& cell, const DirectedEdges& contours) {
        DirectedEdges edges;
        for (const auto& edge : contours)
            if (lies_in(plane.axis, cell, edge)) edges.push_back(edge);
        const int b = (plane.axis + 1) % 3, c = (plane.axis + 2) % 3;
        // The four sides in the direction that keeps the rectangle on the left.
        add_side(plane, {b, cell.lowest[0]}, c, cell.lowest[1], cell.highest[1], false, edges);
        add_side(plane, {b, cell.highest[0]}, c, cell.lowest[1], cell.highest[1], true, edges);
        add_side(plane, {c, cell.lowest[1]}, b, cell.lowest[0], cell.highest[0], true, edges);
        add_side(plane, {c, cell.highest[1]}, b, cell.lowest[0], cell.highest[0], false, edges);
        return edges;
    }

    // An edge on a side of the rectangle belongs to the rectangle on its left.
    bool lies_in(int axis, const PlaneCell& cell, const std::pair<int, int>& edge) const {
        for (std::size_t k = 0; k < 2; ++k) {
            const int own = (axis + 1 + static_cast<int>(k)) % 3, other = (axis + 2 - static_cast<int>(k)) % 3;
            const double from = surface_.vertices(own, edge.first), to = surface_.vertices(own, edge.second);
            if (from == to && (from == cell.lowest[k] || from == cell.highest[k])) {
                // Left of a motion along the second axis are lower values of the first, and vice versa.
                const bool forward = surface_.vertices(other, edge.second) > surface_.vertices(other, edge.first);
                const bool left_is_lower = (k == 0) == forward;
                if (left_is_lower != (from == cell.highest[k])) return false;
                continue;
            }
            const double middle = 0.5 * (from + to);
            if (middle < cell.lowest[k] || middle > cell.highest[k]) return false;
        }
        return true;
    }

    // Parts inside the body of the intersection line of two planes, from `low` to `high` along the third axis.
    void add_side(const AxisPlane& plane, const AxisPlane& side, int along, double low, double high, bool ascending,
                  DirectedEdges& edges) {
        if (!std::isfinite(side.at)) return;
        std::vector<std::pair<double, int>> points;
        for (Eigen::Index v = 0; v < body_.vertices.cols(); ++v) {
            const double x = body_.vertices(along, v);
            if (body_.vertices(plane.axis, v) == plane.at && body_.vertices(side.axis, v) == side.at && x >= low &&
                x <= high)
                points.emplace_back(x, static_cast<int>(v));
        }
        // Corners of the rectangle inside the body are not vertices of the surface and must be added.
        for (const double end : {low, high})
            if (std::isfinite(end) &&
                std::none_of(points.begin(), points.end(), [&](const auto& p) { return p.first == end; }))
                if (const std::optional<int> corner = inner_corner(plane, side, {along, end}))
                    points.emplace_back(end, *corner);
        std::sort(points.begin(), points.end());
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const int from = points[i].second, to = points[i + 1].second;
            // An edge on the surface is already among the section's contours.
            if (sides_.contains(std::minmax(from, to)) ||
                !is_inside(0.5 * (surface_.vertices.col(from) + surface_.vertices.col(to))))
                continue;
            if (ascending)
                edges.emplace_back(from, to);
            else
                edges.emplace_back(to, from);
        }
    }

    // Vertex at the intersection of three planes inside the body; created on first use.
    std::optional<int> inner_corner(const AxisPlane& a, const AxisPlane& b, const AxisPlane& c) {
        Eigen::Vector3d x;
        for (const AxisPlane& plane : {a, b, c}) x[plane.axis] = plane.at;
        for (Eigen::Index v = body_.vertices.cols(); v < surface_.vertices.cols(); ++v)
            if (surface_.vertices.col(v) == x) return static_cast<int>(v);
        if (!is_inside(x)) return std::nullopt;
        surface_.vertices.conservativeResize(3, surface_.vertices.cols() + 1);
        surface_.vertices.rightCols<1>() = x;
        return static_cast<int>(surface_.vertices.cols() - 1);
    }

    /// Inside test by the winding number.
    bool is_inside(const Eigen::Vector3d& x) const { return winding_number(body_, x) > 0.5; }

    SurfaceMesh surface_;  // vertices of the body plus corners inside of it
    SurfaceMesh body_;
    Box bounds_;
    std::set<std::pair<int, int>> sides_;  // edges of the body's triangles, lower vertex first
    const GridPlanes& planes_;
    const std::vector<Box>& regions_;
};

}  // namespace

bool cut_by_regions(const Box& bounds, const std::vector<Box>& regions, double edge) {
    const GridPlanes planes = cutting_planes(regions, bounds, edge);
    return std::any_of(planes.begin(), planes.end(), [](const std::vector<double>& list) { return !list.empty(); });
}

Result<RegionFacets> region_facets(const SurfaceMesh& surface, const std::vector<Box>& regions, double edge) {
    const Box bounds = bounding_box(surface.vertices);
    if (!cut_by_regions(bounds, regions, edge)) return RegionFacets{surface, {}};
    const GridPlanes planes = cutting_planes(regions, bounds, edge);
    SurfaceMesh cut = surface;
    for (int axis = 0; axis < 3; ++axis)
        for (const double at : planes[static_cast<std::size_t>(axis)]) {
            // Snapping before cutting avoids slivers at vertices that almost lie on the plane.
            cut = snapped_to_plane(std::move(cut), {axis, at}, tolerances.vertex * edge);
            cut = cut_by_plane(cut, {axis, at}, cut_range(regions, bounds, edge));
        }
    // Cuts close to each other, or to an edge of the surface, leave edges much shorter than the cells.
    cut = without_short_edges(cut, planes, edge, tolerances.vertex * edge);
    // The volume is the check that snapping and collapsing did not change the shape.
    const double volume = enclosed_volume(surface);
    if (!(std::abs(enclosed_volume(cut) - volume) <= tolerances.volume * volume))
        return Error{"cutting the surface would change its shape", ""};
    return SectionFiller(std::move(cut), planes, regions).filled();
}

}  // namespace myo::mesh
