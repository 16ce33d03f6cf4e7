#include "calibration/fit_in_windows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "base/text.hpp"
#include "prediction/predict_trials.hpp"
#include "prediction/weighted_residuals.hpp"
#include "setup/beginning.hpp"
#include "setup/first_vibration.hpp"

namespace myo::calibration {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// At least a few samples, so that a slow camera does not give an empty window.
Index samples_until(const setup::PreparedTrial& trial, double end_s) {
    const VectorXd& times = trial.measured.time_s;
    return std::max<Index>(trial.first_sample + window_policy.min_samples, (times.array() <= end_s).count());
}

/// Setup of the fit trials alone, each truncated to `length_s` after the onset of its motion.
setup::Setup beginning(const setup::Setup& setup, const std::vector<double>& onset_s, double length_s) {
    setup::Setup part = setup;
    part.trials.clear();
    part.experiment.trials.clear();
    part.steps.clear();
    for (std::size_t t = 0; t < setup.trials.size(); ++t) {
        if (setup.trials[t].role != experiment::TrialRole::fit) continue;
        setup::PreparedTrial trial = setup.trials[t];
        setup::keep_beginning(trial, samples_until(trial, onset_s[t] + length_s));
        part.trials.push_back(std::move(trial));
        part.experiment.trials.push_back(setup.experiment.trials[t]);
        if (t < setup.steps.size()) part.steps.push_back(setup.steps[t]);
    }
    return part;
}

/// Onset of motion: the earliest time at which a marker has moved by a fixed part of its largest displacement.
double onset(const setup::PreparedTrial& trial) {
    const VectorXd& times = trial.measured.time_s;
    double first_s = times(times.size() - 1);
    for (const Eigen::Matrix3Xd& track : trial.measured.tracks) {
        std::optional<Eigen::Vector3d> from;
        VectorXd way = VectorXd::Zero(track.cols());
        for (Index k = trial.first_sample; k < track.cols(); ++k) {
            if (!track.col(k).allFinite()) continue;
            if (!from) from = track.col(k);
            way(k) = (track.col(k) - *from).norm();
        }
        // Relative to the marker's own motion, so that noise and slow drift before the release do not count.
        const double seen = window_policy.seen_departure * way.maxCoeff();
        for (Index k = trial.first_sample; k < track.cols() && seen > 0.0; ++k)
            if (way(k) > seen) {
                first_s = std::min(first_s, times(std::max<Index>(trial.first_sample, k - 1)));
                break;
            }
    }
    return std::max(0.0, first_s);
}

/// Half the sum of squared residuals over the noise; infinite if the model cannot be run.
double cost(const setup::Setup& setup, const prediction::ParameterValues& values, const Progress& progress) {
    const std::vector<std::size_t> trials = prediction::trials_with_role(setup, experiment::TrialRole::fit);
    const inverse::ResidualEvaluation there = prediction::weighted_residuals(
        setup, trials, prediction::predict_trials_with(setup, values, trials, progress), 0);
    return there.ok ? 0.5 * there.residuals.squaredNorm() : std::numeric_limits<double>::infinity();
}

/// Search of modulus and damping on growing windows, see start_from_windows().
class Search {
public:
    Search(const setup::Setup& setup, const Calibration& found, const Progress& progress)
        : setup_(setup), found_(found), progress_(progress) {
        for (const prediction::ModelParameter& p : found.parameters) {
            if (p.kind == prediction::ModelParameter::Kind::youngs_modulus && !p.parameter.is_fixed()) modulus_ = &p;
            if (p.kind == prediction::ModelParameter::Kind::damping && !p.parameter.is_fixed()) damping_ = &p;
        }
    }

