#include "backend/shown_run.hpp"

#include <algorithm>
#include <cmath>

#include "backend/fields.hpp"
#include "measurement/rigid_motion.hpp"
#include "prediction/laboratory_trace.hpp"
#include "prediction/prediction.hpp"

namespace myo::backend {

using Eigen::Matrix3Xd;

namespace {

/// Frames of a trace up to `end_s` [s], thinned to about 200 MB. Runs extend beyond the data because the start may
/// shift; body and markers end together.
void add_frames(const dynamics::Trace& trace, double end_s, ui::commands::SimulatedTrial& shown) {
    // Three doubles per node and step.
    const double bytes = 24.0 * static_cast<double>(trace.positions.front().cols() *
                                                    static_cast<Eigen::Index>(trace.positions.size()));
    const auto stride = static_cast<std::size_t>(std::max(1.0, std::ceil(bytes / 2e8)));
    std::vector<double> times;
    for (std::size_t k = 0; k < trace.positions.size(); k += stride) {
        if (k > 0 && trace.times_s[k] > end_s * (1.0 + 1e-9)) break;
        times.push_back(trace.times_s[k]);
        shown.frames.push_back(trace.positions[k]);
    }
    shown.frame_time_s = Eigen::Map<const Eigen::VectorXd>(times.data(), static_cast<Eigen::Index>(times.size()));
}

}  // namespace

ui::commands::RunResult shown_run(const setup::Setup& setup, const prediction::SetupRun& run) {
    ui::commands::RunResult result;
    result.seconds = run.seconds;
    result.problem = run.failure;
    if (setup.integration) result.warnings = setup.integration->warnings;
    std::vector<Matrix3Xd> all;
    for (std::size_t t = 0; t < setup.trials.size(); ++t) {
        const prediction::TrialPrediction& prediction = run.predictions[t];
        ui::commands::SimulatedTrial shown;
        shown.name = setup.trials[t].name;
        result.steps += std::max(0.0, static_cast<double>(prediction.trace.times_s.size()) - 1.0);
        const Eigen::VectorXd& sampled = setup.trials[t].measured.time_s;
        // Frames of the laboratory, where the cameras stand: they differ from those of the model if the mount moves.
        const std::optional<dynamics::Trace> seen = prediction::laboratory_trace(setup, t, run.values,
                                                                                 prediction.trace);
        if (!prediction.trace.positions.empty())
            add_frames(seen ? *seen : prediction.trace,
                       sampled.size() > 0 ? sampled(sampled.size() - 1) : prediction.trace.times_s.back(), shown);
        for (std::size_t m = 0; m < setup.marker_names.size() && prediction.ok(); ++m) {
            // Prediction in the compared form (measurement plus residual), but without gaps.
            Matrix3Xd track = measurement::small_rotation(run.values.rotation_rad) * prediction.positions_m[m];
            // Registration of the run, in radians and metres; small angles.
            track.colwise() += run.values.translation_m;
            if (!setup.trials[t].reference_m.empty())
                track.colwise() += Eigen::Vector3d(setup.experiment.markers.on_body[m].rest_m - prediction.start_m[m]);
            shown.markers.push_back(std::move(track));
            shown.marker_rms_m.push_back(prediction::rms({prediction.residual_m[m]}));
        }
        shown.rms_m = prediction::rms(prediction.residual_m);
        all.insert(all.end(), prediction.residual_m.begin(), prediction.residual_m.end());
        result.trials.push_back(std::move(shown));
    }
    // Over all coordinates of all trials, not a mean of the trials' values.
    result.rms_m = prediction::rms(all);
    // Fields such as stress are evaluated later, on demand, from these models.
    auto models = std::make_shared<RunModels>();
    for (std::size_t t = 0; t < setup.trials.size(); ++t)
        models->trials.push_back(prediction::trial_model(setup, t, run.values));
    result.source = std::move(models);
    return result;
}

void add_vibrations(const std::vector<setup::TrialStep>& seen, ui::commands::RunResult& shown) {
    for (std::size_t t = 0; t < shown.trials.size(); ++t) shown.trials[t].vibration_Hz = seen[t].vibration_Hz;
}

}  // namespace myo::backend
