#pragma once

#include <vector>

#include "check/checked_job.hpp"

namespace myo::check {

// One file per check, registered in catalogue.cpp. Each returns one finding per subject, passed ones included; an empty
// list means that the check does not apply.

/// Mesh resolution for bending and torsion, see setup::unsuitable().
std::vector<Finding> check_mesh(const CheckedJob& job);
/// Mesh resolution between the closest markers, and markers that the mesh does not reach.
std::vector<Finding> check_markers(const CheckedJob& job);
/// Declared quantities within plausible SI ranges.
std::vector<Finding> check_units(const CheckedJob& job);
/// Recorded frequency of free vibration against the first natural frequency, and the sampling rate.
std::vector<Finding> check_time_unit(const CheckedJob& job);
/// The clamped nodes must span an area, otherwise the body rotates about them. A body without any is borne by
/// obstacles.
std::vector<Finding> check_support(const CheckedJob& job);
/// Stability of the rest pose under gravity and loads (linear buckling); does not apply to a body on obstacles alone.
std::vector<Finding> check_pose(const CheckedJob& job);
/// Time step against the dominant vibration of the run, or against its estimated error.
std::vector<Finding> check_step(const CheckedJob& job);
/// Distance of model and recording at the first sample, where that can be compared.
std::vector<Finding> check_start(const CheckedJob& job);
/// Signals that do not overlap their trials.
std::vector<Finding> check_signals(const CheckedJob& job);
/// Validation trials that reuse a recording of a fit trial.
std::vector<Finding> check_recordings(const CheckedJob& job);
/// Inverted cells during the run.
std::vector<Finding> check_inside_out(const CheckedJob& job);
/// Change of the lever arm of straight legs of tendons where the body bends between two guides.
std::vector<Finding> check_tendon_legs(const CheckedJob& job);
/// Fitted values at their bounds.
std::vector<Finding> check_bounds(const CheckedJob& job);
/// Parameters that the data do not determine.
std::vector<Finding> check_influence(const CheckedJob& job);
/// Places of the markers that a fit found, against markers.placement_m.
std::vector<Finding> check_places(const CheckedJob& job);
/// Residual of the fit, or of the declared values, against noise and numerical error. Reads the earlier findings, which
/// may explain it.
std::vector<Finding> check_residual(const CheckedJob& job);

}  // namespace myo::check
