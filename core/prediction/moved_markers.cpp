#include "prediction/moved_markers.hpp"

#include "measurement/marker_places.hpp"

namespace myo::prediction {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

Eigen::VectorXd motion_times(const setup::PreparedTrial& trial, const measurement::ObservationError& error,
                             double start_shift_s) {
    return measurement::true_times(error, trial.measured.time_s).array() - start_shift_s;
}

measurement::MarkerSet markers_of(const setup::Setup& setup, const measurement::ObservationError& error,
                                  const ParameterValues& values) {
    return measurement::placed_markers(setup.body->mesh, measurement::seen_markers(setup.markers, error),
                                       values.places_m);
}

bool by_displacement(const setup::Setup& setup) {
    return setup.experiment.markers.compare == experiment::Comparison::displacement;
}

SensitiveMotion sensitive_motion(const measurement::ObservationError& error, const sensitivity::SensitiveTrace& run,
                                 const measurement::MarkerSet& markers, const Eigen::VectorXd& times_s) {
    return {error, measurement::observe(run, markers, times_s),
            measurement::observe(run, markers, Eigen::VectorXd::Zero(1))};
}

std::vector<Matrix3Xd> moved_tangent(const setup::Setup& setup, std::size_t index, const ParameterValues& values,
                                     const SensitiveMotion& motion, std::size_t row) {
    const setup::PreparedTrial& trial = setup.trials[index];
    const Eigen::Matrix3d R = measurement::small_rotation(values.rotation_rad);
    const Eigen::VectorXd times = motion_times(trial, motion.error, values.start_shift_s[index]);
    std::vector<Matrix3Xd> d = measurement::observed_tangents(
        motion.error, measurement::laboratory_tangents(motion.error, motion.tracks.tangents[row], times),
        measurement::laboratory_tracks(motion.error, motion.tracks.tracks.positions, times), trial.measured.time_s);
    const std::vector<Matrix3Xd> origin = measurement::laboratory_tracks(motion.error, motion.origin.tracks.positions,
                                                                         Eigen::VectorXd::Zero(1));
    const std::vector<Matrix3Xd> start = measurement::laboratory_tangents(motion.error, motion.origin.tangents[row],
                                                                          Eigen::VectorXd::Zero(1));
    for (std::size_t m = 0; m < d.size(); ++m) {
        // The reference position at t = 0 depends on the parameter as well and is subtracted from each sample.
        if (by_displacement(setup))
            d[m].colwise() -= measurement::seen_by_place(motion.error, origin[m].col(0)) * Vector3d(start[m].col(0));
        else
            d[m] = R * d[m];
    }
    return d;
}

}  // namespace myo::prediction
