#include "results/output_motion.hpp"

#include <algorithm>
#include <cassert>
#include <complex>
#include <limits>

#include "measurement/rigid_motion.hpp"

namespace myo::results {

using Eigen::Matrix3Xd;

ComparedMotion compared_motion(const setup::Setup& setup, std::size_t index, const prediction::ParameterValues& values,
                               const prediction::TrialPrediction& prediction) {
    assert(prediction.ok());
    const setup::PreparedTrial& trial = setup.trials[index];
    ComparedMotion motion{trial.measured.time_s, trial.measured.tracks, prediction.positions_m};
    if (setup.experiment.markers.compare == experiment::Comparison::displacement) {
        for (std::size_t m = 0; m < setup.marker_names.size(); ++m) {
            // Both from their own start: an offset of the registration drops out.
            motion.measured_m[m].colwise() -= trial.reference_m[m];
            motion.simulated_m[m].colwise() -= prediction.start_m[m];
        }
        return motion;
    }
    // Camera frame: the fitted correction of the registration is applied to the simulation, as in the residual.
    const Eigen::Matrix3d R = measurement::small_rotation(values.rotation_rad);
    for (Matrix3Xd& track : motion.simulated_m) track = ((R * track).colwise() + values.translation_m).eval();
    return motion;
}

measurement::Recording simulated_recording(const setup::Setup& setup, std::size_t index,
                                           const prediction::TrialPrediction& prediction) {
    assert(prediction.ok());
    const measurement::Recording& measured = setup.trials[index].measured;
    return {setup.marker_names, measured.time_s, prediction.positions_m, measured.rate_Hz, {}};
}

double main_frequency(const setup::Setup& setup, std::size_t index, const prediction::TrialPrediction& prediction) {
    assert(prediction.ok());
    const setup::PreparedTrial& trial = setup.trials[index];
    const Eigen::Index samples = trial.measured.sample_count() - trial.first_sample;
    // Too few to distinguish a vibration from a trend.
    if (samples < 8) return 0.0;
    const Eigen::VectorXd times = trial.measured.time_s.tail(samples);
    const double duration = times(samples - 1) - times(0);

    Eigen::VectorXd signal;
    double largest = 0.0;
    for (const Matrix3Xd& track : prediction.positions_m)
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            Eigen::VectorXd x = track.row(axis).tail(samples).transpose();
            // The steady state is subtracted; the coordinate with the most energy is analysed.
            // Mean of the last fifth, as the steady state of the tables.
            const double rest = x.tail(std::max<Eigen::Index>(1, samples / 5)).mean();
            x.array() -= rest;
            // A coordinate at rest leaves the rounding of its mean, which is no vibration.
            const double rounding = static_cast<double>(samples) * std::numeric_limits<double>::epsilon() * rest;
            if (x.cwiseAbs().maxCoeff() <= std::abs(rounding)) continue;
            if (x.squaredNorm() > largest) largest = x.squaredNorm(), signal = std::move(x);
        }
    if (!(largest > 0.0) || !(duration > 0.0)) return 0.0;

    // Direct scan of the Fourier integral at a quarter of the frequency resolution, up to the Nyquist frequency or 50
    // Hz; records are short, so an FFT would not pay.
    const double highest = std::min(0.5 * static_cast<double>(samples - 1) / duration, 50.0);
    double best_power = 0.0, best = 0.0;
    for (double f = 1.0 / duration; f < highest; f += 0.25 / duration) {
        std::complex<double> sum = 0.0;
        for (Eigen::Index i = 0; i < samples; ++i)
            sum += signal(i) * std::polar(1.0, -2.0 * 3.14159265358979323846 * f * times(i));
        if (std::norm(sum) > best_power) best_power = std::norm(sum), best = f;
    }
    return best;
}

}  // namespace myo::results
