#include "backend/short_run.hpp"

#include <algorithm>
#include <limits>

#include "base/stopwatch.hpp"

namespace myo::backend {
namespace {

/// Truncates a trace after its last step not later than `end_s`, up to rounding. Velocities may be absent.
void cut(dynamics::Trace& trace, double end_s) {
    const auto after = std::upper_bound(trace.times_s.begin(), trace.times_s.end(), end_s * (1.0 + 1e-9));
    const auto kept = static_cast<std::size_t>(after - trace.times_s.begin());
    trace.times_s.resize(kept);
    trace.positions.resize(std::min(kept, trace.positions.size()));
    trace.velocities.resize(std::min(kept, trace.velocities.size()));
}

}  // namespace

prediction::SetupRun short_run(const setup::Setup& setup, const prediction::ParameterValues& values, std::size_t trial,
                               double end_s, const Progress& progress) {
    const Stopwatch watch;
    const Eigen::VectorXd& sampled = setup.trials[trial].measured.time_s;
    const Eigen::Index samples = sampled.size();
    // Effects act on the whole trial, and the observation may need slightly later times.
    effect::Affected affected = prediction::affected_trial(setup, trial, values);
    // How much longer than the data the full run is, e.g. for a shifted clock; the short run gets as much.
    const double beyond_s = samples > 0 ? std::max(0.0, affected.options.end_s - sampled(samples - 1)) : 0.0;
    affected.options.end_s = std::min(affected.options.end_s, end_s + beyond_s);
    std::vector<prediction::TrialPrediction> predictions(setup.trials.size());
    prediction::TrialPrediction& prediction = predictions[trial];
    dynamics::Trace trace = dynamics::simulate(affected.model, affected.options, progress);
    // An incomplete trace does not reach all samples up to the end and is not observed.
    if (trace.complete()) {
        prediction = prediction::observe_trial(setup, trial, values, trace);
        const Eigen::Index later = std::count_if(sampled.begin(), sampled.end(),
                                                 [&](double t) { return t > end_s * (1.0 + 1e-9); });
        for (std::vector<Eigen::Matrix3Xd>* tracks : {&prediction.positions_m, &prediction.residual_m})
            for (Eigen::Matrix3Xd& track : *tracks)
                track.rightCols(later).setConstant(std::numeric_limits<double>::quiet_NaN());
    }
    prediction.status = trace.status;
    prediction.message = trace.message;
    cut(trace, end_s);
    prediction.trace = std::move(trace);
    prediction::SetupRun run = prediction::scored_run(setup, values, std::move(predictions), {trial});
    run.seconds = watch.seconds();
    return run;
}

}  // namespace myo::backend
