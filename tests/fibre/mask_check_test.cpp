#include "fibre/mask_check.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fibre/pulled.hpp"
#include "mesh/region.hpp"

namespace myo::fibre {
namespace {

using Eigen::Vector3d;
using test::all_cell_types;
using test::mesh_of;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The unit box's cells in a part of it, along x.
PaintedMask mask_on(const mesh::VolumeMesh& mesh) {
    const Box part{{0.2, 0.0, 0.3}, {0.8, 0.4, 0.6}};
    return mask_of_cells(mesh, {mesh::volume_fractions(mesh, part), Vector3d::UnitX().replicate(1, mesh.cell_count())});
}

TEST(MaskCheck, SaysNothingOfWhatWasPaintedHere) {
    for (const mesh::CellType type : all_cell_types)
        for (const Eigen::Vector3i& cells : {Eigen::Vector3i(6, 5, 5), Eigen::Vector3i(10, 4, 4)}) {
            const mesh::VolumeMesh mesh = type == mesh::CellType::hex8 ? mesh_of(type, cells)
                                                                       : test::distorted_mesh(type, cells, 0.1);
            EXPECT_THAT(contradictions(mask_on(mesh)), IsEmpty()) << to_string(type);
            EXPECT_EQ(elements_off_mesh(mesh, mask_on(mesh)), 0) << to_string(type);
            EXPECT_EQ(elements_off_mesh(mesh_of(mesh::CellType::hex8, {3, 2, 2}), mask_on(mesh)), 0) << to_string(type);
        }
}

TEST(MaskCheck, TellsOfACellSizeThatIsNotTheSpacing) {
    PaintedMask mask = mask_on(mesh_of(mesh::CellType::hex8, {10, 10, 10}));
    const double right = mask.cell_size_m;
    mask.cell_size_m = 0.1 * right;
    EXPECT_THAT(contradictions(mask),
                ElementsAre(HasSubstr("says 8 mm, but its places are 60 mm apart: most of the room")));
    mask.cell_size_m = 1000.0 * right;  // millimetres for metres
    EXPECT_THAT(contradictions(mask), ElementsAre(HasSubstr("paint spreads beyond them")));
}

TEST(MaskCheck, CountsPlacesListedTwiceWithOtherNumbers) {
    PaintedMask mask = mask_on(mesh_of(mesh::CellType::hex8, {10, 10, 10}));
    const auto again = [&](Eigen::Index row, double weight, const Vector3d& fibre) {
        const Eigen::Index n = mask.count();
        mask.centroids_m.conservativeResize(3, n + 1);
        mask.weights.conservativeResize(n + 1);
        mask.directions.conservativeResize(3, n + 1);
        mask.centroids_m.col(n) = mask.centroids_m.col(row);
        mask.weights(n) = weight;
        mask.directions.col(n) = fibre;
    };
    Eigen::Index painted = 0;
    mask.weights.maxCoeff(&painted);
    again(painted, mask.weights(painted), -Vector3d::UnitX());  // a fibre has no sign
    EXPECT_THAT(contradictions(mask), IsEmpty());
    again(painted, 0.25, Vector3d::UnitX());
    EXPECT_THAT(contradictions(mask), ElementsAre(HasSubstr("listed twice")));
}

TEST(MaskCheck, CountsPaintOffTheMesh) {
    const mesh::VolumeMesh mesh = mesh_of(mesh::CellType::hex8, {10, 10, 10});
    PaintedMask mask = mask_on(mesh);
    const auto painted = (mask.weights.array() > 0.0).count();
    mask.centroids_m.row(0).array() += 0.5;  // a third stays: from 0.7 to 1.3
    const Eigen::Index off = elements_off_mesh(mesh, mask);
    EXPECT_GE(off, painted / 3);
    EXPECT_LT(off, painted * 2 / 3);
    mask.centroids_m.row(0).array() += 10.0;
    EXPECT_EQ(elements_off_mesh(mesh, mask), painted);
}

}  // namespace
}  // namespace myo::fibre
