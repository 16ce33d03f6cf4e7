#include <gtest/gtest.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "fem/cell_sides.hpp"
#include "fem/element_block.hpp"
#include "fem/material_point.hpp"
#include "fem/reference_coordinates.hpp"
#include "fem/reference_points.hpp"
#include "support/meshes.hpp"

// Quadrature points and their shape functions belong together; points of a mesh are found again; what lies beside a
// cell decides how it bends.

namespace myo::fem::element_rules_test {
namespace {

using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Products of coordinates lie in the space of the element: their gradients at each point are those of the point where
/// shape_values_at_points() puts it, so that both lists have one order.
TEST(QuadraturePoints, HaveTheGradientsOfTheirPlaces) {
    for (const std::string& id : element_ids()) {
        const ElementKind kind = test::element(id);
        // Regular hexahedra, in which x y z is trilinear, and tetrahedra of any shape.
        const mesh::VolumeMesh mesh = cell_type(kind) == mesh::CellType::hex8
                                          ? test::box_mesh(kind, test::unit_box(), {2, 2, 2})
                                          : test::distorted_mesh(cell_type(kind), {2, 2, 2}, 0.2);
        const std::vector<VectorXd> shapes = shape_values_at_points(kind);
        const bool linear = kind == ElementKind::tet4;
        std::visit(
            [&](const auto& block) {
                for (int c = 0; c < block.cell_count(); ++c) {
                    const auto& geometry = block.geometry[static_cast<std::size_t>(c)];
                    if constexpr (requires { geometry.weight; }) {
                        ASSERT_EQ(shapes.size(), geometry.gradient.size()) << id;
                        const MatrixXd X = mesh.nodes(Eigen::all, block.cells.col(c));
                        const VectorXd product = linear ? VectorXd(X.row(0))
                                                        : VectorXd(X.row(0).cwiseProduct(X.row(1)));
                        for (std::size_t q = 0; q < shapes.size(); ++q) {
                            const Vector3d place = X * shapes[q];
                            const Vector3d expected = linear ? Vector3d(1.0, 0.0, 0.0)
                                                             : Vector3d(place.y(), place.x(), 0.0);
                            EXPECT_LT((geometry.gradient[q].transpose() * product - expected).norm(), 1e-12) << id;
                            EXPECT_LT(geometry.gradient[q].colwise().sum().norm(), 1e-12) << "a shift has no strain";
                            EXPECT_GT(geometry.weight[q], 0.0);
                        }
                    }
                }
            },
            make_elements(mesh, kind));
    }
}

/// Second moments of straight-sided tetrahedra by the points of each quadratic element, against the consistent mass.
TEST(QuadraturePoints, IntegrateSquaresExactly) {
    for (const std::string id : {"tet10", "tet10_fine", "tet10_full"}) {
        const mesh::VolumeMesh mesh = test::distorted_mesh(mesh::CellType::tet10, {2, 1, 1}, 0.2);
        MatrixXd M = MatrixXd::Zero(mesh.node_count(), mesh.node_count());
        for (const MassEntry& entry : consistent_mass(mesh)) M(entry.row, entry.column) += entry.value;
        const Matrix3d exact = mesh.nodes * M * mesh.nodes.transpose();
        Matrix3d sum = Matrix3d::Zero();
        const std::vector<VectorXd> shapes = shape_values_at_points(test::element(id));
        std::visit(
            [&](const auto& block) {
                if constexpr (requires { block.geometry[0].weight; })
                    for (int c = 0; c < block.cell_count(); ++c)
                        for (std::size_t q = 0; q < shapes.size(); ++q) {
                            const Vector3d place = mesh.nodes(Eigen::all, block.cells.col(c)) * shapes[q];
                            sum += block.geometry[static_cast<std::size_t>(c)].weight[q] * place * place.transpose();
                        }
            },
            make_elements(mesh, test::element(id)));
        EXPECT_LT((sum - exact).norm(), 1e-12) << id;
    }
}

/// A mesh of twice the size: volumes as the cube, gradients as the inverse, mass as the cube.
TEST(ElementGeometry, ScalesWithTheBody) {
    for (const std::string& id : element_ids()) {
        const ElementKind kind = test::element(id);
        mesh::VolumeMesh mesh = test::distorted_mesh(cell_type(kind), {1, 1, 1}, 0.2);
        const Elements small = make_elements(mesh, kind);
        const std::vector<MassEntry> mass = consistent_mass(mesh);
        mesh.nodes *= 2.0;
        const Elements large = make_elements(mesh, kind);
        std::visit(
            [&](const auto& block) {
                const auto& other = std::get<std::decay_t<decltype(block)>>(large);
                for (std::size_t c = 0; c < block.geometry.size(); ++c)
                    EXPECT_NEAR(other.geometry[c].volume, 8.0 * block.geometry[c].volume, 1e-14) << id;
                if constexpr (requires { block.geometry[0].weight; }) {
                    EXPECT_LT((2.0 * other.geometry[0].gradient[0] - block.geometry[0].gradient[0]).norm(), 1e-12)
                        << id;
                } else {
                    EXPECT_LT((2.0 * other.geometry[0].gradient - block.geometry[0].gradient).norm(), 1e-12) << id;
                    EXPECT_LT((other.geometry[0].gamma - block.geometry[0].gamma).norm(), 1e-13)
                        << "shapes have no unit";
                    EXPECT_LT((4.0 * other.geometry[0].along[0] - block.geometry[0].along[0]).norm(), 1e-12);
                }
            },
            small);
        const std::vector<MassEntry> larger = consistent_mass(mesh);
        ASSERT_EQ(larger.size(), mass.size());
        EXPECT_EQ(mass.size(), static_cast<std::size_t>(mesh.cell_count() * mesh.cells.rows() * mesh.cells.rows()));
        for (std::size_t i = 0; i < mass.size(); ++i) {
            EXPECT_EQ(larger[i].row, mass[i].row);
            EXPECT_EQ(larger[i].cell, mass[i].cell);
            EXPECT_NEAR(larger[i].value, 8.0 * mass[i].value, 1e-15);
        }
    }
}

/// Which formulations average the volume, and which part of the bulk modulus stays at their points.
TEST(ElementKinds, AverageTheVolumeWhereTheyWouldLock) {
    const std::set<std::string> averaged{"hex8_mean_dilatation", "tet10", "tet10_fine"};
    for (const std::string& id : element_ids()) {
        if (id == "hex8") continue;  // its strains are assumed
        const bool mean = averaged.contains(id);
        const ElementKind kind = test::element(id);
        const mesh::VolumeMesh mesh = test::box_mesh(kind, test::unit_box(), {1, 1, 1});
        CellSurroundings around(static_cast<std::size_t>(mesh.cell_count()));
        for (std::size_t c = 0; c < around.size(); ++c) around[c].fill(static_cast<CellSides>(c % 3));
        const bool at_points = id == "tet10" || id == "tet10_fine";
        for (const bool isolated : {true, false})
            std::visit(
                [&](const auto& block) {
                    if constexpr (requires { block.mean_volume; }) {
                        EXPECT_EQ(block.mean_volume, mean) << id;
                        ASSERT_EQ(block.point_bulk_over_mu.size(), at_points ? around.size() : 0u) << id;
                        const double by_side[] = {4.0, 1.5, 2.0 / 3.0};
                        for (std::size_t c = 0; at_points && c < around.size(); ++c)
                            EXPECT_EQ(block.point_bulk_over_mu[c], by_side[isolated ? 0 : c % 3]) << id;
                    } else {
                        ADD_FAILURE() << id << " has other geometry";
                    }
                },
                make_elements(mesh, kind, isolated ? CellSurroundings() : around));
    }
    const AssumedStrainPolicy policy;
    EXPECT_EQ(policy.relaxed(CellSides::free), 0.0) << "fully counted";
    EXPECT_GT(policy.relaxed(CellSides::inner), policy.relaxed(CellSides::clamped));
}

/// Random points of random cells, found again by Newton's method and by the search over cells.
TEST(PointsOfCells, AreFoundAgain) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> share(0.02, 0.98);
    for (const mesh::CellType type : {mesh::CellType::hex8, mesh::CellType::tet4, mesh::CellType::tet10}) {
        const mesh::VolumeMesh mesh = test::distorted_mesh(type, {2, 2, 2}, 0.2);
        const mesh::BoundaryLocator boundary(mesh);
        mesh::with_cell(type, [&]<class Shape>(Shape) {
            for (int c = 0; c < static_cast<int>(mesh.cell_count()); ++c) {
                // A convex combination of the corners lies inside the reference cell.
                const Eigen::Matrix3Xd corners = Shape::reference_corners();
                VectorXd weights = VectorXd::NullaryExpr(corners.cols(), [&] { return share(random); });
                weights /= weights.sum();
                const Vector3d xi = corners * weights;
                const Vector3d place = mesh::cell_nodes<Shape>(mesh, c) * Shape::values(xi);
                EXPECT_LT((reference_coordinates(mesh, c, place) - xi).norm(), 1e-12) << mesh::to_string(type);
                const MaterialPoint point = material_point(mesh, boundary, place);
                EXPECT_EQ(point.cell, c);
                EXPECT_LT((point.weights - VectorXd(Shape::values(xi))).norm(), 1e-11);
                EXPECT_LT(point.gradient.colwise().sum().norm(), 1e-11);
                // The gradient is the slope of the weights over the rest position.
                const Vector3d step(1e-5, -2e-5, 1.5e-5);
                const VectorXd change = material_point(mesh, boundary, place + step).weights -
                                        material_point(mesh, boundary, place - step).weights;
                EXPECT_LT((change - 2.0 * point.gradient * step).norm(), 1e-6 * change.norm() + 1e-10);
            }
        });
        // At a node the point is that node, whichever of its cells is chosen.
        for (Eigen::Index n = 0; n < mesh.node_count(); ++n) {
            const MaterialPoint point = material_point(mesh, boundary, mesh.nodes.col(n));
            const auto found = std::find(point.nodes.begin(), point.nodes.end(), static_cast<int>(n));
            ASSERT_NE(found, point.nodes.end());
            EXPECT_NEAR(point.weights(found - point.nodes.begin()), 1.0, 1e-9);
        }
    }
}

}  // namespace
}  // namespace myo::fem::element_rules_test
