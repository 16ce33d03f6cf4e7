#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "commands/part_edits.hpp"

namespace myo::ui::commands::part_places_test {
namespace {

std::shared_ptr<const fibre::PaintedMask> mask_of(double weight, double x_m) {
    fibre::PaintedMask mask;
    mask.cell_size_m = 0.01;
    mask.centroids_m = Eigen::Vector3d(x_m, 0.0, 0.0);
    mask.weights = Eigen::VectorXd::Constant(1, weight);
    return std::make_shared<const fibre::PaintedMask>(mask);
}

std::vector<ScenePart> four_parts() {
    std::vector<ScenePart> parts(4);
    parts[0].box_m = Box{Eigen::Vector3d::Zero(), Eigen::Vector3d::Ones()};
    parts[1].file = "tip.stl";
    parts[2].region = 3;
    parts[3].mask = mask_of(1.0, 0.02);
    return parts;
}

TEST(PartPlaces, AreTheSameWhateverTheMaterialAndName) {
    const std::vector<ScenePart> parts = four_parts();
    std::vector<ScenePart> other = parts;
    other[1].youngs_modulus_Pa = 2e6;
    other[2].name = "tip";
    EXPECT_TRUE(same_places(parts, other));
    const std::vector<std::function<void(std::vector<ScenePart>&)>> changes{
        [](auto& p) { p[0].box_m->highest.z() = 2.0; },
        [](auto& p) { p[1].file = "root.stl"; },
        [](auto& p) { p[2].region = 4; },
        [](auto& p) { p[3].mask = mask_of(0.5, 0.02); },
        [](auto& p) { p.pop_back(); },
        [](auto& p) { std::swap(p[1], p[2]); }};
    for (std::size_t k = 0; k < changes.size(); ++k) {
        other = parts;
        changes[k](other);
        EXPECT_FALSE(same_places(parts, other)) << k;
        EXPECT_FALSE(same_places(other, parts)) << k;
    }
}

/// A declaration that is read again has its masks read again, too.
TEST(PartPlaces, MasksOfEqualContentAreOne) {
    const std::vector<ScenePart> parts = four_parts();
    std::vector<ScenePart> again = four_parts();
    EXPECT_FALSE(same_places(parts, again));
    keep_masks(parts, again);
    EXPECT_EQ(again[3].mask, parts[3].mask);
    EXPECT_TRUE(same_places(parts, again));
    for (const auto& mask : {mask_of(0.5, 0.02), mask_of(1.0, 0.03)}) {
        again[3].mask = mask;
        keep_masks(parts, again);
        EXPECT_EQ(again[3].mask, mask);
    }
    again.resize(5);
    keep_masks(parts, again);
    EXPECT_EQ(again[4].mask, nullptr);
}

}  // namespace
}  // namespace myo::ui::commands::part_places_test
