#include <gtest/gtest.h>

#include <cmath>

#include "check/checks.hpp"
#include "setup/setup.hpp"
#include "support/swung_beam.hpp"

namespace myo::check {
namespace {

/// The swung beam, whose markers rest where they are declared, with a noise of 0.1 mm per coordinate.
class Thresholds : public testing::Test {
protected:
    Thresholds() : folder_("thresholds"), setup_(test::swung_beam(folder_, 0.2)) {}

    /// Finding on the first trial if its recording is off by this distance along y and, after its first half, moves by
    /// that along z [m].
    Finding start(double off_m, double travel_m) const {
        setup::Setup setup = setup_;
        for (Eigen::Matrix3Xd& track : setup.trials[0].measured.tracks) {
            track.row(1).array() += off_m;
            track.row(2).rightCols(10).array() += travel_m;
        }
        return check_start({setup}).front();
    }

    test::Folder folder_;
    setup::Setup setup_;
};

/// A still body is judged by the noise: five times that of a distance, sqrt(3) times that of a coordinate.
TEST_F(Thresholds, OfTheStartIsFiveTimesTheNoise) {
    const double limit = 5.0 * std::sqrt(3.0) * 1e-4;
    EXPECT_NEAR(start(0.0, 0.0).threshold, limit, 1e-15);
    EXPECT_EQ(start(0.999 * limit, 0.0).level, CheckLevel::passed);
    EXPECT_NEAR(start(0.999 * limit, 0.0).figure, 0.999 * limit, 1e-15);
    EXPECT_EQ(start(1.001 * limit, 0.0).level, CheckLevel::wrong);
}

/// A moving one by its range: doubtful from a twentieth of it, wrong from a fifth.
TEST_F(Thresholds, OfTheStartAreSharesOfTheRange) {
    EXPECT_NEAR(start(0.0, 0.1).threshold, 5e-3, 1e-15);
    EXPECT_EQ(start(4.99e-3, 0.1).level, CheckLevel::passed);
    EXPECT_EQ(start(5.01e-3, 0.1).level, CheckLevel::doubtful);
    EXPECT_EQ(start(19.9e-3, 0.1).level, CheckLevel::doubtful);
    EXPECT_EQ(start(20.1e-3, 0.1).level, CheckLevel::wrong);
    EXPECT_EQ(start(20.1e-3, 0.1).unit, "m");
}

/// Half the width of the clamped face, 15 mm, over the length of 100 mm; only a width of rounding is a line.
TEST_F(Thresholds, OfTheSupportIsAWidthOfRounding) {
    const Finding found = check_support({setup_}).front();
    EXPECT_NEAR(found.figure, 0.15, 1e-12);
    EXPECT_NEAR(found.threshold, 1e-5, 1e-20);
    EXPECT_EQ(found.level, CheckLevel::passed);
}

}  // namespace
}  // namespace myo::check
