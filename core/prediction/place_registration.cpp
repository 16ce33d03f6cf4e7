#include "prediction/place_registration.hpp"

#include <utility>

namespace myo::prediction {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

std::vector<Matrix3Xd> registered_change(const setup::Setup& setup, const setup::PreparedTrial& trial,
                                         const Eigen::VectorXd& places) {
    const Eigen::VectorXd motion = trial.registration_by_places * places;
    const Vector3d translation = motion.head<3>(), rotation = motion.tail<3>();
    const bool displacement = setup.experiment.markers.compare == experiment::Comparison::displacement;
    std::vector<Matrix3Xd> change;
    for (std::size_t m = 0; m < trial.measured.tracks.size(); ++m) {
        const Matrix3Xd& measured = trial.measured.tracks[m];
        Matrix3Xd moved = Matrix3Xd::Zero(3, measured.cols());
        for (Index t = 0; t < measured.cols(); ++t) {
            const Vector3d y = measured.col(t);
            if (!y.allFinite()) continue;
            // Displacements are turned only.
            moved.col(t) = displacement ? Vector3d(rotation.cross(y - trial.reference_m[m]))
                                        : Vector3d(translation + rotation.cross(y));
        }
        change.push_back(std::move(moved));
    }
    return change;
}

void follow_registration(const setup::Setup& setup, const setup::PreparedTrial& trial,
                         const std::vector<Vector3d>& places_m, std::vector<Matrix3Xd>& residual_m) {
    if (places_m.empty() || trial.registration_by_places.size() == 0) return;
    Eigen::VectorXd places(3 * static_cast<Index>(places_m.size()));
    for (std::size_t m = 0; m < places_m.size(); ++m) places.segment<3>(3 * static_cast<Index>(m)) = places_m[m];
    const std::vector<Matrix3Xd> change = registered_change(setup, trial, places);
    for (std::size_t m = 0; m < residual_m.size(); ++m) residual_m[m] -= change[m];
}

}  // namespace myo::prediction
