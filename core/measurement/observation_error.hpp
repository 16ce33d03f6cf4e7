#pragma once

#include <Eigen/Core>

#include <functional>
#include <vector>

#include "measurement/marker_binding.hpp"
#include "measurement/recording.hpp"
#include "model/mount_motion.hpp"

namespace myo::measurement {

/// Two markers whose labels are exchanged from a time on.
struct MarkerSwap {
    std::size_t first = 0, second = 0;
    double from_s = 0.0;  // by the time stamps of the recording
};

/// A marker that is displaced on the body from a time on.
struct MarkerShift {
    std::size_t marker = 0;
    Eigen::Vector3d shift_m = Eigen::Vector3d::Zero();  // mesh frame
    double from_s = 0.0;                                // by the time stamps of the recording
};

/// A marker that sits elsewhere on the body than declared, all along.
struct MarkerPlace {
    std::size_t marker = 0;
    Eigen::Vector3d shift_m = Eigen::Vector3d::Zero();  // from the declared place, at rest, mesh frame
    MarkerBinding binding;                              // at the true place
};

/// Place at which cameras see a point, and its derivative by the true place.
struct SeenPlace {
    Eigen::Vector3d place_m = Eigen::Vector3d::Zero();
    Eigen::Matrix3d by_place = Eigen::Matrix3d::Identity();
};
/// Where cameras see a point [m] at a time [s] by the stamps of the recording.
using Lens = std::function<SeenPlace(const Eigen::Vector3d& place_m, double stamped_s)>;

/// Systematic errors of a recording.
struct ObservationError {
    double clock_offset_s = 0.0;  // a sample stamped t was taken offset later
    double rate_error = 0.0;      // true rate = stated rate times (1 + error)
    double scale_error = 0.0;     // all coordinates are multiplied by 1 + error, about the mesh origin
    std::vector<MarkerSwap> swaps;
    std::vector<MarkerShift> shifts;
    std::vector<Lens> lenses{};       // one after the other, behind the scale
    std::vector<MarkerPlace> places;  // at most one per marker; observe() takes them by seen_markers()
    /// How the mount moves against the cameras, by the clock of the simulation; null: it stands still. No error, but
    /// what turns a motion in the mount's frame into one that cameras see.
    model::MountMotionPointer mount = {};
};

/// Tracks in the laboratory, where the cameras stand, of markers whose tracks in the mount's frame are given. What
/// observe() returns is in the mount's frame; observed_tracks() takes what this returns.
///
/// @param tracks   one per marker, 3 x T [m], mount's frame
/// @param times_s  T, of the simulation
std::vector<Eigen::Matrix3Xd> laboratory_tracks(const ObservationError& error, std::vector<Eigen::Matrix3Xd> tracks,
                                                const Eigen::VectorXd& times_s);

/// Derivatives of laboratory_tracks() from those of the tracks in the mount's frame, for a given motion of the mount.
std::vector<Eigen::Matrix3Xd> laboratory_tangents(const ObservationError& error, std::vector<Eigen::Matrix3Xd> tangents,
                                                  const Eigen::VectorXd& times_s);

/// Velocities in the laboratory of markers in the mount's frame.
///
/// @param tracks, velocities  one per marker, 3 x T [m, m/s], mount's frame
std::vector<Eigen::Matrix3Xd> laboratory_velocities(const ObservationError& error,
                                                    const std::vector<Eigen::Matrix3Xd>& tracks,
                                                    std::vector<Eigen::Matrix3Xd> velocities,
                                                    const Eigen::VectorXd& times_s);

/// True times of samples with these time stamps [s]: t / (1 + rate_error) + clock_offset_s.
Eigen::VectorXd true_times(const ObservationError& error, const Eigen::VectorXd& stamped_s);

/// Tracks as recorded: shifts, then swaps, then the scale are applied to the true tracks.
///
/// @param tracks     one per marker, 3 x T [m], mesh frame
/// @param stamped_s  T, time stamps of the samples
std::vector<Eigen::Matrix3Xd> observed_tracks(const ObservationError& error, std::vector<Eigen::Matrix3Xd> tracks,
                                              const Eigen::VectorXd& stamped_s);

/// Derivatives of the recorded tracks from those of the true tracks; shifts are constant and drop out.
///
/// @param tangents  one per marker, 3 x T, or of no columns: zero
/// @param tracks    true tracks as of observed_tracks(), at which lenses are differentiated; not read without lenses
std::vector<Eigen::Matrix3Xd> observed_tangents(const ObservationError& error, std::vector<Eigen::Matrix3Xd> tangents,
                                                const std::vector<Eigen::Matrix3Xd>& tracks,
                                                const Eigen::VectorXd& stamped_s);

/// Derivative of where a marker is seen before the recording by its true place, exchanges of markers left out.
Eigen::Matrix3d seen_by_place(const ObservationError& error, const Eigen::Vector3d& place_m);

}  // namespace myo::measurement
