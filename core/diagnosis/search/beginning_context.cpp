#include "diagnosis/search/beginning_context.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "diagnosis/fit/stored_fit.hpp"
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

double residual_in_beginnings(const DiagnosisContext& context, double share) {
    const statistics::ResidualLayout& layout = context.data.layout;
    const Eigen::VectorXd& residual = context.declared.fit.residual;
    double squares = 0.0, count = 0.0;
    for (const statistics::ResidualSeries& series : layout.series) {
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
    keep_beginnings(part.setup, context.data.trials, share, min_samples);
    if (context.refinement.finer) {
        setup::Setup finer = *context.refinement.finer;
        keep_beginnings(finer, context.data.trials, share, min_samples);
        part.refinement.finer = std::make_shared<const setup::Setup>(std::move(finer));
    }
    for (PredictionShift* shift : {&part.numerics.step_shift, &part.numerics.mesh_change, &part.numerics.by_modulus,
                                   &part.refinement.unmatched.shift, &part.refinement.unmatched.step_shift,
                                   &part.refinement.unmatched.mesh_change, &part.refinement.unmatched.by_modulus})
        *shift = of_beginnings(std::move(*shift), part.setup);
    part.data = fit_data(part.setup, context.data.trials);
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
