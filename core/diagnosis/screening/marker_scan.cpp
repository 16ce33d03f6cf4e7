#include "diagnosis/screening/marker_scan.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "diagnosis/diagnosis_policy.hpp"
#include "effect/catalogue.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Time from which a change reduces the squared residual, and by how much [noise squares].
struct Onset {
    double from_s = 0.0;
    double gain = 0.0;
};

/// Not aligned: sorts of the standard library move it through buffers that need not be aligned.
using Amount = Eigen::Matrix<double, 4, 1, Eigen::DontAlign>;

/// Contribution of one sample to the gain of an onset.
struct Moment {
    double time_s = 0.0;
    Amount amount = Amount::Zero();  // to be summed over all samples from the onset on
};

/// Onset that maximises value(sum of the amounts from the onset on); onsets are times of samples.
template <class Value>
Onset best_onset(std::vector<Moment> moments, const Value& value) {
    std::stable_sort(moments.begin(), moments.end(),
                     [](const Moment& a, const Moment& b) { return a.time_s < b.time_s; });
    Onset best;
    Amount sum = Amount::Zero();
    // From the end backwards, so that one running sum gives all onsets. Samples of equal time belong together.
    for (std::size_t k = moments.size(); k-- > 0;) {
        sum += moments[k].amount;
        if (k > 0 && moments[k - 1].time_s == moments[k].time_s) continue;
        if (const double gain = value(sum); gain > best.gain) best = {moments[k].time_s, gain};
    }
    return best;
}

/// Trials in which an event may have occurred: each one alone, and all of them (empty) if there are several.
std::vector<std::optional<std::size_t>> trial_choices(const FitData& data) {
    std::vector<std::optional<std::size_t>> choices;
    for (const std::size_t trial : data.trials) choices.emplace_back(trial);
    if (data.trials.size() > 1) choices.emplace_back();
    return choices;
}

bool in_choice(const std::optional<std::size_t>& choice, const statistics::ResidualSeries& series) {
    return !choice || static_cast<int>(*choice) == series.trial;
}

/// Change of each entry of the residual if the names of two markers are exchanged.
class SwapChange {
public:
    SwapChange(const FitData& data, const JointFit& fit, int first, int second)
        : data_(data), fit_(fit), markers_{first, second} {}

    /// Prediction of the other marker minus that of the entry's own [noise levels]; 0 for all other markers.
    double at(const statistics::ResidualSeries& series, Index entry) const {
        if (series.marker != markers_[0] && series.marker != markers_[1]) return 0.0;
        const auto other = static_cast<std::size_t>(series.marker == markers_[0] ? markers_[1] : markers_[0]);
        const auto place = static_cast<std::size_t>(
            std::find(data_.trials.begin(), data_.trials.end(), static_cast<std::size_t>(series.trial)) -
            data_.trials.begin());
        const auto& positions = fit_.predictions[place].positions_m;
        const int sample = data_.layout.sample[static_cast<std::size_t>(entry)];
        return (positions[other](series.axis, sample) -
                positions[static_cast<std::size_t>(series.marker)](series.axis, sample)) /
               data_.noise_m(entry);
    }

private:
    const FitData& data_;
    const JointFit& fit_;
    int markers_[2];
};

/// Score test of the columns S (N x events, before whitening) on the residual of the fit.
EffectScore scored(const FitData& data, const JointFit& fit, const statistics::NuisanceSpace& nuisance,
                   const MatrixXd& S, const std::string& id) {
    EffectScore score;
    score.id = id;
    const VectorXd outside = nuisance.outside(fit.residual);
    score.candidate = statistics::project_candidate(nuisance, data.places.whitened(S));
    score.test = statistics::score_test(score.candidate, outside, data.layout);
    score.predicted = score.candidate.basis * (score.candidate.basis.transpose() * outside);
    return score;
}

/// The parameters with the name of the trial, if the event is restricted to one.
effect::EffectParameters with_trial(effect::EffectParameters parameters, const setup::Setup& setup,
                                    const std::optional<std::size_t>& choice) {
    if (choice) parameters["trial"] = setup.trials[*choice].name;
    return parameters;
}

