#pragma once

#include <Eigen/Core>

#include <vector>

#include "setup/setup.hpp"

namespace myo::prediction {

/// Change of the measured tracks as they are compared, per marker 3 x samples, if the rest-pose registration follows
/// these places of the markers; zero where not measured.
///
/// @param places  coordinates of all markers, 3 markers
std::vector<Eigen::Matrix3Xd> registered_change(const setup::Setup& setup, const setup::PreparedTrial& trial,
                                                const Eigen::VectorXd& places);

/// Takes that change off the residuals. Nothing happens without places, or if the registration does not depend on them.
void follow_registration(const setup::Setup& setup, const setup::PreparedTrial& trial,
                         const std::vector<Eigen::Vector3d>& places_m, std::vector<Eigen::Matrix3Xd>& residual_m);

}  // namespace myo::prediction
