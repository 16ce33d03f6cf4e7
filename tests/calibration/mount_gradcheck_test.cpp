#include <gtest/gtest.h>

#include "calibration/gradcheck.hpp"
#include "support/figures.hpp"
#include "support/swung_beam.hpp"
#include "support/turning_mount.hpp"

namespace myo::calibration {
namespace {

/// The adjoint gradient of a body whose mount turns and shakes.
TEST(MountGradient, AgreesWithDifferences) {
    const test::Folder folder("mount_gradient");
    setup::Setup setup = test::swung_beam(folder, 0.1);
    setup.trials[0].mount = test::tumbling_mount();
    const TrialGradientCheck check = gradcheck(setup, 0, 3);
    ASSERT_TRUE(check.check.complete()) << check.check.message;
    int of_mount = 0;
    for (const sensitivity::GradientCheckRow& row : check.check.rows)
        of_mount += row.name.find("force element") != std::string::npos && row.adjoint != 0.0;
    EXPECT_EQ(of_mount, 1) << "the density in the inertia forces";
    test::record("median_error", check.check.median_error());
    test::record("worst_error", check.check.worst_error());
    EXPECT_LE(check.check.median_error(), 1e-6);
    EXPECT_LE(check.check.worst_error(), 1e-4);
}

}  // namespace
}  // namespace myo::calibration
