#include "viewport/drawn_surface.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "mesh/box_mesh.hpp"
#include "viewport/color_map.hpp"

// Triangles that draw a body, and the colours of its values.

namespace myo::ui::drawn_surface {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using viewport::DrawnSurface;

const Box box{{0.0, 0.0, 0.0}, {3.0, 2.0, 1.0}};

std::vector<mesh::VolumeMesh> meshes() {
    return {mesh::box_hex_mesh(box, {3, 2, 1}), mesh::tet_box_mesh(box, {3, 2, 1}, mesh::CellType::tet4),
            mesh::tet_box_mesh(box, {3, 2, 1}, mesh::CellType::tet10)};
}

Vector3d corner(const DrawnSurface& surface, const Matrix3Xd& positions, std::size_t triangle, std::size_t k) {
    return positions.col(surface.corners[3 * triangle + k]);
}

TEST(DrawnSurface, CoversTheBodyOnceAndFacesOutwards) {
    for (const mesh::VolumeMesh& mesh : meshes()) {
        const mesh::BoundaryFaces faces = mesh::boundary_faces(mesh);
        const DrawnSurface surface = viewport::drawn_surface(faces);
        EXPECT_TRUE(surface.closed);
        EXPECT_EQ(surface.triangle_count(),
                  static_cast<std::size_t>(surface.triangles_per_face() * static_cast<int>(faces.count())));
        double area = 0.0, volume = 0.0;
        for (std::size_t t = 0; t < surface.triangle_count(); ++t) {
            const Vector3d a = corner(surface, mesh.nodes, t, 0), b = corner(surface, mesh.nodes, t, 1),
                           c = corner(surface, mesh.nodes, t, 2);
            area += 0.5 * (b - a).cross(c - a).norm();
            volume += a.dot(b.cross(c)) / 6.0;  // divergence theorem: positive if outward
        }
        EXPECT_NEAR(area, 2.0 * (6.0 + 3.0 + 2.0), 1e-12) << to_string(mesh.type);
        EXPECT_NEAR(volume, 6.0, 1e-12) << to_string(mesh.type);
    }
}

TEST(DrawnSurface, SidesWithinAFaceLieOppositeCornerOne) {
    for (const mesh::VolumeMesh& mesh : meshes()) {
        const DrawnSurface surface = viewport::drawn_surface(mesh::boundary_faces(mesh));
        const auto per_face = static_cast<std::size_t>(surface.triangles_per_face());
        for (std::size_t first = 0; first < surface.triangle_count(); first += per_face) {
            // A side of two triangles of one face is drawn by neither; all others are edges of the element.
            std::multiset<std::pair<int, int>> of_face;
            const auto side = [&](std::size_t t, std::size_t opposite) {
                return std::pair(std::minmax(surface.corners[3 * t + (opposite + 1) % 3],
                                             surface.corners[3 * t + (opposite + 2) % 3]));
            };
            for (std::size_t t = first; t < first + per_face; ++t)
                for (std::size_t k = 0; k < 3; ++k) of_face.insert(side(t, k));
            for (std::size_t t = first; t < first + per_face; ++t)
                for (std::size_t k = 0; k < 3; ++k) {
                    const bool hidden = per_face > 1 && (k == 1 || t == first + 3);
                    EXPECT_EQ(of_face.count(side(t, k)), hidden ? 2u : 1u) << to_string(mesh.type) << " side " << k;
                }
        }
    }
}

TEST(DrawnSurface, OfATriangulatedBodyIsSeenFromBothSides) {
    const mesh::SurfaceMesh triangles = mesh::box_surface(box);
    const DrawnSurface surface = viewport::drawn_surface(triangles);
    EXPECT_FALSE(surface.closed);
    EXPECT_EQ(surface.triangles_per_face(), 1);
    ASSERT_EQ(surface.triangle_count(), 12u);
    for (Eigen::Index t = 0; t < 12; ++t)
        for (Eigen::Index k = 0; k < 3; ++k)
            EXPECT_EQ(surface.corners[static_cast<std::size_t>(3 * t + k)], triangles.triangles(k, t));
}

TEST(SurfaceVertices, HoldPlaceValueAndTheTintOfTheFace) {
    mesh::BoundaryFaces faces;
    faces.nodes.resize(4, 2);
    faces.nodes << 0, 3, 1, 2, 2, 1, 3, 0;
    const DrawnSurface surface = viewport::drawn_surface(faces);
    Matrix3Xd positions(3, 4);
    positions << 0, 1, 2, 3, 10, 11, 12, 13, 20, 21, 22, 23;
    const Eigen::Vector4d values(0.5, 1.5, 2.5, 3.5);
    Eigen::Matrix4Xf tints(4, 2);
    tints << 1, 5, 2, 6, 3, 7, 4, 8;
    const std::vector<float> data = viewport::surface_vertices(surface, positions, values, tints);
    ASSERT_EQ(data.size(), 12u * viewport::surface_floats);
    for (std::size_t i = 0; i < 12; ++i) {
        const auto node = static_cast<float>(surface.corners[i]), tint = i < 6 ? 1.0f : 5.0f;
        EXPECT_EQ(std::vector<float>(data.begin() + static_cast<std::ptrdiff_t>(8 * i),
                                     data.begin() + static_cast<std::ptrdiff_t>(8 * i + 8)),
                  (std::vector<float>{node, 10.0f + node, 20.0f + node, 0.5f + node, tint, tint + 1.0f, tint + 2.0f,
                                      tint + 3.0f}))
            << i;
    }
    const std::vector<float> plain = viewport::surface_vertices(surface, positions, {}, {});
    ASSERT_EQ(plain.size(), data.size());
    for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_EQ(plain[i], i % 8 < 3 ? data[i] : 0.0f) << i;
}

TEST(ColorMaps, HoldTheirEndsBeyondTheRangeAndStayDrawable) {
    std::vector<std::pair<std::string, Eigen::Vector3f (*)(double)>> maps{{"signed", viewport::diverging_color_map}};
    for (const viewport::ColorMap& map : viewport::color_maps()) maps.emplace_back(map.id, map.color);
    constexpr double infinite = std::numeric_limits<double>::infinity();
    for (const auto& [id, color] : maps) {
        EXPECT_EQ(color(-0.1), color(0.0)) << id;
        EXPECT_EQ(color(-1e300), color(0.0)) << id;
        EXPECT_EQ(color(1.1), color(1.0)) << id;
        EXPECT_EQ(color(1e300), color(1.0)) << id;
        for (const double level : {-infinite, infinite, std::numeric_limits<double>::quiet_NaN()})
            EXPECT_TRUE(color(level).allFinite()) << id;
        for (int i = 0; i <= 200; ++i) {
            const Eigen::Vector3f here = color(i / 200.0);
            EXPECT_GE(here.minCoeff(), 0.0f) << id << " at " << i;
            EXPECT_LE(here.maxCoeff(), 1.0f) << id << " at " << i;
            // Steps would look like edges in the values.
            EXPECT_LT((here - color((i - 1) / 200.0)).norm(), 0.05f) << id << " at " << i;
        }
    }
}

TEST(ColorMaps, OfSignedValuesAreBlueBelowAndRedAbovePale) {
    for (const double distance : {0.2, 0.35, 0.5}) {
        const Eigen::Vector3f below = viewport::diverging_color_map(0.5 - distance),
                              above = viewport::diverging_color_map(0.5 + distance);
        EXPECT_GT(below[2], below[0] + 0.2f) << distance;
        EXPECT_GT(above[0], above[2] + 0.2f) << distance;
    }
    const Eigen::Vector3f middle = viewport::diverging_color_map(0.5);
    EXPECT_LT(middle.maxCoeff() - middle.minCoeff(), 0.02f) << "without a hue";
    EXPECT_GT(middle.minCoeff(), 0.85f);
    EXPECT_LT((middle - viewport::diverging_color_map(std::nextafter(0.5, 0.0))).norm(), 1e-4f) << "the arms meet";
}

TEST(ColorMaps, AreFoundByTheirIdsAndUnknownOnesAreTheFirst) {
    std::set<std::string> ids;
    for (std::size_t i = 0; i < viewport::color_maps().size(); ++i) {
        const std::string& id = viewport::color_maps()[i].id;
        EXPECT_EQ(viewport::number_of_color_map(id), static_cast<int>(i));
        ids.insert(id);
    }
    EXPECT_EQ(ids.size(), viewport::color_maps().size());
    for (const char* unknown : {"", "rainbow", "Grey"}) EXPECT_EQ(viewport::number_of_color_map(unknown), 0) << unknown;
    const Eigen::Vector3f grey = viewport::color_maps()[2].color(0.4);
    EXPECT_LT(grey.maxCoeff() - grey.minCoeff(), 0.01f) << "for print";
}

}  // namespace
}  // namespace myo::ui::drawn_surface
