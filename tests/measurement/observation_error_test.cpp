#include "measurement/observation_error.hpp"

#include <gtest/gtest.h>

namespace myo::measurement {
namespace {

TEST(ObservationError, StampsScalesSwapsAndShiftsAsItSays) {
    const Eigen::VectorXd stamped = Eigen::VectorXd::LinSpaced(5, 0.0, 0.4);
    ObservationError error;
    error.clock_offset_s = 0.05;
    error.rate_error = 0.25;
    EXPECT_NEAR(true_times(error, stamped)(4), 0.4 / 1.25 + 0.05, 1e-15);

    const std::vector<Eigen::Matrix3Xd> tracks{Eigen::Matrix3Xd::Constant(3, 5, 1.0),
                                               Eigen::Matrix3Xd::Constant(3, 5, 2.0)};
    error.scale_error = 0.1;
    error.swaps.push_back({0, 1, 0.15});
    error.shifts.push_back({1, Eigen::Vector3d(0.0, 0.0, 3.0), 0.25});
    const std::vector<Eigen::Matrix3Xd> seen = observed_tracks(error, tracks, stamped);
    EXPECT_DOUBLE_EQ(seen[0](2, 1), 1.1);        // before anything
    EXPECT_DOUBLE_EQ(seen[0](2, 2), 2.2);        // swapped
    EXPECT_DOUBLE_EQ(seen[0](2, 3), 1.1 * 5.0);  // and shifted
    EXPECT_DOUBLE_EQ(seen[1](2, 4), 1.1);
    EXPECT_DOUBLE_EQ(observed_tangents(error, tracks, tracks, stamped)[0](2, 4), 2.2);  // a shift is a constant
    const std::vector<Eigen::Matrix3Xd> plain = observed_tracks({}, tracks, stamped);
    EXPECT_EQ(plain[0], tracks[0]);
    EXPECT_EQ(true_times({}, stamped), stamped);
}

}  // namespace
}  // namespace myo::measurement
