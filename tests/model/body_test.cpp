#include "model/body.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <array>
#include <cmath>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "model/block_pattern.hpp"
#include "model/held_nodes.hpp"
#include "model/rest_points.hpp"
#include "support/dense.hpp"
#include "support/meshes.hpp"

namespace myo::model::body_tests {
namespace {

using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

BodyPointer bar(const std::vector<int>& clamped, const std::vector<GuidedNode>& guided = {},
                std::vector<std::vector<int>> couplings = {}, fem::ElementKind kind = fem::ElementKind::hex8,
                const Eigen::Vector3i& cells = {3, 1, 1}) {
    return make_body(test::box_mesh(kind, {Vector3d::Zero(), {0.3, 0.2, 0.1}}, cells), kind, clamped,
                     std::move(couplings), guided);
}

/// A symmetric matrix of 3 x 3 blocks of all pairs of nodes of a group; different for every group.
MatrixXd group_matrix(std::size_t nodes, int seed) {
    const auto n = static_cast<Eigen::Index>(3 * nodes);
    MatrixXd M(n, n);
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = 0; j < n; ++j) M(i, j) = std::cos(1.3 * static_cast<double>(i * j + seed));
    return M + M.transpose();
}

TEST(GuidedNodes, AreMergedAndClampedWhereNothingIsFree) {
    const std::array<bool, 3> x{true, false, false}, y{false, true, false}, yz{false, true, true},
        none{false, false, false};
    const BodyPointer body = bar({2}, {{7, yz}, {5, x}, {5, y}, {2, x}, {9, none}, {7, x}, {5, x}});
    EXPECT_EQ(held_nodes(*body), (std::vector<int>{2, 7})) << "held along all axes by two guides";
    ASSERT_EQ(body->guided.size(), 1u) << "a node of the clamp needs no guide, and one of no axis is none";
    EXPECT_EQ(body->guided[0].node, 5);
    EXPECT_EQ(body->guided[0].held, (std::array<bool, 3>{true, true, false}));
    EXPECT_EQ(body->pattern.free_count, body->node_count() - 2);
    EXPECT_EQ(body->pattern.held_unknowns.size(), 2u);
    EXPECT_EQ(support_nodes(*body), (std::vector<int>{2, 7})) << "the clamp shows where the body is held";
    EXPECT_EQ(support_nodes(*bar({}, {{11, x}, {4, yz}})), (std::vector<int>{4, 11})) << "guides in its place";
    EXPECT_TRUE(support_nodes(*bar({})).empty());
}

TEST(BlockPattern, GathersAndScattersWhatIsFree) {
    const BodyPointer body = bar({0, 3}, {{6, {true, false, true}}});
    const Matrix3Xd field = test::rough_field(body->node_count(), 0.4);
    const VectorXd v = gather(body->pattern, field);
    ASSERT_EQ(v.size(), 3 * (body->node_count() - 2));
    Matrix3Xd expected = field;
    expected.col(0).setZero();
    expected.col(3).setZero();
    expected(0, 6) = expected(2, 6) = 0.0;
    EXPECT_EQ(scatter(body->pattern, v), expected);
    EXPECT_EQ(free_part(*body, field), expected);
    EXPECT_EQ(free_part(*body, expected), expected);
    EXPECT_EQ(gather(body->pattern, expected), v);
    // The two are transposes of each other.
    const VectorXd w = VectorXd::LinSpaced(v.size(), -1.0, 2.0);
    EXPECT_NEAR(scatter(body->pattern, w).cwiseProduct(field).sum(), w.dot(v), 1e-13);
    EXPECT_EQ(scatter(body->pattern, VectorXd::Ones(v.size()))(0, 6), 0.0);
}

/// Blocks of cells and of a coupling add up as in a dense matrix of all nodes.
TEST(BlockPattern, AddsBlocksOfCellsAndCouplings) {
    for (const fem::ElementKind kind : {fem::ElementKind::hex8, fem::ElementKind::tet10}) {
        const std::vector<int> far{15, 0, 8, 1};
        const bool is_hex = kind == fem::ElementKind::hex8;
        const BodyPointer body = bar({1, 4}, {}, {{}, far}, kind, {is_hex ? 3 : 1, 1, 1});
        const auto& cells = body->mesh.cells;
        const auto per_cell = static_cast<std::size_t>(cells.rows());
        MatrixXd dense = MatrixXd::Zero(body->dofs(), body->dofs());
        solver::SymmetricSparse sparse = body->pattern.zero;
        const auto add = [&](const std::vector<int>& nodes, const MatrixXd& M, const auto& add_block) {
            for (std::size_t b = 0; b < nodes.size(); ++b)
                for (std::size_t a = 0; a < nodes.size(); ++a) {
                    const Eigen::Matrix3d block = M.block<3, 3>(3 * static_cast<Eigen::Index>(a),
                                                                3 * static_cast<Eigen::Index>(b));
                    dense.block<3, 3>(3 * nodes[a], 3 * nodes[b]) += block;
                    add_block(a, b, block);
                }
        };
        for (int c = 0; c < body->cell_count(); ++c)
            add({cells.col(c).begin(), cells.col(c).end()}, group_matrix(per_cell, c),
                [&](std::size_t a, std::size_t b, const Eigen::Matrix3d& block) {
                    body->pattern.add(sparse, cells, c, static_cast<int>(a), static_cast<int>(b), block);
                });
        add(far, group_matrix(far.size(), 99), [&](std::size_t a, std::size_t b, const Eigen::Matrix3d& block) {
            body->pattern.add_coupled(sparse, far, 1, a, b, block);
        });
        MatrixXd free(body->pattern.unknowns(), body->pattern.unknowns());
        for (Eigen::Index j = 0; j < free.cols(); ++j) {
            const Matrix3Xd unit = scatter(body->pattern, VectorXd::Unit(free.cols(), j));
            const VectorXd column = dense * Eigen::Map<const VectorXd>(unit.data(), unit.size());
            free.col(j) = gather(body->pattern, Eigen::Map<const Matrix3Xd>(column.data(), 3, unit.cols()));
        }
        const MatrixXd assembled = MatrixXd(sparse).selfadjointView<Eigen::Lower>();
        EXPECT_LT((assembled - free).norm(), 1e-13 * free.norm()) << to_string(kind);
        EXPECT_EQ(MatrixXd(sparse).triangularView<Eigen::StrictlyUpper>().toDenseMatrix().norm(), 0.0);
        EXPECT_EQ(body->pattern.zero.norm(), 0.0);
    }
}

/// With held unknowns the solution is that of the matrix without their rows and columns.
TEST(BlockPattern, HoldsUnknownsWithoutChangingTheOthers) {
    const BodyPointer body = bar({0, 1, 2, 3}, {{5, {false, true, false}}, {9, {true, false, true}}});
    const BlockPattern& pattern = body->pattern;
    solver::SymmetricSparse K = pattern.zero;
    const std::size_t nodes = 8;
    for (int c = 0; c < body->cell_count(); ++c) {
        const MatrixXd G = group_matrix(nodes, c);
        const MatrixXd M = G * G.transpose() + 10.0 * MatrixXd::Identity(24, 24);
        for (int b = 0; b < 8; ++b)
            for (int a = 0; a < 8; ++a)
                pattern.add(K, body->mesh.cells, c, a, b, Eigen::Matrix3d(M.block<3, 3>(3 * a, 3 * b)));
    }
    const MatrixXd before = MatrixXd(K).selfadjointView<Eigen::Lower>();
    pattern.hold(K);
    const MatrixXd held = MatrixXd(K).selfadjointView<Eigen::Lower>();
    ASSERT_EQ(pattern.held_unknowns.size(), 3u);
    const std::set<int> of_guides(pattern.held_unknowns.begin(), pattern.held_unknowns.end());
    std::vector<int> others;
    for (int u = 0; u < pattern.unknowns(); ++u)
        if (of_guides.count(u) == 0) others.push_back(u);
    for (const int u : pattern.held_unknowns) {
        EXPECT_EQ(held(u, u), before(u, u)) << "of its size";
        EXPECT_EQ(held.col(u).norm(), before(u, u)) << "and alone in its column";
    }
    const MatrixXd reduced = before(others, others);
    EXPECT_EQ(MatrixXd(held(others, others)), reduced);
    const VectorXd f = gather(pattern, test::rough_field(body->node_count(), 0.8));
    const VectorXd solution = test::inverse(held) * f, alone = test::inverse(reduced) * VectorXd(f(others));
    EXPECT_LT((VectorXd(solution(others)) - alone).norm(), 1e-11 * alone.norm());
    for (const int u : pattern.held_unknowns) EXPECT_EQ(solution(u), 0.0);
    // Diagonals that are zero or negative become positive.
    solver::SymmetricSparse negative = pattern.zero;
    negative.coeffRef(pattern.held_unknowns[0], pattern.held_unknowns[0]) = -4.0;
    pattern.hold(negative);
    EXPECT_EQ(negative.coeff(pattern.held_unknowns[0], pattern.held_unknowns[0]), 4.0);
    EXPECT_EQ(negative.coeff(pattern.held_unknowns[1], pattern.held_unknowns[1]), 1.0);
}

/// Fields over the points have an entry of their own for every point, in full packs.
TEST(BodyPoints, AreCountedInFullPacksAndLieInTheirCells) {
    for (const std::string& id : fem::element_ids()) {
        const BodyPointer body = bar({}, {}, {}, test::element(id), {3, 2, 1});
        EXPECT_EQ(body->point_count() % pack_width, 0) << id;
        EXPECT_GE(body->pack_count() * pack_width, body->cell_count()) << id;
        EXPECT_LT((body->pack_count() - 1) * pack_width, body->cell_count()) << id;
        EXPECT_EQ(body->strains_per_cell, 6 * body->points_per_cell) << id;
        EXPECT_EQ(body->strain_count(), 6 * body->point_count()) << id;
        EXPECT_NEAR(body->volume_m3, 0.3 * 0.2 * 0.1, 1e-15) << id;
        const Matrix3Xd points = rest_points(*body);
        ASSERT_EQ(points.cols(), body->point_count()) << id;
        EXPECT_TRUE(points.allFinite()) << "padding included";
        std::set<Eigen::Index> entries;
        for (int c = 0; c < body->cell_count(); ++c) {
            const Matrix3Xd nodes = body->mesh.nodes(Eigen::all, body->mesh.cells.col(c));
            Vector3d mean = Vector3d::Zero();
            for (int q = 0; q < body->points_per_cell; ++q) {
                const Eigen::Index entry = body->point_entry(c, q);
                ASSERT_TRUE(entry >= 0 && entry < body->point_count()) << id;
                EXPECT_TRUE(entries.insert(entry).second) << id << ": used twice";
                mean += points.col(entry) / body->points_per_cell;
                EXPECT_TRUE((points.col(entry).array() >= nodes.rowwise().minCoeff().array() - 1e-12).all()) << id;
                EXPECT_TRUE((points.col(entry).array() <= nodes.rowwise().maxCoeff().array() + 1e-12).all()) << id;
            }
            // The rules are symmetric about the centre of the reference cell.
            const Eigen::Index corners = body->mesh.type == mesh::CellType::hex8 ? 8 : 4;
            EXPECT_LT((mean - nodes.leftCols(corners).rowwise().mean()).norm(), 1e-12) << id;
        }
    }
}

}  // namespace
}  // namespace myo::model::body_tests
