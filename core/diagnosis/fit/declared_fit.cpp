#include "diagnosis/fit/declared_fit.hpp"

#include <algorithm>
#include <cmath>

#include "diagnosis/diagnosis_policy.hpp"
#include "diagnosis/discretisation/correct_discretisation.hpp"
#include "diagnosis/discretisation/error_finder.hpp"
#include "diagnosis/discretisation/longer_steps.hpp"
#include "diagnosis/selection/judgement.hpp"
#include "prediction/predict_trials.hpp"

namespace myo::diagnosis {
namespace {

/// Lengthens the time steps of all later runs while predictions change by at most most_m [m, rms]. An explicit step
/// (settings.h_s) is kept. Returns true if a step became longer.
bool lengthen_steps(DiagnosisWork& work, double most_m) {
    if (work.setup.settings.h_s) return false;
    const LongerSteps longer = work.stage("step", 0, [&] {
        return longer_steps(work.setup, prediction::declared_values(work.setup), most_m, work.progress);
    });
    work.cost_of("step").runs += longer.runs;
    std::vector<double>& all = work.result.step_factors;
    all.resize(longer.factors.size(), 1.0);
    for (std::size_t t = 0; t < all.size(); ++t) {
        all[t] *= longer.factors[t];
        for (setup::Setup* const setup : {&work.setup, &work.serial}) setup->trials[t].options.h_s *= longer.factors[t];
    }
    return any_longer(longer.factors);
}

/// Lengthens the steps further if the step error remains small compared with the residual of the fit.
void lengthen_steps_for(DiagnosisWork& work, JointFit& fit) {
    const double most_m = diagnosis_policy.numerics.step_change_of_left * flat_rms_m(work.result.data, fit.residual);
    if (most_m > diagnosis_policy.numerics.most_step_change * setup::mean_noise(work.setup) &&
        lengthen_steps(work, most_m))
        forget_paths(fit.predictions);  // they belong to shorter steps
}

bool fail(DiagnosisWork& work, const std::string& why) {
    work.result.failure = why;
    return false;
}

}  // namespace

bool fit_declared(DiagnosisWork& work) {
    Diagnosis& result = work.result;
    result.data = fit_data(work.setup, prediction::trials_with_role(work.setup, experiment::TrialRole::fit));
    result.noise_m = std::sqrt(result.data.noise_m.squaredNorm() /
                               static_cast<double>(std::max<Eigen::Index>(1, result.data.noise_m.size())));
    if (result.data.layout.size() == 0) return fail(work, "no sample of a fit trial can be compared");
    lengthen_steps(work, diagnosis_policy.numerics.most_step_change * setup::mean_noise(work.setup));
    if (work.progress.cancelled()) return false;
    JointFit declared = work.fit("declared fit", prediction::declared_values(work.setup),
                                 diagnosis_policy.declared.effort);
    if (work.progress.cancelled()) return false;
    if (!declared.usable()) return fail(work, "the declared model cannot be run: " + declared.report.message);
    for (std::size_t i = 0; i < result.data.trials.size(); ++i) {
        const std::size_t t = result.data.trials[i];
        work.setup.trials[t]
            .options.max_iterations = work.serial.trials[t]
                                          .options.max_iterations = diagnosis_policy.declared.most_iteration_ratio *
                                                                    declared.predictions[i].trace.newton_iterations;
    }
    lengthen_steps_for(work, declared);
    if (any_longer(result.step_factors))
        result.notes.push_back("steps of " + steps_in_words(work.setup) + ", whose error is taken off");
    result.declared = judged(result.data, std::move(declared), result.settings);
    if (!correct_discretisation(work, result.declared, "declared fit", diagnosis_policy.declared.correction))
        return false;
    if (!result.declared.numerics) result.declared.numerics.emplace();
    result.numerics = *result.declared.numerics;
    return true;
}

}  // namespace myo::diagnosis
