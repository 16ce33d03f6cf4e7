#include "fibre/cell_paint.hpp"

#include <gtest/gtest.h>

#include "fibre/painted_mask.hpp"
#include "fibre/pulled.hpp"
#include "mesh/region.hpp"

namespace myo::fibre {
namespace {

using Eigen::Vector3d;
using test::all_cell_types;
using test::mesh_of;

/// A 3 x 3 x 3 block in the middle of 9 x 9 x 9 cells.
struct Block {
    mesh::VolumeMesh mesh = mesh::box_hex_mesh({Vector3d::Zero(), Vector3d::Ones()}, {9, 9, 9});
    Eigen::Matrix2Xi neighbours = mesh::neighbouring_cells(mesh);
    CellPaint paint = {mesh::volume_fractions(mesh, {Vector3d::Constant(3.0 / 9.0), Vector3d::Constant(6.0 / 9.0)}),
                       Vector3d::UnitX().replicate(1, mesh.cell_count())};

    int count(const CellPaint& p) const { return amount_of(p, mesh::cell_volumes(mesh)).cells; }

    Block() { paint.weights = (paint.weights.array() > 0.5).cast<double>(); }
};

TEST(CellPaint, GrowsAndShrinksByALayer) {
    const Block block;
    EXPECT_EQ(block.count(block.paint), 27);
    const CellPaint more = grown(block.paint, block.neighbours);
    EXPECT_EQ(block.count(more), 27 + 6 * 9);
    EXPECT_EQ(block.count(shrunk(block.paint, block.neighbours)), 1);
    // Every cell of the block has all its neighbours painted then.
    EXPECT_EQ(block.count(shrunk(more, block.neighbours)), 27);
    for (Eigen::Index c = 0; c < more.count(); ++c)
        ASSERT_TRUE(more.weights(c) == 0.0 || std::abs(more.directions(0, c)) > 1.0 - 1e-12);
}

/// The surface of the body is no edge of the paint.
TEST(CellPaint, AWholeBodyDoesNotShrink) {
    for (const mesh::CellType type : all_cell_types) {
        const mesh::VolumeMesh mesh = mesh_of(type, {3, 3, 3});
        const CellPaint all{Eigen::VectorXd::Ones(mesh.cell_count()),
                            Vector3d::UnitX().replicate(1, mesh.cell_count())};
        EXPECT_EQ(shrunk(all, mesh::neighbouring_cells(mesh)).weights.sum(), static_cast<double>(mesh.cell_count()));
    }
}

/// What painted walls enclose, and nothing beyond them.
TEST(CellPaint, FillsWhatIsEnclosed) {
    const Block block;
    CellPaint shell = block.paint;
    const CellPaint core = shrunk(block.paint, block.neighbours);
    int middle = -1;
    for (int c = 0; c < static_cast<int>(core.count()); ++c)
        if (core.weights(c) > 0.0) middle = c, shell.weights(c) = 0.0, shell.directions.col(c).setZero();
    ASSERT_GE(middle, 0);
    const CellPaint inside = filled(shell, block.mesh, block.neighbours, middle, Vector3d::UnitZ());
    EXPECT_EQ(block.count(inside), 27);
    EXPECT_NEAR(std::abs(inside.directions(0, middle)), 1.0, 1e-9) << "between the walls' directions";
    EXPECT_EQ(block.count(filled(shell, block.mesh, block.neighbours, 0, Vector3d::UnitZ())), 9 * 9 * 9 - 1);
    EXPECT_EQ(block.count(filled(block.paint, block.mesh, block.neighbours, middle, Vector3d::UnitZ())), 27)
        << "painted already";
    const CellPaint all = filled(blank_paint(block.mesh), block.mesh, block.neighbours, 5, Vector3d::UnitZ());
    EXPECT_EQ(block.count(all), 9 * 9 * 9);
    EXPECT_EQ(all.directions.col(17), Vector3d::UnitZ());
}

/// Paint kept by place comes back on its own mesh as it was, and on others with its volume and line.
TEST(CellPaint, SurvivesRemeshing) {
    for (const mesh::CellType from : all_cell_types) {
        const mesh::VolumeMesh mesh = from == mesh::CellType::hex8 ? mesh_of(from, {10, 8, 6})
                                                                   : mesh_of(from, {5, 4, 4});
        const CellPaint paint{mesh::volume_fractions(mesh, {{0.2, 0.0, 0.3}, {0.8, 0.4, 0.6}}),
                              Vector3d::UnitY().replicate(1, mesh.cell_count())};
        const PaintedMask mask = mask_of_cells(mesh, paint);
        const double volume = amount_of(paint, mesh::cell_volumes(mesh)).volume_m3;
        EXPECT_LT((paint_of_mask(mesh, mask).weights - paint.weights).norm(), 1e-12);
        for (const mesh::CellType to : all_cell_types) {
            const mesh::VolumeMesh other = mesh_of(to, {7, 5, 5});
            const CellPaint again = paint_of_mask(other, mask);
            EXPECT_NEAR(amount_of(again, mesh::cell_volumes(other)).volume_m3, volume, 0.04 * volume)
                << to_string(from) << " " << to_string(to);
            for (Eigen::Index c = 0; c < again.count(); ++c)
                ASSERT_TRUE(again.weights(c) == 0.0 || std::abs(again.directions(1, c)) > 1.0 - 1e-9);
        }
    }
}

}  // namespace
}  // namespace myo::fibre
