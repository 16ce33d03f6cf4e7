#include "validation/synthetic_body.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/name_table.hpp"

namespace myo::validation {
namespace {

using Eigen::Vector3d;

constexpr NameTable<BodyFamily, 5> family_names{{{
    {BodyFamily::beam, "beam"},
    {BodyFamily::plate, "plate"},
    {BodyFamily::ell, "ell"},
    {BodyFamily::tail, "tail"},
    {BodyFamily::threaded, "threaded"},
}}};

/// Lengths as a person writes them: whole tenths of a millimetre.
double rounded_to_tenths_of_mm(double length_m) { return 1e-4 * std::round(1e4 * length_m); }

/// L in the x-z plane, extruded by `width` along y: legs of thickness `thick`, the second rising from the end of the
/// first. The side faces share all vertices on common edges, so the surface is closed.
mesh::SurfaceMesh ell_surface(double length, double height, double thick, double width) {
    const double knee = length - thick;
    const std::vector<Eigen::Vector2d> outline = {{0, 0},           {knee, 0},      {length, 0},   {length, thick},
                                                  {length, height}, {knee, height}, {knee, thick}, {0, thick}};
    // First leg, knee, second leg; counterclockwise in the outline.
    const int quads[3][4] = {{0, 1, 6, 7}, {1, 2, 3, 6}, {6, 3, 4, 5}};
    const int n = static_cast<int>(outline.size());
    mesh::SurfaceMesh surface;
    surface.vertices.resize(3, 2 * n);
    for (int i = 0; i < n; ++i) {
        const Eigen::Vector2d& p = outline[static_cast<std::size_t>(i)];
        surface.vertices.col(i) = Vector3d(p.x(), 0.0, p.y());
        surface.vertices.col(n + i) = Vector3d(p.x(), width, p.y());
    }
    std::vector<Eigen::Vector3i> triangles;
    // Counterclockwise in x-z seen from -y: outward on the side y = 0.
    for (const auto& q : quads)
        for (const auto& t : {Eigen::Vector3i(q[0], q[1], q[2]), Eigen::Vector3i(q[0], q[2], q[3])}) {
            triangles.push_back(t);
            triangles.emplace_back(n + t(0), n + t(2), n + t(1));
        }
    for (int i = 0; i < n; ++i) {
        const int j = (i + 1) % n;
        triangles.emplace_back(i, n + i, j);
        triangles.emplace_back(j, n + i, n + j);
    }
    surface.triangles.resize(3, static_cast<Eigen::Index>(triangles.size()));
    for (std::size_t t = 0; t < triangles.size(); ++t)
        surface.triangles.col(static_cast<Eigen::Index>(t)) = triangles[t];
    return surface;
}

/// Corner i of a triangle [m].
Vector3d corner(const mesh::SurfaceMesh& surface, Eigen::Index triangle, int i) {
    return surface.vertices.col(surface.triangles(i, triangle));
}

/// Area of a triangle [m2].
double area(const mesh::SurfaceMesh& surface, Eigen::Index t) {
    return 0.5 *
           (corner(surface, t, 1) - corner(surface, t, 0)).cross(corner(surface, t, 2) - corner(surface, t, 0)).norm();
}

/// Uniform point on the surface: triangle by area, then barycentric coordinates with a root for uniformity.
Vector3d surface_point(const mesh::SurfaceMesh& surface, RandomStream& random) {
    double total = 0.0;
    for (Eigen::Index t = 0; t < surface.triangles.cols(); ++t) total += area(surface, t);
    double left = random.uniform(0.0, total);
    Eigen::Index t = 0;
    while (t + 1 < surface.triangles.cols() && left > area(surface, t)) left -= area(surface, t++);
    const double root = std::sqrt(random.uniform(0.0, 1.0)), v = random.uniform(0.0, 1.0);
    return (1.0 - root) * corner(surface, t, 0) + root * (1.0 - v) * corner(surface, t, 1) +
           root * v * corner(surface, t, 2);
}

}  // namespace

std::string to_string(BodyFamily family) { return family_names.name(family); }
std::vector<std::string> body_family_ids() { return family_names.names(); }
bool parse_body_family(const std::string& id, BodyFamily& family) { return family_names.find(id, family); }

Vector3d SyntheticBody::tapered(const Vector3d& point) const {
    const double s = std::clamp(point.x() / length_m(), 0.0, 1.0);
    return {point.x(), point.y() * (1.0 + (taper_y - 1.0) * s), point.z() * (1.0 + (taper_z - 1.0) * s)};
}

SyntheticBody drawn_body(BodyFamily family, bool deep_clamp, RandomStream& random) {
    SyntheticBody body;
    body.family = family;
    body.metres_per_unit = random.chance(0.5) ? 1.0 : 1e-3;
    const double length = rounded_to_tenths_of_mm(random.uniform(0.08, 0.13));
    // Proportions of each family, over the length.
    double width = 0.0, height = 0.0;
    switch (family) {
        case BodyFamily::beam:
        case BodyFamily::threaded:
            width = rounded_to_tenths_of_mm(length * random.uniform(0.22, 0.36));
            height = body.thickness_m = rounded_to_tenths_of_mm(length * random.uniform(0.2, 0.32));
            break;
        case BodyFamily::plate:
            width = rounded_to_tenths_of_mm(length * random.uniform(0.5, 0.75));
            height = body.thickness_m = rounded_to_tenths_of_mm(length * random.uniform(0.11, 0.16));
            break;
        case BodyFamily::ell:
            width = rounded_to_tenths_of_mm(length * random.uniform(0.2, 0.32));
            body.thickness_m = rounded_to_tenths_of_mm(length * random.uniform(0.2, 0.28));
            height = rounded_to_tenths_of_mm(length * random.uniform(0.5, 0.75));
            break;
        case BodyFamily::tail:
            width = rounded_to_tenths_of_mm(length * random.uniform(0.24, 0.34));
            height = body.thickness_m = rounded_to_tenths_of_mm(length * random.uniform(0.28, 0.38));
            body.taper_y = random.uniform(0.5, 0.85);
            body.taper_z = random.uniform(0.5, 0.85);
            break;
    }
    if (family == BodyFamily::ell)
        body.surface = ell_surface(length, height, body.thickness_m, width);
    else if (family == BodyFamily::tail)
        body.surface = mesh::box_surface({{0.0, -0.5 * width, -0.5 * height}, {length, 0.5 * width, 0.5 * height}});
    else
        body.surface = mesh::box_surface({Vector3d::Zero(), {length, width, height}});
    body.bounds = mesh::bounding_box(body.surface.vertices);
    if (family == BodyFamily::tail)
        for (Eigen::Index i = 0; i < body.surface.vertices.cols(); ++i)
            body.surface.vertices.col(i) = body.tapered(body.surface.vertices.col(i));
    if (deep_clamp) body.held_m = rounded_to_tenths_of_mm(length * random.uniform(0.15, 0.25));
    // Boxes extend beyond the body, so that rounding does not exclude nodes of a face.
    const double beyond = 1e-3, face = 5e-4;
    body.clamp = {body.bounds.lowest - Vector3d::Constant(beyond), body.bounds.highest + Vector3d::Constant(beyond)};
    body.end = body.clamp;
    body.clamp.lowest(0) = -face;
    body.clamp.highest(0) = deep_clamp ? body.held_m : face;
    body.end.lowest(0) = length - face;
    body.end.highest(0) = length + face;
    // The L is loaded on top of its second leg.
    if (family == BodyFamily::ell) {
        body.end = {body.bounds.lowest - Vector3d::Constant(beyond), body.bounds.highest + Vector3d::Constant(beyond)};
        body.end.lowest(2) = height - face;
    }
    return body;
}

std::vector<Vector3d> drawn_markers(const SyntheticBody& body, int count, RandomStream& random) {
    std::vector<Vector3d> markers;
    double apart = 0.15 * body.length_m();
    for (int tries = 0; static_cast<int>(markers.size()) < count; ++tries) {
        // The required distance shrinks if the markers do not fit.
        if (tries % 200 == 199) apart *= 0.7;
        const Vector3d point = surface_point(body.surface, random);
        const double from_clamp = (point.x() - body.held_m) / (body.length_m() - body.held_m);
        // The first two markers are close to the end, where the motion is largest.
        if (from_clamp < (markers.size() < 2 ? 0.8 : 0.12)) continue;
        if (std::any_of(markers.begin(), markers.end(),
                        [&](const Vector3d& other) { return (other - point).norm() < apart; }))
            continue;
        markers.push_back(point);
    }
    return markers;
}

std::string stl_text(const SyntheticBody& body) {
    std::string text = "solid body\n";
    char line[160];
    for (Eigen::Index t = 0; t < body.surface.triangles.cols(); ++t) {
        const Vector3d normal = (corner(body.surface, t, 1) - corner(body.surface, t, 0))
                                    .cross(corner(body.surface, t, 2) - corner(body.surface, t, 0))
                                    .normalized();
        std::snprintf(line, sizeof line, " facet normal %.9g %.9g %.9g\n  outer loop\n", normal.x(), normal.y(),
                      normal.z());
        text += line;
        for (int i = 0; i < 3; ++i) {
            const Vector3d p = corner(body.surface, t, i) / body.metres_per_unit;
            std::snprintf(line, sizeof line, "   vertex %.12g %.12g %.12g\n", p.x(), p.y(), p.z());
            text += line;
        }
        text += "  endloop\n endfacet\n";
    }
    return text + "endsolid body\n";
}

}  // namespace myo::validation
