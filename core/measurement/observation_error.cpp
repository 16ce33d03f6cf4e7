#include "measurement/observation_error.hpp"

#include <algorithm>
#include <cassert>

namespace myo::measurement {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;

/// Swaps of labels, then the scale: the part that is linear in the tracks.
void exchange_and_scale(const ObservationError& error, std::vector<Matrix3Xd>& tracks,
                        const Eigen::VectorXd& stamped_s) {
    for (const MarkerSwap& swap : error.swaps)
        for (Index t = 0; t < stamped_s.size(); ++t)
            if (stamped_s(t) >= swap.from_s) tracks[swap.first].col(t).swap(tracks[swap.second].col(t));
    if (error.scale_error != 0.0)
        for (Matrix3Xd& track : tracks) track *= 1.0 + error.scale_error;
}

void add_shifts(const ObservationError& error, std::vector<Matrix3Xd>& tracks, const Eigen::VectorXd& stamped_s) {
    for (const MarkerShift& shift : error.shifts)
        for (Index t = 0; t < stamped_s.size(); ++t)
            if (stamped_s(t) >= shift.from_s) tracks[shift.marker].col(t) += shift.shift_m;
}

/// What a lens does before the recording is what it does at its start.
SeenPlace seen_by(const Lens& lens, const Eigen::Vector3d& place_m, double stamped_s) {
    return lens(place_m, std::max(0.0, stamped_s));
}

}  // namespace

std::vector<Matrix3Xd> laboratory_tracks(const ObservationError& error, std::vector<Matrix3Xd> tracks,
                                         const Eigen::VectorXd& times_s) {
    if (!error.mount) return tracks;
    for (Index t = 0; t < times_s.size(); ++t) {
        const model::MountPose pose = error.mount->at(times_s(t));
        for (Matrix3Xd& track : tracks) track.col(t) = pose.in_laboratory(track.col(t)).eval();
    }
    return tracks;
}

std::vector<Matrix3Xd> laboratory_tangents(const ObservationError& error, std::vector<Matrix3Xd> tangents,
                                           const Eigen::VectorXd& times_s) {
    if (!error.mount || !error.mount->turns()) return tangents;
    for (Index t = 0; t < times_s.size(); ++t) {
        const Eigen::Matrix3d R = error.mount->at(times_s(t)).rotation;
        for (Matrix3Xd& tangent : tangents) tangent.col(t) = (R * tangent.col(t)).eval();
    }
    return tangents;
}

std::vector<Matrix3Xd> laboratory_velocities(const ObservationError& error, const std::vector<Matrix3Xd>& tracks,
                                             std::vector<Matrix3Xd> velocities, const Eigen::VectorXd& times_s) {
    if (!error.mount) return velocities;
    for (Index t = 0; t < times_s.size(); ++t) {
        const model::MountPose pose = error.mount->at(times_s(t));
        for (std::size_t m = 0; m < tracks.size(); ++m)
            velocities[m].col(t) = pose.velocities_in_laboratory(tracks[m].col(t), velocities[m].col(t)).eval();
    }
    return velocities;
}

// Sample k is stamped k / declared rate but was taken at k / true rate, plus the offset.
Eigen::VectorXd true_times(const ObservationError& error, const Eigen::VectorXd& stamped_s) {
    return stamped_s.array() / (1.0 + error.rate_error) + error.clock_offset_s;
}

std::vector<Matrix3Xd> observed_tracks(const ObservationError& error, std::vector<Matrix3Xd> tracks,
                                       const Eigen::VectorXd& stamped_s) {
    // Shifts act on the marker itself and hence precede the exchange of labels.
    add_shifts(error, tracks, stamped_s);
    exchange_and_scale(error, tracks, stamped_s);
    for (const Lens& lens : error.lenses)
        for (Matrix3Xd& track : tracks)
            for (Index t = 0; t < track.cols(); ++t) track.col(t) = seen_by(lens, track.col(t), stamped_s(t)).place_m;
    return tracks;
}

std::vector<Matrix3Xd> observed_tangents(const ObservationError& error, std::vector<Matrix3Xd> tangents,
                                         const std::vector<Matrix3Xd>& tracks, const Eigen::VectorXd& stamped_s) {
    exchange_and_scale(error, tangents, stamped_s);
    if (error.lenses.empty()) return tangents;
    std::vector<Matrix3Xd> seen = tracks;
    add_shifts(error, seen, stamped_s);
    exchange_and_scale(error, seen, stamped_s);
    for (const Lens& lens : error.lenses)
        for (std::size_t m = 0; m < tangents.size(); ++m)
            for (Index t = 0; t < tangents[m].cols(); ++t) {
                const SeenPlace at = seen_by(lens, seen[m].col(t), stamped_s(t));
                tangents[m].col(t) = (at.by_place * tangents[m].col(t)).eval();
                seen[m].col(t) = at.place_m;
            }
    return tangents;
}

Eigen::Matrix3d seen_by_place(const ObservationError& error, const Eigen::Vector3d& place_m) {
    const double scale = 1.0 + error.scale_error;
    Eigen::Vector3d seen = scale * place_m;
    Eigen::Matrix3d slope = scale * Eigen::Matrix3d::Identity();
    for (const Lens& lens : error.lenses) {
        const SeenPlace at = seen_by(lens, seen, 0.0);
        slope = (at.by_place * slope).eval();
        seen = at.place_m;
    }
    return slope;
}

}  // namespace myo::measurement
