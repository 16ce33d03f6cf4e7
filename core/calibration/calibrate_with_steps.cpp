#include <algorithm>
#include <string>
#include <utility>

#include "base/stopwatch.hpp"
#include "calibration/fit_in_windows.hpp"
#include "calibration/numerical_deviation.hpp"
#include "prediction/shorter_steps.hpp"
#include "prediction/time_step.hpp"

namespace myo::calibration {
namespace {

// Evaluations of this fit and of those that it continues.
int all_evaluations(const Calibration& calibration) {
    return calibration.evaluations() + calibration.earlier_evaluations;
}

/// Makes a fit the continuation of one before it. Where that had several starts, their ends and what they tell of other
/// minima stay in the result; otherwise only its evaluations count.
void continue_from(const Calibration& before, Calibration& next) {
    if (before.settings.starts < 2) {
        next.earlier_evaluations += all_evaluations(before);
        return;
    }
    next.settings.starts = before.settings.starts;
    next.starts.insert(next.starts.begin(), before.starts.begin(), before.starts.end());
    next.earlier_evaluations += before.earlier_evaluations;
    const auto told = [](const Calibration& calibration) {
        return std::count(calibration.warnings.begin(), calibration.warnings.end(), several_minima) > 0;
    };
    if (told(before) && !told(next)) next.warnings.emplace_back(several_minima);
}

/// Fit, repeated with shorter steps as long as the fitted values require them.
Calibration fit_with_chosen_steps(setup::Setup& setup, CalibrationSettings settings, const Progress& progress) {
    Calibration calibration = calibrate(setup, settings, progress);
    if (!prediction::choosable(setup.settings)) return calibration;
    for (int fit = 1; fit < prediction::shorter_steps_policy.max_fits; ++fit) {
        if (!calibration.fit.converged() || progress.cancelled()) break;
        std::vector<setup::TrialStep> steps = prediction::choose_steps(setup, calibration.after.values, progress,
                                                                       &calibration.after);
        // Steps that are hardly shorter would cost a fit and change little.
        if (!prediction::much_shorter(setup, steps)) break;
        prediction::set_shorter_steps(setup, std::move(steps));
        for (std::size_t i = 0; i < calibration.parameters.size(); ++i)
            settings.from[calibration.parameters[i].parameter.name] = calibration.fit.values(
                static_cast<Eigen::Index>(i));
        settings.starts = 1;
        Calibration next = calibrate(setup, settings, progress);
        if (!next.usable()) break;  // cancelled at once: keep the values found with longer steps
        continue_from(calibration, next);
        next.seconds += calibration.seconds;
        calibration = std::move(next);
    }
    return calibration;
}

/// Fit, and a second fit from a start found on the beginning of the trials, in case the first one is shifted by a whole
/// period. The lower cost is kept.
Calibration fit_of_all_periods(setup::Setup& setup, CalibrationSettings settings, const Progress& progress) {
    Calibration calibration = fit_with_chosen_steps(setup, settings, progress);
    if (!calibration.usable() || progress.cancelled()) return calibration;
    const Stopwatch watch;
    const double first_s = calibration.seconds;
    settings.from = start_from_windows(setup, calibration, progress);
    calibration.seconds = first_s + watch.seconds();
    if (settings.from.empty()) return calibration;
    settings.starts = 1;
    // The second fit works on a copy, as its steps may become shorter than those of the first.
    setup::Setup other = setup;
    Calibration again = fit_with_chosen_steps(other, settings, progress);
    // Costs are comparable although the steps may differ: both are sums over the samples of the recording.
    if (again.fit.converged() && again.fit.cost_after < calibration.fit.cost_after) {
        std::swap(calibration, again);
        std::swap(setup, other);
        continue_from(again, calibration);
    } else {
        calibration.earlier_evaluations += all_evaluations(again);
    }
    calibration.seconds = first_s + watch.seconds();
    return calibration;
}

}  // namespace

Calibration calibrate_with_chosen_steps(setup::Setup& setup, CalibrationSettings settings, const Progress& progress) {
    Calibration calibration = fit_of_all_periods(setup, std::move(settings), progress);
    if (!calibration.usable()) return calibration;
    // Only the final fit is analysed: the runs may take up to max_share of its time.
    calibration.numerical = numerical_deviations(setup, calibration, progress);
    calibration.seconds += calibration.numerical.seconds;
    if (!calibration.numerical.message.empty()) calibration.warnings.push_back(calibration.numerical.message);
    return calibration;
}

}  // namespace myo::calibration
