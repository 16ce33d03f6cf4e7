#include "diagnosis/selection/judged_fit.hpp"

#include <cmath>
#include <utility>

#include "statistics/linear_cross_validation.hpp"

namespace myo::diagnosis {

JudgedFit judged(const FitData& data, JointFit fit, const DiagnoseSettings& settings) {
    const JudgementPolicy& policy = settings.policy.judgement;
    JudgedFit result;
    if (fit.usable()) {
        statistics::ResidualTestOptions options;
        options.alpha = settings.alpha;
        result.rms_m = flat_rms_m(data, fit.residual);
        result.tests = statistics::test_residuals(fit.residual, data.layout, static_cast<int>(fit.parameters.size()),
                                                  options);
        // Drift is a question only for residuals that need an explanation and are small enough for cameras to drift by.
        const double systematic = result.tests.systematic.rms;
        if (result.tests.significant() && systematic > policy.min_systematic && systematic < policy.max_drift)
            result.independence = statistics::independence_test(fit.residual, data.layout);
        statistics::FoldOptions folds;
        folds.guard_s = policy.guard_s;
        // Linearised: a refit without each trial would cost as many fits as there are trials.
        const statistics::LinearCrossValidation of_trials = statistics::linear_cross_validation(
            fit.residual, fit.jacobian, statistics::make_folds(data.layout, folds));
        result.held_out_rms = std::sqrt(of_trials.mean_square());
        result.single_trial_directions = of_trials.undetermined();
        result.held_out_in_time_rms = std::sqrt(
            statistics::linear_cross_validation(fit.residual, fit.jacobian, statistics::time_folds(data.layout, folds))
                .mean_square());
    }
    result.fit = std::move(fit);
    return result;
}

}  // namespace myo::diagnosis
