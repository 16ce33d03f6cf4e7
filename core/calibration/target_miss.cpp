#include "calibration/target_miss.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/text.hpp"
#include "experiment/actuators.hpp"
#include "experiment/read_trial.hpp"
#include "prediction/trial_goals.hpp"

namespace myo::calibration {
namespace {

using Eigen::Index;

/// Length with three digits for messages.
std::string millimetres(double length_m) { return format_number(1e3 * length_m, 3) + " mm"; }

/// Root mean square over the markers' coordinates at a sample [m]; NaN if none is visible.
double rms_at(const prediction::TrialPrediction& prediction, Index sample) {
    std::vector<Eigen::Matrix3Xd> columns;
    for (const Eigen::Matrix3Xd& residual : prediction.residual_m) columns.emplace_back(residual.col(sample));
    return prediction::rms(columns);
}

}  // namespace

TargetMiss target_miss(const setup::Setup& setup, const prediction::SetupRun& run, const TargetRule& rule) {
    assert(setup.trials.size() == 1 && run.predictions.size() == 1 && run.scores.size() == 1);
    const prediction::TrialPrediction& prediction = run.predictions.front();
    const Eigen::VectorXd& times = setup.trials.front().measured.time_s;
    TargetMiss miss;
    miss.goals = prediction::follows_goals(setup);
    miss.noise_m = setup::mean_noise(setup);
    miss.rms_m = run.fit_rms_m;
    miss.noise_levels = miss.rms_m / miss.noise_m;
    miss.reached = miss.noise_levels <= rule.reached;

    std::vector<prediction::MarkerScore> markers = run.scores.front().markers;
    std::erase_if(markers, [](const prediction::MarkerScore& marker) { return !std::isfinite(marker.rms_m); });
    // Worst markers first; only those close to the worst are named.
    std::sort(markers.begin(), markers.end(),
              [](const prediction::MarkerScore& a, const prediction::MarkerScore& b) { return a.rms_m > b.rms_m; });
    for (const prediction::MarkerScore& marker : markers)
        if (miss.markers.size() < rule.max_markers && marker.rms_m >= rule.near_worst * markers.front().rms_m)
            miss.markers.push_back({marker.name, marker.rms_m});

    // Error over time, rms over the markers at each sample.
    Eigen::VectorXd course(times.size());
    for (Index t = 0; t < times.size(); ++t) course(t) = rms_at(prediction, t);
    Index worst = -1;
    for (Index t = 0; t < course.size(); ++t)
        if (std::isfinite(course(t)) && (worst < 0 || course(t) > course(worst))) worst = t;
    if (worst < 0) return miss;
    // The interval around the worst sample extends over occluded samples, but begins and ends at visible ones.
    const auto near = [&](Index t) {
        return !std::isfinite(course(t)) || course(t) >= rule.near_worst * course(worst);
    };
    Index from = worst, until = worst;
    for (Index t = worst; t >= 0 && near(t); --t)
        if (std::isfinite(course(t))) from = t;
    for (Index t = worst; t < course.size() && near(t); ++t)
        if (std::isfinite(course(t))) until = t;
    miss.worst_s = times(worst);
    miss.worst_rms_m = course(worst);
    miss.from_s = times(from);
    miss.until_s = times(until);
    return miss;
}

std::string sentence(const TargetMiss& miss, double before_rms_m) {
    std::vector<std::string> names;
    for (const TargetMiss::Marker& marker : miss.markers)
        names.push_back(marker.name + " (" + millimetres(marker.rms_m) + ")");
    // Goals have no noise to compare with.
    const std::string levels = miss.goals ? ""
                                          : ", " + format_number(miss.noise_levels, 3) + " times the noise of " +
                                                millimetres(miss.noise_m);
    return std::string(miss.goals ? "the goals are" : "the target is") + " not reached: " + millimetres(miss.rms_m) +
           " rms of " + millimetres(before_rms_m) + " are left" + levels + "; farthest off " +
           (names.size() > 1 ? "are " : "is ") + join(names) + ", most from " + format_number(miss.from_s, 3) +
           " s to " + format_number(miss.until_s, 3) + " s (" + millimetres(miss.worst_rms_m) + " at " +
           format_number(miss.worst_s, 3) + " s)";
}

bool level_is_on_record(const experiment::Experiment& experiment, const experiment::TrialDeclaration& trial,
                        std::size_t actuator) {
    if (trial.actuation || (actuator < experiment.muscles.size() && experiment.muscles[actuator].signal)) return true;
    const std::string name = experiment::actuators(experiment)[actuator].name;
    return std::any_of(trial.actuation_steps.begin(), trial.actuation_steps.end(),
                       [&](const experiment::ActuationStep& step) { return step.muscle == name; }) ||
           std::any_of(trial.constant_commands.begin(), trial.constant_commands.end(),
                       [&](const experiment::ConstantCommand& command) { return command.actuator == name; });
}

std::optional<std::string> start_miss(const setup::Setup& setup, const inverse::ActuationProblem& problem,
                                      const prediction::SetupRun& run, const TargetRule& rule) {
    const setup::PreparedTrial& trial = setup.trials.front();
    if (trial.hold) return std::nullopt;  // all its samples are the pose that was sought
    const Eigen::VectorXd& times = trial.measured.time_s;
    // Within a quarter of a knot interval the signals have hardly moved the body.
    Index first = trial.first_sample;
    double off_m = std::nan("");
    for (; first < times.size() && times(first) <= 0.25 / problem.sought.frequency_Hz; ++first)
        if (std::isfinite(off_m = rms_at(run.predictions.front(), first))) break;
    if (!(off_m > rule.same_pose * setup::mean_noise(setup))) return std::nullopt;
    const std::string where = "the target does not begin where the body rests: at t = " +
                              format_number(times(first), 3) + " s its markers are " + millimetres(off_m) +
                              " rms away, " + format_number(off_m / setup::mean_noise(setup), 3) + " times the noise; ";
    // Sought initial levels are a compromise with all later samples; only a miss that is worst at the start counts.
    if (problem.sought.seek_before && off_m < rule.near_worst * target_miss(setup, run, rule).worst_rms_m)
        return std::nullopt;
    if (problem.sought.seek_before)
        return where +
               "no level held before t = 0 brings them there: registration, rest positions, gravity or loads are not "
               "as declared";
    // Levels on record are not sought, so they may be what is wrong.
    if (problem.sought.from_before)
        return where +
               "the levels held before t = 0 are taken from the record of the trial's signals; without one they are "
               "sought";
    return where + "if it was at rest under a level held before t = 0, start = \"equilibrium\" seeks it";
}

}  // namespace myo::calibration
