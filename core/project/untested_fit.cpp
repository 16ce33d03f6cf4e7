#include "project/untested_fit.hpp"

#include "project/predict_trials.hpp"

namespace myo {

std::optional<std::string> untested_fit(const Study& study) {
    if (!trials_with_role(study, TrialRole::validate).empty()) return std::nullopt;
    return "trial: there is no trial with role \"validate\", so nothing is left to test the fit on";
}

}  // namespace myo
