#include "prediction/untested_fit.hpp"

#include "prediction/predict_trials.hpp"

namespace myo::prediction {

std::optional<std::string> untested_fit(const setup::Setup& setup) {
    if (!trials_with_role(setup, experiment::TrialRole::validate).empty()) return std::nullopt;
    return "trial: there is no trial with role \"validate\", so nothing is left to test the fit on";
}

}  // namespace myo::prediction
