#include "loop/fit_declared.hpp"

#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "loop/judge.hpp"
#include "loop/settle.hpp"
#include "project/predict_trials.hpp"

namespace myo {
namespace {

/// The step is doubled for all that follows when that changes the predictions by less, in units of the noise.
constexpr double step_doubt = 1.0;
constexpr Effort declared_effort{30};
/// A run that takes so many times the iterations of the declared fit's is given up: its numbers are absurd.
constexpr int absurd_run = 4;

/// Doubles the step where that is no matter: its error is taken off anyway.
bool lengthen_step(DiagnosisWork& work) {
    if (work.study.settings.h_s) return false;
    const StudyValues values = declared_values(work.study);
    Study longer = work.study;
    for (StudyTrial& trial : longer.trials) trial.options.h_s *= 2.0;
    const FitData& data = work.result.data;
    const std::vector<TrialPrediction> fine = predict_trials_with(work.study, values, data.trials, work.progress);
    const std::vector<TrialPrediction> coarse = predict_trials_with(longer, values, data.trials, work.progress);
    if (!all_ok(fine) || !all_ok(coarse)) return false;
    const Eigen::VectorXd change = flat_residual(data, coarse) - flat_residual(data, fine);
    if (change.norm() > step_doubt * std::sqrt(static_cast<double>(change.size()))) return false;
    work.study = std::move(longer);
    work.result.step_factor = 2.0;
    for (std::size_t t = 0; t < work.study.trials.size(); ++t) work.serial.trials[t].options.h_s = work.study.trials[t].options.h_s;
    work.result.notes.push_back("steps of " + format_number(1e3 * work.study.trials.front().options.h_s, 4) + " ms, whose error is taken off");
    return true;
}

bool fail(DiagnosisWork& work, const std::string& why) {
    work.result.failure = why;
    return false;
}

}  // namespace

bool fit_declared(DiagnosisWork& work) {
    Diagnosis& result = work.result;
    result.data = fit_data(work.study, trials_with_role(work.study, TrialRole::fit));
    result.noise_m = std::sqrt(result.data.noise_m.squaredNorm() / static_cast<double>(std::max<Eigen::Index>(1, result.data.noise_m.size())));
    if (result.data.layout.size() == 0) return fail(work, "no sample of a fit trial can be compared");
    work.stage("step", 2 * work.fit_count(), [&] { return lengthen_step(work); });
    if (work.progress.cancelled()) return false;
    JointFit declared = work.fit("declared fit", declared_values(work.study), declared_effort);
    if (work.progress.cancelled()) return false;
    if (!declared.usable()) return fail(work, "the declared model cannot be run: " + declared.report.message);
    for (std::size_t i = 0; i < result.data.trials.size(); ++i) {
        const std::size_t t = result.data.trials[i];
        work.study.trials[t].options.most_iterations = work.serial.trials[t].options.most_iterations = absurd_run * declared.predictions[i].trace.newton_iterations;
    }
    result.declared = judged(result.data, std::move(declared), result.settings);
    if (!settle(work, result.declared, "declared fit", settled_declared)) return false;
    if (!result.declared.numerics) result.declared.numerics.emplace();
    result.numerics = *result.declared.numerics;
    return true;
}

}  // namespace myo
