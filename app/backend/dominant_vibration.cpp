#include "backend/dominant_vibration.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "inverse/damped_cosine.hpp"

namespace myo::backend {
namespace {

using Eigen::VectorXd;

/// Later zero crossings may be noise.
constexpr int max_crossings = 9;

/// Replaces frequency and damping by those of a damped cosine, fitted to the longest interval without gaps, if it
/// describes the samples. A short record does not come to rest, so its crossings depend on the assumed rest value.
void fit_free_vibration(const VectorXd& times_s, const VectorXd& values, MeasuredVibration& found) {
    // Longest run of finite samples: the fit needs equal intervals, so gaps must not be closed. The pass after the last
    // sample ends the last run.
    Eigen::Index first = 0, count = 0;
    for (Eigen::Index t = 0, start = 0; t <= values.size(); ++t) {
        if (t < values.size() && std::isfinite(values(t))) continue;
        if (t - start > count) first = start, count = t - start;
        start = t + 1;
    }
    // fit_damped_cosine() asserts eight samples.
    if (count < 8) return;
    const inverse::DampedCosine fit = inverse::fit_damped_cosine(times_s.segment(first, count),
                                                                 values.segment(first, count));
    const double fitted_Hz = fit.omega_rad_s / (2.0 * std::numbers::pi);
    const VectorXd about = values.segment(first, count).array() - fit.offset;
    // A driven motion or one of several modes leaves a large residual, and its frequency differs from that of the
    // crossings.
    const bool fits = fit.ok && fit.rms < 0.5 * about.norm() / std::sqrt(static_cast<double>(count)) &&
                      std::abs(fitted_Hz / found.frequency_Hz - 1.0) < 0.4;
    if (!fits || !(fit.rate_1_s > 0.0)) return;
    found.frequency_Hz = fitted_Hz;
    found.damping_ratio = fit.damping_ratio();
}

/// Mean of the samples that are seen; NaN if none is.
double mean_of_seen(const VectorXd& values) {
    double sum = 0.0, count = 0.0;
    for (const double value : values)
        if (std::isfinite(value)) sum += value, ++count;
    return sum / count;
}

}  // namespace

MeasuredVibration vibration_of(const VectorXd& times_s, const VectorXd& values) {
    MeasuredVibration found;
    const Eigen::Index samples = values.size(), tail = std::max<Eigen::Index>(1, samples / 5);
    // A free vibration has nearly come to rest at the end of its record.
    const double rest = mean_of_seen(values.tail(tail));
    double first = 0.0, last = 0.0;
    int crossings = 0;
    for (Eigen::Index t = 1; t < samples; ++t) {
        // A NaN on either side makes the product NaN: no crossing is counted over a gap.
        const double a = values(t - 1) - rest, b = values(t) - rest;
        if (!std::isfinite(a * b)) continue;
        found.energy_m2 += b * b;
        if (a * b >= 0.0) continue;
        // Time of the zero by linear interpolation.
        last = times_s(t - 1) + (times_s(t) - times_s(t - 1)) * a / (a - b);
        if (crossings++ == 0) first = last;
        if (crossings == max_crossings) break;
    }
    if (crossings < 3) return found;
    // Two crossings per period.
    found.frequency_Hz = (crossings - 1) / (2.0 * (last - first));
    fit_free_vibration(times_s, values, found);
    return found;
}

MeasuredVibration dominant_vibration(const setup::Setup& setup) {
    MeasuredVibration dominant;
    for (const setup::PreparedTrial& trial : setup.trials)
        for (const Eigen::Matrix3Xd& track : trial.measured.tracks)
            for (int axis = 0; axis < 3; ++axis) {
                const Eigen::Index samples = track.cols() - trial.first_sample;
                if (samples < 2) continue;
                const MeasuredVibration found = vibration_of(trial.measured.time_s.tail(samples),
                                                             track.row(axis).tail(samples).transpose());
                if (found.frequency_Hz > 0.0 && found.energy_m2 > dominant.energy_m2) dominant = found;
            }
    return dominant;
}

}  // namespace myo::backend
