#include "prediction/vibration_in_motion.hpp"

#include <algorithm>
#include <cmath>

#include "dynamics/material_damping.hpp"
#include "dynamics/natural_modes.hpp"

namespace myo::prediction {
namespace {

using Eigen::Matrix3Xd;

constexpr VibrationPolicy vibration_policy;

/// Root mean square of a mode shape at the markers [m per unit of the modal coordinate].
double at_markers(const measurement::MarkerSet& markers, const Matrix3Xd& shape) {
    double sum = 0.0;
    for (const measurement::MarkerBinding& marker : markers.bindings)
        sum += (shape(Eigen::all, marker.nodes) * marker.weights).squaredNorm() / 3.0;
    return std::sqrt(sum / static_cast<double>(markers.bindings.size()));
}

/// Amplitude (rms) of a modal coordinate at omega, from its third derivative, so that slower motion contributes little:
/// for q = A sin(omega t) the third derivative has amplitude A omega^3.
double swing(const std::vector<double>& times, const std::vector<double>& velocity, double omega) {
    double sum = 0.0;
    long count = 0;
    for (std::size_t i = 2; i < velocity.size(); ++i) {
        const double h = times[i] - times[i - 1];
        if (std::abs(times[i - 1] - times[i - 2] - h) > 1e-6 * h) continue;  // step shortened to meet a jump
        const double jerk = (velocity[i] - 2.0 * velocity[i - 1] + velocity[i - 2]) / (h * h);
        sum += jerk * jerk;
        ++count;
    }
    return count > 0 ? std::sqrt(sum / static_cast<double>(count)) / (omega * omega * omega) : 0.0;
}

}  // namespace

std::vector<Vibration> vibrations_in(const model::Model& model, const measurement::MarkerSet& markers,
                                     const dynamics::Trace& trace) {
    dynamics::StageSolver solver(model);
    // Modes about the last pose: the stiffness of the deformed body determines the frequencies that are visible at the
    // end.
    const Matrix3Xd& pose = trace.positions.back();
    const auto free = std::count(model.body->clamped.begin(), model.body->clamped.end(), false);
    const int count = std::min(vibration_policy.modes, 3 * static_cast<int>(free));
    const dynamics::NaturalModes modes = dynamics::natural_modes(solver, pose, count, trace.times_s.back());
    std::vector<Vibration> seen;
    if (!modes.ok()) return seen;
    for (const dynamics::NaturalMode& mode : modes.modes) {
        const double damping = dynamics::damping_ratio(dynamics::damping_factor(model, pose, mode), model.damping_s,
                                                       mode.omega_rad_s);
        if (damping > vibration_policy.max_damping_ratio) continue;
        // Mass-weighted projection gives the velocity of the modal coordinate, for mass-normalised modes.
        const Matrix3Xd momentum = model::times_mass(mode.shape, solver.mass(trace.times_s.back()));
        std::vector<double> velocity;
        for (const Matrix3Xd& v : trace.velocities) velocity.push_back(momentum.cwiseProduct(v).sum());
        const double amplitude = at_markers(markers, mode.shape) * swing(trace.times_s, velocity, mode.omega_rad_s);
        if (amplitude > 0.0) seen.push_back({mode.omega_rad_s, damping, amplitude});
    }
    std::sort(seen.begin(), seen.end(),
              [](const Vibration& a, const Vibration& b) { return a.amplitude_m > b.amplitude_m; });
    return seen;
}

}  // namespace myo::prediction