/// Scores every pair of markers whose exchange removes enough of the squared residual (min_swap_gain).
void scan_swaps(const setup::Setup& setup, const FitData& data, const JointFit& fit,
                const statistics::NuisanceSpace& nuisance, const std::string& id, const ScreeningPolicy& policy,
                std::vector<EffectScore>& scores) {
    const int count = static_cast<int>(setup.marker_names.size());
    for (int first = 0; first < count; ++first)
        for (int second = first + 1; second < count; ++second) {
            const SwapChange change(data, fit, first, second);
            for (const std::optional<std::size_t>& choice : trial_choices(data)) {
                std::vector<Moment> moments;
                for (const statistics::ResidualSeries& series : data.layout.series)
                    if (in_choice(choice, series) && (series.marker == first || series.marker == second))
                        for (Index k = series.begin; k < series.end; ++k) {
                            const double r = fit.residual(k), swapped = r + change.at(series, k);
                            // Gain of an entry: its square before minus that after the exchange; no amount is fitted.
                            moments.push_back({data.layout.time_s[static_cast<std::size_t>(k)],
                                               Amount(r * r - swapped * swapped, 0.0, 0.0, 0.0)});
                        }
                const Onset onset = best_onset(std::move(moments), [](const Amount& sum) { return sum(0); });
                if (!(onset.gain > policy.min_swap_gain * fit.residual.squaredNorm())) continue;
                MatrixXd S = MatrixXd::Zero(data.layout.size(), 1);
                for (const statistics::ResidualSeries& series : data.layout.series)
                    if (in_choice(choice, series))
                        for (Index k = series.begin; k < series.end; ++k)
                            if (data.layout.time_s[static_cast<std::size_t>(k)] >= onset.from_s)
                                S(k, 0) = change.at(series, k);
                EffectScore score = scored(data, fit, nuisance, S, id);
                score.best.effect = with_trial(
                    {{"markers", std::vector<std::string>{setup.marker_names[static_cast<std::size_t>(first)],
                                                          setup.marker_names[static_cast<std::size_t>(second)]}},
                     {"time_s", onset.from_s}},
                    setup, choice);
                scores.push_back(std::move(score));
            }
        }
}

/// Scores every marker whose displacement from an onset on removes enough of the squared residual (min_slip_gain).
void scan_slips(const setup::Setup& setup, const FitData& data, const JointFit& fit,
                const statistics::NuisanceSpace& nuisance, const std::string& id, const ScreeningPolicy& policy,
                std::vector<EffectScore>& scores) {
    const VectorXd outside = nuisance.outside(fit.residual);
    // A hold has one place per marker, which a displacement of its own would explain whatever the body does.
    const auto is_hold = [&](std::size_t trial) { return setup.trials[trial].hold; };
    const bool only_holds = std::all_of(data.trials.begin(), data.trials.end(), is_hold);
    for (int marker = 0; marker < static_cast<int>(setup.marker_names.size()); ++marker)
        for (const std::optional<std::size_t>& choice : trial_choices(data)) {
            if (choice ? is_hold(*choice) : only_holds) continue;
            std::vector<Moment> moments;
            for (const statistics::ResidualSeries& series : data.layout.series)
                if (in_choice(choice, series) && series.marker == marker)
                    for (Index k = series.begin; k < series.end; ++k) {
                        Amount amount = Amount::Zero();
                        // A constant displacement d of n samples removes |sum r|^2 / n: components 0 to 2 are sums per
                        // axis, component 3 counts samples, of which each of the three axes has an entry.
                        amount(series.axis) = outside(k);
                        amount(3) = 1.0 / 3.0;
                        moments.push_back({data.layout.time_s[static_cast<std::size_t>(k)], amount});
                    }
            if (moments.empty()) continue;
            const Onset onset = best_onset(std::move(moments),
                                           [](const Amount& sum) { return sum.head<3>().squaredNorm() / sum(3); });
            if (!(onset.gain > policy.min_slip_gain * outside.squaredNorm())) continue;
            MatrixXd S = MatrixXd::Zero(data.layout.size(), 3);
            for (const statistics::ResidualSeries& series : data.layout.series)
                if (in_choice(choice, series) && series.marker == marker)
                    for (Index k = series.begin; k < series.end; ++k)
                        if (data.layout.time_s[static_cast<std::size_t>(k)] >= onset.from_s)
                            S(k, series.axis) = 1.0 / data.noise_m(k);
            EffectScore score = scored(data, fit, nuisance, S, id);
            score.best.effect = with_trial({{"marker", setup.marker_names[static_cast<std::size_t>(marker)]},
                                            {"shift_m", VectorXd(-score.test.step)},
                                            {"time_s", onset.from_s}},
                                           setup, choice);
            scores.push_back(std::move(score));
        }
}

}  // namespace

std::vector<EffectScore> scan_markers(const setup::Setup& setup, const FitData& data, const JointFit& fit,
                                      const statistics::NuisanceSpace& nuisance, const EffectFilter& allowed,
                                      const ScreeningPolicy& policy) {
    std::vector<EffectScore> scores;
    for (const effect::Effect& effect : effect::effect_catalogue()) {
        if (!allowed(effect.id)) continue;
        if (effect.marker_event == effect::MarkerEvent::swap &&
            setup.experiment.markers.compare == experiment::Comparison::position)
            scan_swaps(setup, data, fit, nuisance, effect.id, policy, scores);
        if (effect.marker_event == effect::MarkerEvent::slip)
            scan_slips(setup, data, fit, nuisance, effect.id, policy, scores);
    }
    return scores;
}

}  // namespace myo::diagnosis
