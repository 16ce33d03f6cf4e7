#include "planning/planned_trials.hpp"

#include <algorithm>

#include "diagnosis/discretisation/longer_steps.hpp"
#include "prediction/predict_trials.hpp"

namespace myo::planning {

setup::Setup with_planned_trials(setup::Setup setup) {
    const std::vector<experiment::MarkerDeclaration>& markers = setup.experiment.markers.on_body;
    for (setup::PreparedTrial& trial : setup.trials) {
        if (trial.role != experiment::TrialRole::simulate) continue;
        trial.role = experiment::TrialRole::fit;
        // Probes are no markers: no camera sees them.
        for (std::size_t m = 0; m < markers.size(); ++m)
            if (!markers[m].probe) trial.measured.tracks[m].setZero();
    }
    return setup;
}

setup::Setup with_longer_steps(setup::Setup setup, const prediction::ParameterValues& values, double most_change,
                               const Progress& progress) {
    // A step that the user states is kept.
    if (setup.settings.h_s) return setup;
    const diagnosis::LongerSteps longer = diagnosis::longer_steps(setup, values, most_change * setup::mean_noise(setup),
                                                                  progress);
    for (std::size_t t = 0; t < longer.factors.size(); ++t) setup.trials[t].options.h_s *= longer.factors[t];
    return setup;
}

bool has_fit_recording(const setup::Setup& setup) {
    return std::any_of(setup.trials.begin(), setup.trials.end(),
                       [](const setup::PreparedTrial& trial) { return trial.role == experiment::TrialRole::fit; });
}

Result<setup::Setup> with_motion(setup::Setup setup, const prediction::ParameterValues& values,
                                 const Progress& progress) {
    const std::vector<std::size_t> trials = prediction::trials_with_role(setup, experiment::TrialRole::fit);
    const std::vector<prediction::TrialPrediction> made = prediction::predict_trials_with(setup, values, trials,
                                                                                          progress);
    for (std::size_t i = 0; i < trials.size(); ++i) {
        setup::PreparedTrial& trial = setup.trials[trials[i]];
        if (!made[i].ok()) return Error{"cannot be run: " + made[i].message, "trial " + trial.name};
        for (std::size_t m = 0; m < trial.measured.tracks.size(); ++m)
            // The residual is prediction minus measurement: their sum is the prediction, in the frame of the recording.
            trial.measured.tracks[m] += made[i].residual_m[m];
    }
    return setup;
}

}  // namespace myo::planning
