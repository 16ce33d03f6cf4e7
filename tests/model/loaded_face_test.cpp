#include "model/loaded_face.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <vector>

#include "model/elastic_bed.hpp"
#include "model/force_of.hpp"
#include "model/held_nodes.hpp"
#include "model/surface_drag.hpp"
#include "support/beam.hpp"

namespace myo::model::loaded_face_tests {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr fem::ElementKind kinds[] = {fem::ElementKind::hex8, fem::ElementKind::tet4, fem::ElementKind::tet10};

test::BeamSpec brick(fem::ElementKind kind, bool clamped = true) {
    test::BeamSpec spec;
    spec.kind = kind;
    spec.cells = {3, 2, 2};
    spec.size = {0.06, 0.03, 0.02};
    spec.clamped = clamped;
    return spec;
}
double surface_m2(const test::BeamSpec& spec) {
    const Vector3d& s = spec.size;
    return 2.0 * (s(0) * s(1) + s(1) * s(2) + s(2) * s(0));
}
double area_of(const Body& body, const std::vector<int>& faces) {
    double sum = 0.0;
    for (const SampledFace& face : sampled_faces(body, faces))
        for (const SampledPoint& point : face.points) sum += point.area;
    return sum;
}
/// Faces of the side z = 0.
std::vector<int> lower_faces(const Body& body) {
    std::vector<int> nodes;
    for (int i = 0; i < body.node_count(); ++i)
        if (body.mesh.nodes(2, i) < 1e-9) nodes.push_back(i);
    return faces_of_nodes(body, nodes);
}

TEST(LoadedFaces, KnowTheirNodesInTheCellBehind) {
    for (const fem::ElementKind kind : kinds) {
        const BodyPointer body = test::make_beam(brick(kind)).body;
        const std::vector<int> faces = free_faces(*body);
        const std::vector<LoadedFace> loaded = loaded_faces(*body, faces);
        ASSERT_EQ(loaded.size(), faces.size());
        for (std::size_t f = 0; f < faces.size(); ++f) {
            const auto nodes = body->boundary.nodes.col(faces[f]);
            EXPECT_EQ(loaded[f].nodes, std::vector<int>(nodes.begin(), nodes.end()));
            ASSERT_EQ(loaded[f].cell_node.size(), loaded[f].nodes.size());
            for (std::size_t a = 0; a < loaded[f].nodes.size(); ++a)
                EXPECT_EQ(body->mesh.cells(loaded[f].cell_node[a], loaded[f].cell), loaded[f].nodes[a]);
        }
        const int last = body->cell_count() - 1;
        const LoadedFace point = loaded_nodes(*body, last, {body->mesh.cells(2, last), body->mesh.cells(0, last)});
        EXPECT_EQ(point.cell, last);
        EXPECT_EQ(point.cell_node, (std::vector<int>{2, 0}));
        EXPECT_TRUE(loaded_faces(*body, {}).empty());
    }
}

TEST(LoadedFaces, AreFreeUnlessAllTheirNodesAreClamped) {
    for (const fem::ElementKind kind : kinds) {
        const test::BeamSpec spec = brick(kind);
        const BodyPointer body = test::make_beam(spec).body;
        const std::vector<int> held = faces_of_nodes(*body, held_nodes(*body)), free = free_faces(*body);
        EXPECT_EQ(static_cast<Eigen::Index>(held.size() + free.size()), body->boundary.count());
        EXPECT_NEAR(area_of(*body, held), spec.size(1) * spec.size(2), 1e-15);
        EXPECT_NEAR(area_of(*body, free), surface_m2(spec) - spec.size(1) * spec.size(2), 1e-15);
        EXPECT_EQ(free_faces(*test::make_beam(brick(kind, false)).body).size(), held.size() + free.size());
        EXPECT_TRUE(faces_of_nodes(*body, {}).empty());
        // A face without one of its nodes is not among those of the list.
        const auto nodes = body->boundary.nodes.col(0);
        std::vector<int> all(nodes.begin(), nodes.end());
        EXPECT_EQ(faces_of_nodes(*body, all), std::vector<int>{0});
        all.pop_back();
        EXPECT_TRUE(faces_of_nodes(*body, all).empty());
    }
}

/// Quadrature integrates areas and centroids of faces exactly, by shape functions that add up to one.
TEST(SampledFaces, IntegrateTheSurface) {
    for (const fem::ElementKind kind : kinds) {
        const test::BeamSpec spec = brick(kind);
        const BodyPointer body = test::make_beam(spec).body;
        double area = 0.0;
        Vector3d moment = Vector3d::Zero();
        for (const SampledFace& face : sampled_faces(*body, lower_faces(*body)))
            for (const SampledPoint& point : face.points) {
                EXPECT_NEAR(point.shape.sum(), 1.0, 1e-14);
                EXPECT_GT(point.area, 0.0);
                area += point.area;
                moment += point.area * (body->mesh.nodes(Eigen::all, face.nodes) * point.shape);
            }
        EXPECT_NEAR(area, spec.size(0) * spec.size(1), 1e-15);
        EXPECT_LT((moment / area - Vector3d(0.03, 0.015, 0.0)).norm(), 1e-14);
    }
}

TEST(ElasticBedForce, IsTheStiffnessTimesAreaAndDisplacement) {
    const double k = 3e5;
    for (const fem::ElementKind kind : kinds) {
        const test::BeamSpec spec = brick(kind, false);
        const BodyPointer body = test::make_beam(spec).body;
        const ForceElementPointer bed = elastic_bed(*body, lower_faces(*body), k);
        const double area = spec.size(0) * spec.size(1);
        const Vector3d u(1e-3, -2e-3, 3e-3);  // normal and tangential alike
        const Matrix3Xd x = test::moved_by(*body, u);
        const InternalEnergy out = test::force_of(*bed, *body, {x}, HessianKind::positive);
        EXPECT_NEAR(out.energy, 0.5 * k * area * u.squaredNorm(), 1e-12);
        EXPECT_LT((test::resultant(out) + k * area * u).norm(), 1e-11);
        EXPECT_NEAR(test::stiffness_along(out, *body, u.normalized()), k * area, 1e-9);
        // Tilted about the edge x = 0: the second moment of the side about that edge.
        Matrix3Xd tilted = body->mesh.nodes;
        tilted.row(2) += 0.01 * body->mesh.nodes.row(0);
        EXPECT_NEAR(test::force_of(*bed, *body, {tilted}).energy, 0.5 * k * 1e-4 * 0.03 * std::pow(0.06, 3) / 3.0,
                    1e-12);
        EXPECT_TRUE(is_elastic_bed(*bed));
        EXPECT_TRUE(is_elastic_bed(*bed->changed(VectorXd::Constant(1, 2.0 * k))));
        EXPECT_NEAR(test::force_of(*bed->changed(VectorXd::Constant(1, 2.0 * k)), *body, {x}).energy, 2.0 * out.energy,
                    1e-12);
        EXPECT_FALSE(is_elastic_bed(*surface_drag(*body, lower_faces(*body), 1.0, 0.0)));
    }
}

TEST(SurfaceDragForce, IsThatOfItsSpeedTimesTheRestArea) {
    const double c = 20.0, q = 900.0, factor = 50.0;
    for (const fem::ElementKind kind : kinds) {
        const test::BeamSpec spec = brick(kind, false);
        const BodyPointer body = test::make_beam(spec).body;
        const double area = surface_m2(spec);
        const Vector3d u(0.2, -0.3, 0.6);
        const double speed = 0.7;
        // The surface as deformed has four times the area, which counts for nothing.
        const Matrix3Xd x = 2.0 * body->mesh.nodes, v = u.replicate(1, x.cols()), still = Matrix3Xd::Zero(3, x.cols());
        const ForceElementPointer drag = surface_drag(*body, free_faces(*body), c, q);
        const InternalEnergy out = test::force_of(*drag, *body, {x, &v, factor, 0.0}, HessianKind::exact);
        EXPECT_LT((test::resultant(out) + area * (c + q * speed) * u).norm(), 1e-11);
        EXPECT_NEAR(out.energy, area / factor * (0.5 * c * speed * speed + q * std::pow(speed, 3) / 3.0), 1e-13);
        // dv/dx times the derivative by the velocity: c + 2 q v along the motion, c + q v across.
        EXPECT_NEAR(test::stiffness_along(out, *body, u.normalized()), factor * area * (c + 2.0 * q * speed), 1e-8);
        EXPECT_NEAR(test::stiffness_along(out, *body, u.unitOrthogonal()), factor * area * (c + q * speed), 1e-8);
        EXPECT_EQ(test::force_of(*drag, *body, {x, &v, 0.0, 0.0}).energy, 0.0) << "no potential without dv/dx";
        EXPECT_EQ(test::force_of(*drag, *body, {x}).gradient.norm(), 0.0) << "statics";
        const InternalEnergy rest = test::force_of(*drag, *body, {x, &still, factor, 0.0}, HessianKind::exact);
        EXPECT_EQ(rest.gradient.norm(), 0.0);
        EXPECT_NEAR(test::stiffness_along(rest, *body, u.normalized()), factor * area * c, 1e-9);
        EXPECT_TRUE(drag->depends_on_velocity() && drag->has_potential());
    }
}

}  // namespace
}  // namespace myo::model::loaded_face_tests
