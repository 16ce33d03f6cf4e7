#pragma once

#include <map>
#include <string>

#include "calibration/calibrate.hpp"

namespace myo::calibration {

/// When and how the modulus is searched for on the beginning of the trials.
struct WindowPolicy {
    double unexplained = 1.5;  // residual rms over noise that a correct fit stays below
    /// Phase left open by the modulus bounds at the end of a trial; beyond half a period a fit can be off by whole
    /// periods.
    double max_doubt_rad = 3.1;
    /// Upper limit of that phase: a body declared so wrongly that it vibrates much faster than the recording is not
    /// searched.
    double max_phase_rad = 200.0;
    int min_samples = 4;          // in the first window
    double seen_departure = 0.2;  // displacement at the onset of motion over the largest one of the marker
    double scan_phase_rad = 0.8;  // phase between adjacent moduli of the scan at the end of the first window
    int max_scanned = 40;         // moduli per damping
    double min_share = 0.02;      // smallest over largest modulus if the lower bound is 0
    /// Share of the declared damping that is tried with each modulus: an overdamped motion fits all equally badly.
    double damping_shares[2] = {1.0, 0.2};
    int max_evaluations = 10;  // per window; the next window continues
    double worth = 0.7;        // required cost on the full trials over that of their fit
    double growth = 3.0;       // of a window; the phase at its end is then known to a tenth of a radian
};
inline constexpr WindowPolicy window_policy;

/// Start values for a second fit of vibrations; empty if none is needed.
///
/// After many periods the phase is ambiguous: if the modulus starts far off, the fit of a full trial ends with a wrong
/// number of periods, or with damping that removes the vibration. Over the first periods there is a single minimum, so
/// moduli within the bounds are scanned there, and windows of growing length are fitted from the best one.
///
/// @param found  fit of the full trials; if only noise is left, or the bounds leave less than half a period open,
///               nothing is searched
/// @return       values by parameter name, SI; empty also if they do not explain the full trials better than `found`
std::map<std::string, double> start_from_windows(const setup::Setup& setup, const Calibration& found,
                                                 const Progress& progress = {});

}  // namespace myo::calibration
