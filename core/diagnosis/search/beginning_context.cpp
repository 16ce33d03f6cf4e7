#include "diagnosis/search/beginning_context.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "base/text.hpp"
#include "diagnosis/fit/stored_fit.hpp"
#include "measurement/marker_binding.hpp"
#include "prediction/predict_trials.hpp"
#include "setup/beginning.hpp"

namespace myo::diagnosis {
namespace {

using Eigen::Index;

/// Number of samples in the beginning of a trial, from the first of its recording.
Index samples_in_beginning(const setup::PreparedTrial& trial, double share, int min_samples) {
    const Index all = trial.measured.sample_count(), compared = all - trial.first_sample;
    // A pose has one equilibrium for all samples: it costs the same, however short.
    if (trial.hold) return all;
    const auto wanted = static_cast<Index>(std::ceil(share * static_cast<double>(compared)));
    return std::min(all, trial.first_sample + std::max<Index>(min_samples, wanted));
}

/// Root mean square of the distances of the markers from their places at rest, as the declared fit moves them [m].
double motion_m(const DiagnosisContext& context, std::size_t fit_trial) {
    const prediction::TrialPrediction& prediction = context.declared.fit.predictions[fit_trial];
    double squares = 0.0, count = 0.0;
    for (std::size_t m = 0; m < prediction.positions_m.size(); ++m) {
        const measurement::MarkerBinding& marker = context.setup.markers.bindings[m];
        const Eigen::Vector3d rest = measurement::marker_position(
            marker, context.setup.body->mesh.nodes(Eigen::all, marker.nodes));
        squares += (prediction.positions_m[m].colwise() - rest).squaredNorm();
        count += static_cast<double>(prediction.positions_m[m].cols());
    }
    return std::sqrt(squares / std::max(count, 1.0));
}

/// Fit trials that take part in a beginning: all recordings of a motion, and of the poses a share, those that the
/// declared fit moves least. A large pose departs from the derivatives as the late part of a motion does.
std::vector<std::size_t> trials_of_beginning(const DiagnosisContext& context, double share) {
    std::vector<std::pair<double, std::size_t>> poses;
    for (std::size_t i = 0; i < context.data.trials.size(); ++i)
        if (context.setup.trials[context.data.trials[i]].hold)
            poses.emplace_back(motion_m(context, i), context.data.trials[i]);
    std::sort(poses.begin(), poses.end());
    const auto wanted = static_cast<std::size_t>(std::ceil(share * static_cast<double>(poses.size())));
    poses.resize(std::min(poses.size(), std::max(wanted, context.policy().beginnings.min_poses)));
    std::vector<std::size_t> trials;
    for (const std::size_t t : context.data.trials)
        if (!context.setup.trials[t].hold ||
            std::any_of(poses.begin(), poses.end(), [&](const auto& pose) { return pose.second == t; }))
            trials.push_back(t);
    return trials;
}

/// Trials that are left out are none of the fit: numbers of their own are not sought.
void keep_fit_trials(setup::Setup& setup, const std::vector<std::size_t>& kept) {
    for (const std::size_t t : prediction::trials_with_role(setup, experiment::TrialRole::fit))
        if (std::find(kept.begin(), kept.end(), t) == kept.end())
            setup.trials[t].role = experiment::TrialRole::validate;
}

/// Shortens the recordings of these trials to their beginnings.
void keep_beginnings(setup::Setup& setup, const std::vector<std::size_t>& trials, double share, int min_samples) {
    for (const std::size_t t : trials)
        setup::keep_beginning(setup.trials[t], samples_in_beginning(setup.trials[t], share, min_samples));
}

/// The shift of the samples that the setup still has.
PredictionShift of_beginnings(PredictionShift shift, const setup::Setup& setup) {
    for (std::size_t t = 0; t < shift.size(); ++t)
        for (Eigen::Matrix3Xd& marker : shift[t]) {
            const Index samples = setup.trials[t].measured.sample_count();
            if (samples < marker.cols()) marker.conservativeResize(Eigen::NoChange, samples);
        }
    return shift;
}

}  // namespace

std::string beginning_words(const DiagnosisContext& context, double share) {
    const std::vector<std::size_t> trials = trials_of_beginning(context, share);
    const auto poses = std::count_if(trials.begin(), trials.end(),
                                     [&](std::size_t t) { return context.setup.trials[t].hold; });
    const std::string of_motions = "the first " + format_number(100.0 * share, 2) + " % of every recording",
                      of_poses = "the " + std::to_string(poses) + " poses with the smallest motion";
    if (poses == 0) return of_motions;
    return static_cast<std::size_t>(poses) == trials.size() ? of_poses : of_motions + " and " + of_poses;
}

double residual_in_beginnings(const DiagnosisContext& context, double share) {
    const statistics::ResidualLayout& layout = context.data.layout;
    const Eigen::VectorXd& residual = context.declared.fit.residual;
    const std::vector<std::size_t> trials = trials_of_beginning(context, share);
    double squares = 0.0, count = 0.0;
    for (const statistics::ResidualSeries& series : layout.series) {
        if (std::find(trials.begin(), trials.end(), static_cast<std::size_t>(series.trial)) == trials.end()) continue;
        const Index samples = samples_in_beginning(context.setup.trials[static_cast<std::size_t>(series.trial)], share,
                                                   context.policy().beginnings.min_samples);
        for (Index k = series.begin; k < series.end && layout.sample[static_cast<std::size_t>(k)] < samples; ++k) {
            squares += residual(k) * residual(k);
            count += 1.0;
        }
    }
    return count > 0.0 ? std::sqrt(squares / count) : 0.0;
}

std::optional<DiagnosisContext> beginning_context(const DiagnosisContext& context, double share, FitStore& store,
                                                  PhaseLog& log) {
    const int min_samples = context.policy().beginnings.min_samples;
    // Everything that refers to samples is shortened: both setups, and every shift in the errors.
    DiagnosisContext part{context.setup, context.settings, {}, {}, context.numerics, context.refinement};
    const std::vector<std::size_t> trials = trials_of_beginning(context, share);
    keep_fit_trials(part.setup, trials);
    keep_beginnings(part.setup, trials, share, min_samples);
    if (context.refinement.finer) {
        setup::Setup finer = *context.refinement.finer;
        keep_fit_trials(finer, trials);
        keep_beginnings(finer, trials, share, min_samples);
        part.refinement.finer = std::make_shared<const setup::Setup>(std::move(finer));
    }
    for (PredictionShift* shift : {&part.numerics.step_shift, &part.numerics.mesh_change, &part.numerics.by_modulus,
                                   &part.refinement.unmatched.shift, &part.refinement.unmatched.step_shift,
                                   &part.refinement.unmatched.mesh_change, &part.refinement.unmatched.by_modulus})
        *shift = of_beginnings(std::move(*shift), part.setup);
    part.data = fit_data(part.setup, trials);
    part.numerics.shift = of_beginnings(context.numerics.shift, part.setup);
    part.data.shift = of_beginnings(context.data.shift, part.setup);
    // Repeated trials are compared once, on the whole recordings.
    part.data.floor_m = context.data.floor_m;
    const prediction::ParameterValues& declared = context.declared.fit.values;
    // Unknown places are linearised at the samples that are left.
    if (part.setup.experiment.markers.placement_m > 0.0) {
        const std::vector<prediction::TrialPrediction> placed = prediction::predict_trials_with(
            part.setup, declared, part.data.trials, log.progress());
        if (!prediction::all_ok(placed)) return {};
        part.data = with_unknown_places(part.setup, std::move(part.data), placed);
    }
    JointFit fit = logged_fit(
        "fit of beginnings",
        {part.setup, part.data, declared, part.policy(), EffectFreedom::all, part.policy().declared.effort}, store,
        log);
    if (!fit.usable() || log.cancelled()) return {};
    part.declared = judged(part.data, std::move(fit), part.settings);
    return part;
}

}  // namespace myo::diagnosis