    std::map<std::string, double> run() {
        // Without a free modulus no frequency is open, and a residual of noise alone has the right number of periods.
        if (modulus_ == nullptr || !is_unexplained()) return {};
        // Frequency is proportional to the root of the modulus, so the bounds leave a frequency range of
        // omega * ln(E_max / E_min) / 2, which multiplied by time gives the open phase.
        upper_Pa_ = modulus_->parameter.upper;
        lower_Pa_ = std::max(modulus_->parameter.lower, window_policy.min_share * upper_Pa_);
        doubt_rad_s_ = 0.5 * std::log(upper_Pa_ / lower_Pa_) * frequency_rad_s();
        // Windows are measured from the onset: trials may begin with a long rest.
        double longest_s = 0.0;
        for (const setup::PreparedTrial& trial : setup_.trials) {
            onset_s_.push_back(onset(trial));
            if (trial.role == experiment::TrialRole::fit && !trial.hold)  // a pose has no phase
                longest_s = std::max(longest_s, trial.measured.time_s.tail(1)(0) - onset_s_.back());
        }
        const double doubt_rad = doubt_rad_s_ * longest_s;
        // Less than half a period open: no ambiguity. Too many periods: the scan would not resolve them.
        if (!(doubt_rad > window_policy.max_doubt_rad) || doubt_rad > window_policy.max_phase_rad) return {};
        // In the first window less than half a period is open, so there is one minimum.
        double length_s = window_policy.max_doubt_rad / doubt_rad_s_;
        CalibrationSettings settings = found_.settings;
        settings.starts = 1;
        settings.max_evaluations = window_policy.max_evaluations;
        settings.evaluated = {};
        settings.from = best_of_scan(length_s, settings.from);
        // Each window starts from the fit of the shorter one, whose phase error is small at the new end.
        const double windows = std::ceil(std::log(longest_s / length_s) / std::log(window_policy.growth));
        for (int w = 0; length_s < longest_s && !progress_.cancelled(); ++w, length_s *= window_policy.growth) {
            progress_.report({"longer parts", std::min(static_cast<double>(w), windows), windows, "parts",
                              "the trials' first " + format_number(length_s, 2) + " s"});
            const Calibration fit = calibrate(beginning(setup_, onset_s_, length_s), settings, progress_.with_sink({}));
            if (!fit.usable()) return {};
            for (std::size_t i = 0; i < fit.parameters.size(); ++i)
                settings.from[fit.parameters[i].parameter.name] = fit.fit.values(static_cast<Index>(i));
        }
        // Another minimum must explain the whole trials clearly better, before any fit from there.
        if (progress_.cancelled() || !is_better(settings.from)) return {};
        return settings.from;
    }

private:
    /// Whether the fit left more than noise.
    bool is_unexplained() const {
        return found_.after.fit_rms_m > window_policy.unexplained * setup::mean_noise(setup_);
    }

    /// Whether these values give the full trials a clearly lower cost than their own fit, before fitting from there.
    bool is_better(const std::map<std::string, double>& from) const {
        prediction::ParameterValues values = found_.after.values;
        for (const prediction::ModelParameter& p : found_.parameters)
            if (const auto value = from.find(p.parameter.name); value != from.end())
                prediction::set_value(p, value->second, values);
        return cost(setup_, values, progress_.with_sink({})) < window_policy.worth * found_.fit.cost_after;
    }

    // First natural angular frequency [rad/s] at the geometric mean of the bounds, the middle of the logarithmic scan.
    double frequency_rad_s() const {
        prediction::ParameterValues values = found_.after.values;
        values.youngs_modulus_Pa = std::sqrt(lower_Pa_ * upper_Pa_);
        for (std::size_t t = 0; t < setup_.trials.size(); ++t)
            if (setup_.trials[t].role == experiment::TrialRole::fit)
                return setup::first_vibration_rad_s(prediction::affected_trial(setup_, t, values).model);
        return 0.0;
    }

    /// Modulus and damping with the lowest cost on the first window. The grid is logarithmic, fine enough in phase at
    /// the end of the window to hit the basin of the global minimum.
    std::map<std::string, double> best_of_scan(double length_s, std::map<std::string, double> from) const {
        const setup::Setup window = beginning(setup_, onset_s_, length_s);
        double seen_s = length_s;  // at least the first samples of a slow camera
        for (const setup::PreparedTrial& trial : window.trials)
            seen_s = std::max(seen_s, trial.measured.time_s.tail(1)(0));
        const int count = std::clamp(
            static_cast<int>(std::ceil(doubt_rad_s_ * seen_s / window_policy.scan_phase_rad)) + 1, 3,
            window_policy.max_scanned);
        prediction::ParameterValues values = prediction::declared_values(window);
        const double damping_s = values.damping_s;
        double least = std::numeric_limits<double>::infinity();
        // Other parameters keep their declared values: at the beginning the frequency matters most.
        for (const double share : window_policy.damping_shares) {
            if (damping_ == nullptr && share != 1.0) continue;
            values.damping_s = share * damping_s;
            for (int i = 0; i < count && !progress_.cancelled(); ++i) {
                values.youngs_modulus_Pa = lower_Pa_ * std::pow(upper_Pa_ / lower_Pa_, i / (count - 1.0));
                const double here = cost(window, values, progress_.with_sink({}));
                progress_.report({"other moduli", static_cast<double>(i + 1), static_cast<double>(count), "runs", {}});
                if (!(here < least)) continue;
                least = here;
                from[modulus_->parameter.name] = values.youngs_modulus_Pa;
                if (damping_ != nullptr) from[damping_->parameter.name] = values.damping_s;
            }
        }
        return from;
    }

    const setup::Setup& setup_;
    const Calibration& found_;
    Progress progress_;
    const prediction::ModelParameter *modulus_ = nullptr, *damping_ = nullptr;
    std::vector<double> onset_s_;             // per trial
    double lower_Pa_ = 0.0, upper_Pa_ = 0.0;  // of the modulus
    double doubt_rad_s_ = 0.0;                // frequency range left open by the bounds of the modulus
};

}  // namespace

std::map<std::string, double> start_from_windows(const setup::Setup& setup, const Calibration& found,
                                                 const Progress& progress) {
    return Search(setup, found, progress).run();
}

}  // namespace myo::calibration
