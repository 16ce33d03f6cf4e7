#include <algorithm>

#include "project/numerical_deviation.hpp"
#include "project/time_step.hpp"

namespace myo {
namespace {

struct RefitPolicy {
    double least_change = 0.85;   // a step shortened by less changes the error by a quarter at most
    int most_fits = 3;            // declared values a factor of a hundred off come to rest after two
};
constexpr RefitPolicy refit_policy;

bool much_shorter(const Study& study, const std::vector<TrialStep>& steps) {
    for (std::size_t t = 0; t < steps.size(); ++t)
        if (steps[t].h_s < refit_policy.least_change * study.trials[t].options.h_s) return true;
    return false;
}

/// The fit, and again with shorter steps where its values ask for them.
Calibration fit_with_chosen_steps(Study& study, CalibrationSettings settings, const Progress& progress) {
    Calibration calibration = calibrate_study(study, settings, progress);
    if (!choosable(study.settings)) return calibration;
    for (int fit = 1; fit < refit_policy.most_fits && calibration.fit.converged() && !progress.cancelled(); ++fit) {
        std::vector<TrialStep> steps = choose_steps(study, calibration.after.values, progress);
        if (!much_shorter(study, steps)) break;
        for (std::size_t t = 0; t < steps.size(); ++t)
            steps[t].h_s = std::min(steps[t].h_s, study.trials[t].options.h_s);
        set_steps(study, std::move(steps));
        for (std::size_t i = 0; i < calibration.parameters.size(); ++i)
            settings.from[calibration.parameters[i].parameter.name] =
                calibration.fit.values(static_cast<Eigen::Index>(i));
        settings.starts = 1;
        const int evaluations = calibration.evaluations() + calibration.earlier_evaluations;
        Calibration next = calibrate_study(study, settings, progress);
        if (!next.usable()) break;   // stopped at once: the values there are were found with longer steps
        next.earlier_evaluations = evaluations;
        next.seconds += calibration.seconds;
        calibration = std::move(next);
    }
    return calibration;
}

}  // namespace

Calibration calibrate_with_chosen_steps(Study& study, CalibrationSettings settings, const Progress& progress) {
    Calibration calibration = fit_with_chosen_steps(study, std::move(settings), progress);
    if (!calibration.usable()) return calibration;
    calibration.numerical = numerical_deviations(study, calibration, progress);
    calibration.seconds += calibration.numerical.seconds;
    if (!calibration.numerical.message.empty()) calibration.warnings.push_back(calibration.numerical.message);
    return calibration;
}

}  // namespace myo
