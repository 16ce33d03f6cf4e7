#include <utility>

#include "base/stopwatch.hpp"
#include "project/fit_in_windows.hpp"
#include "project/numerical_deviation.hpp"
#include "project/shorter_steps.hpp"
#include "project/time_step.hpp"

namespace myo {
namespace {

int all_evaluations(const Calibration& calibration) {
    return calibration.evaluations() + calibration.earlier_evaluations;
}

/// The fit, and again with shorter steps where its values ask for them.
Calibration fit_with_chosen_steps(Study& study, CalibrationSettings settings, const Progress& progress) {
    Calibration calibration = calibrate_study(study, settings, progress);
    if (!choosable(study.settings)) return calibration;
    for (int fit = 1; fit < shorter_steps_policy.most_fits; ++fit) {
        if (!calibration.fit.converged() || progress.cancelled()) break;
        std::vector<TrialStep> steps = choose_steps(study, calibration.after.values, progress, &calibration.after);
        if (!much_shorter(study, steps)) break;
        set_shorter_steps(study, std::move(steps));
        for (std::size_t i = 0; i < calibration.parameters.size(); ++i)
            settings.from[calibration.parameters[i].parameter.name] =
                calibration.fit.values(static_cast<Eigen::Index>(i));
        settings.starts = 1;
        const int evaluations = all_evaluations(calibration);
        Calibration next = calibrate_study(study, settings, progress);
        if (!next.usable()) break;   // stopped at once: the values there are were found with longer steps
        next.earlier_evaluations = evaluations;
        next.seconds += calibration.seconds;
        calibration = std::move(next);
    }
    return calibration;
}

/// The fit, and once more from where the beginning of the trials leads, should it have taken one period for another.
Calibration fit_of_all_periods(Study& study, CalibrationSettings settings, const Progress& progress) {
    Calibration calibration = fit_with_chosen_steps(study, settings, progress);
    if (!calibration.usable() || progress.cancelled()) return calibration;
    const Stopwatch watch;
    const double first_s = calibration.seconds;
    settings.from = start_from_windows(study, calibration, progress);
    calibration.seconds = first_s + watch.seconds();
    if (settings.from.empty()) return calibration;
    settings.starts = 1;
    Study other = study;
    Calibration again = fit_with_chosen_steps(other, settings, progress);
    if (again.fit.converged() && again.fit.cost_after < calibration.fit.cost_after) {
        std::swap(calibration, again);
        std::swap(study, other);
    }
    calibration.earlier_evaluations += all_evaluations(again);
    calibration.seconds = first_s + watch.seconds();
    return calibration;
}

}  // namespace

Calibration calibrate_with_chosen_steps(Study& study, CalibrationSettings settings, const Progress& progress) {
    Calibration calibration = fit_of_all_periods(study, std::move(settings), progress);
    if (!calibration.usable()) return calibration;
    calibration.numerical = numerical_deviations(study, calibration, progress);
    calibration.seconds += calibration.numerical.seconds;
    if (!calibration.numerical.message.empty()) calibration.warnings.push_back(calibration.numerical.message);
    return calibration;
}

}  // namespace myo
