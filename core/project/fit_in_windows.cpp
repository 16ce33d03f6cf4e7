#include "project/fit_in_windows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "project/first_vibration.hpp"
#include "project/predict_trials.hpp"
#include "project/weighted_residuals.hpp"

namespace myo {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr const WindowPolicy& policy = window_policy;

void keep_samples(Recording& recording, Index count) {
    recording.time_s.conservativeResize(count);
    for (Eigen::Matrix3Xd& track : recording.tracks) track.conservativeResize(Eigen::NoChange, count);
    for (VectorXd& residual : recording.residual_m) residual.conservativeResize(count);
}

Index samples_until(const StudyTrial& trial, double end_s) {
    const VectorXd& times = trial.measured.time_s;
    return std::max<Index>(trial.first_sample + policy.least_samples, (times.array() <= end_s).count());
}

/// The fit trials alone, each up to `length_s` after its motion has begun.
Study beginning(const Study& study, const std::vector<double>& onset_s, double length_s) {
    Study part = study;
    part.trials.clear();
    part.experiment.trials.clear();
    part.steps.clear();
    for (std::size_t t = 0; t < study.trials.size(); ++t) {
        if (study.trials[t].role != TrialRole::fit) continue;
        StudyTrial trial = study.trials[t];
        const Index count = samples_until(trial, onset_s[t] + length_s);
        if (count < trial.measured.sample_count()) {
            const double interval_s = sampling_interval_s(trial);
            keep_samples(trial.measured, count);
            trial.options.end_s = std::min(trial.options.end_s, trial.measured.time_s(count - 1) + interval_s);
        }
        part.trials.push_back(std::move(trial));
        part.experiment.trials.push_back(study.experiment.trials[t]);
        if (t < study.steps.size()) part.steps.push_back(study.steps[t]);
    }
    return part;
}

/// When markers have first left the place of their first sample by a good part of their way.
double onset(const StudyTrial& trial) {
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
        const double seen = policy.seen_departure * way.maxCoeff();
        for (Index k = trial.first_sample; k < track.cols() && seen > 0.0; ++k)
            if (way(k) > seen) {
                first_s = std::min(first_s, times(std::max<Index>(trial.first_sample, k - 1)));
                break;
            }
    }
    return std::max(0.0, first_s);
}

/// Half the squared residuals; infinite where the model does not run.
double cost(const Study& study, const StudyValues& values, const Progress& progress) {
    const std::vector<std::size_t> trials = trials_with_role(study, TrialRole::fit);
    const ResidualEvaluation there =
        weighted_residuals(study, trials, predict_trials_with(study, values, trials, progress), 0);
    return there.ok ? 0.5 * there.residuals.squaredNorm() : std::numeric_limits<double>::infinity();
}

class Search {
public:
    Search(const Study& study, const Calibration& found, const Progress& progress)
        : study_(study), found_(found), progress_(progress) {
        for (const StudyParameter& p : found.parameters) {
            if (p.kind == StudyParameter::Kind::youngs_modulus && !p.parameter.is_fixed()) modulus_ = &p;
            if (p.kind == StudyParameter::Kind::damping && !p.parameter.is_fixed()) damping_ = &p;
        }
    }

    std::map<std::string, double> run() {
        if (modulus_ == nullptr || !is_unexplained()) return {};
        upper_Pa_ = modulus_->parameter.upper;
        lower_Pa_ = std::max(modulus_->parameter.lower, policy.least_share * upper_Pa_);
        doubt_rad_s_ = 0.5 * std::log(upper_Pa_ / lower_Pa_) * frequency_rad_s();
        double longest_s = 0.0;
        for (const StudyTrial& trial : study_.trials) {
            onset_s_.push_back(onset(trial));
            if (trial.role == TrialRole::fit)
                longest_s = std::max(longest_s, trial.measured.time_s.tail(1)(0) - onset_s_.back());
        }
        const double doubt_rad = doubt_rad_s_ * longest_s;
        if (!(doubt_rad > policy.most_doubt_rad) || doubt_rad > policy.most_phase_rad) return {};
        double length_s = policy.most_doubt_rad / doubt_rad_s_;
        CalibrationSettings settings = found_.settings;
        settings.starts = 1;
        settings.max_evaluations = policy.max_evaluations;
        settings.evaluated = {};
        settings.from = best_of_scan(length_s, settings.from);
        for (; length_s < longest_s && !progress_.cancelled(); length_s *= policy.growth) {
            const Calibration fit =
                calibrate_study(beginning(study_, onset_s_, length_s), settings, progress_.with_sink({}));
            if (!fit.usable()) return {};
            for (std::size_t i = 0; i < fit.parameters.size(); ++i)
                settings.from[fit.parameters[i].parameter.name] = fit.fit.values(static_cast<Index>(i));
        }
        if (progress_.cancelled() || !is_better(settings.from)) return {};
        return settings.from;
    }

private:
    bool is_unexplained() const { return found_.after.fit_rms_m > policy.unexplained * mean_noise(study_); }

    /// Whether these values explain the whole trials much better than their fit does, before a fit begins there.
    bool is_better(const std::map<std::string, double>& from) const {
        StudyValues values = found_.after.values;
        for (const StudyParameter& p : found_.parameters)
            if (const auto value = from.find(p.parameter.name); value != from.end())
                set_value(p, value->second, values);
        return cost(study_, values, progress_.with_sink({})) < policy.worth * found_.fit.cost_after;
    }

    double frequency_rad_s() const {
        StudyValues values = found_.after.values;
        values.youngs_modulus_Pa = std::sqrt(lower_Pa_ * upper_Pa_);
        for (std::size_t t = 0; t < study_.trials.size(); ++t)
            if (study_.trials[t].role == TrialRole::fit)
                return first_vibration_rad_s(affected_trial(study_, t, values).model);
        return 0.0;
    }

    std::map<std::string, double> best_of_scan(double length_s, std::map<std::string, double> from) const {
        const Study window = beginning(study_, onset_s_, length_s);
        double seen_s = length_s;   // few samples of a slow camera take longer than asked for
        for (const StudyTrial& trial : window.trials) seen_s = std::max(seen_s, trial.measured.time_s.tail(1)(0));
        const int count = std::clamp(static_cast<int>(std::ceil(doubt_rad_s_ * seen_s / policy.scan_phase_rad)) + 1, 3,
                                     policy.most_scanned);
        StudyValues values = declared_values(window);
        const double damping_s = values.damping_s;
        double least = std::numeric_limits<double>::infinity();
        for (const double share : policy.damping_shares) {
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

    const Study& study_;
    const Calibration& found_;
    Progress progress_;
    const StudyParameter *modulus_ = nullptr, *damping_ = nullptr;
    std::vector<double> onset_s_;   // per trial
    double lower_Pa_ = 0.0, upper_Pa_ = 0.0;   // of the modulus
    double doubt_rad_s_ = 0.0;
};

}  // namespace

std::map<std::string, double> start_from_windows(const Study& study, const Calibration& found,
                                                 const Progress& progress) {
    return Search(study, found, progress).run();
}

}  // namespace myo
