#pragma once

#include <map>
#include <string>

#include "calibration/calibrate.hpp"

namespace myo::calibration {

/// When and how a modulus is looked for from the beginning of the trials on.
struct WindowPolicy {
    double unexplained = 1.5;       // rms of the residual in noise levels that a right fit stays below
    double most_doubt_rad = 3.1;    // phase that the modulus' bounds leave open at the end of a trial: beyond half a
                                    // period a fit may take one period for another
    double most_phase_rad = 200.0;  // likewise: a body that is declared so wrongly that it vibrates much faster than
                                    // the recording is looked for in vain
    int least_samples = 4;          // of the first window
    double seen_departure = 0.2;    // of the largest way of a marker: motion has begun
    double scan_phase_rad = 0.8;    // between the moduli that are tried on the first window
    int most_scanned = 40;
    double least_share = 0.02;              // of the largest modulus: the smallest where the bounds leave 0
    double damping_shares[2] = {1.0, 0.2};  // of the declared damping, tried with each of them: what is damped away
                                            // fits anything equally badly
    int max_evaluations = 10;               // of a window's fit: the next one goes on from it
    double worth = 0.7;                     // cost of the whole trials with what was found over that of their fit
    double growth = 3.0;                    // of a window: the phase at its end is known to a tenth of a radian by then
};
inline constexpr WindowPolicy window_policy;

/// Values with which a fit of vibrations is to begin anew, by parameter; empty where it need not.
///
/// The phase of a vibration after many periods leaves a modulus open that begins far off: the fit of a whole trial ends
/// where some periods are counted wrongly, or where damping takes the vibration away. Over the first periods there is
/// one minimum: moduli within the bounds are tried there, and the fit of a growing beginning of the trials goes on from
/// the best. Where that explains the whole trials no better than their fit, there is nothing to begin anew with.
///
/// @param found  a fit of the whole trials; where it leaves the noise alone, or the bounds leave less than half a
///               period open, nothing is looked for
std::map<std::string, double> start_from_windows(const setup::Setup& setup, const Calibration& found,
                                                 const Progress& progress = {});

}  // namespace myo::calibration
