#include "prediction/untested_fit.hpp"

#include "experiment/read_experiment.hpp"
#include "prediction/predict_trials.hpp"

namespace myo::prediction {

Result<void> require_fit_trial(const setup::Setup& setup) {
    if (!trials_with_role(setup, experiment::TrialRole::fit).empty()) return {};
    return experiment::declaration_error(
        setup.experiment, "trial",
        "none has a recording to fit: add one, with role = \"fit\"; trials of role \"simulate\" are only run");
}

std::optional<std::string> untested_fit(const setup::Setup& setup) {
    if (!trials_with_role(setup, experiment::TrialRole::validate).empty()) return std::nullopt;
    return "trial: there is no trial with role \"validate\", so nothing is left to test the fit on";
}

}  // namespace myo::prediction
