#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "check/catalogue.hpp"
#include "check/checks.hpp"
#include "report/length.hpp"

namespace myo::check {
namespace {

struct ResidualPolicy {
    /// Residual rms over expected rms. A complete model leaves 1, apart from numerical errors; the noise itself is
    /// known to some tens of percent.
    double doubtful_ratio = 1.5;
    double wrong_ratio = 10.0;
    /// Numerical errors that raise the expected residual by less than this factor are not mentioned.
    double min_reported_rise = 1.1;
};
constexpr ResidualPolicy residual_policy;

/// Earlier violated or doubtful findings that can cause a residual, worst first.
std::vector<Finding> suspects(const std::vector<Finding>& earlier) {
    std::vector<Finding> list;
    for (const CheckLevel level : {CheckLevel::wrong, CheckLevel::doubtful})
        std::copy_if(earlier.begin(), earlier.end(), std::back_inserter(list), [&](const Finding& finding) {
            const Check* const check = find_check(finding.check);
            return finding.level == level && check != nullptr && !check->cause.empty();
        });
    return list;
}

/// Causes that are suspected, with their subjects, each once, in order of severity.
std::string suspect_names(const std::vector<Finding>& earlier) {
    std::vector<std::string> names;
    for (const Finding& suspect : suspects(earlier)) {
        const std::string name = find_check(suspect.check)->cause +
                                 (suspect.subject.empty() ? "" : " (" + suspect.subject + ")");
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    return join(names, ", ");
}

/// Level of a residual, in noise levels, relative to the expected one.
Finding judged_residual(const std::string& sentence, double ratio, double expected) {
    Finding finding = passed_finding("", sentence);
    finding.figure = ratio;
    // Relative to what noise and numerical errors leave even if the model is complete.
    finding.threshold = residual_policy.doubtful_ratio * expected;
    if (ratio > finding.threshold)
        finding.level = ratio > residual_policy.wrong_ratio * expected ? CheckLevel::wrong : CheckLevel::doubtful;
    return finding;
}

/// Residual rms over all completed trials [m].
double rms_of_all(const prediction::SetupRun& run) {
    std::vector<Eigen::Matrix3Xd> all;
    for (const prediction::TrialPrediction& prediction : run.predictions)
        if (prediction.ok()) all.insert(all.end(), prediction.residual_m.begin(), prediction.residual_m.end());
    return prediction::rms(all);
}

/// "0.3 mm rms, is 2.5 times the noise", the end of a sentence on a residual.
std::string beside_noise(double rms_m, double ratio) {
    return report::length_words(rms_m) + " rms, is " + format_number(ratio, 3) + " times the noise";
}

/// Residual of a run with the declared values: the remedy is a fit.
std::vector<Finding> of_declared_values(const CheckedJob& job) {
    // Nothing was fitted, so trials of both roles test the declared values.
    const double left = rms_of_all(*job.run);
    if (!std::isfinite(left)) return {};
    const double ratio = left / setup::mean_noise(job.setup);
    Finding finding = judged_residual(
        "the residual of the recordings with the declared values, " + beside_noise(left, ratio), ratio, 1.0);
    if (finding.level == CheckLevel::passed) return {finding};
    finding.sentence += ": nothing was fitted";
    const std::string names = suspect_names(*job.earlier);
    finding.way_out = (names.empty() ? "" : "suspected, in this order: " + names + "; once these are settled, ") +
                      (prediction::free_parameters(job.setup).empty()
                           ? "name the unknown parameters (material.calibrate, or Unknown in the window), and "
                           : "") +
                      "calibrate finds the values that fit (myoloop calibrate, or Fit in the window)";
    return {finding};
}

/// Residual of the fit trials after a fit: the remedy is a diagnosis, unless earlier findings explain it.
std::vector<Finding> of_fit(const CheckedJob& job) {
    if (!std::isfinite(job.run->fit_rms_m)) return {};
    const double ratio = job.run->fit_rms_m / setup::mean_noise(job.setup);
    // Noise and numerical errors are independent, so the expected residual is the root of the sum of squares.
    const double numerical = job.calibration->numerical.motion_noise_levels, expected = std::hypot(1.0, numerical);
    std::string sentence = "the residual of the fit trials, " + beside_noise(job.run->fit_rms_m, ratio);
    if (expected > residual_policy.min_reported_rise)
        sentence += ", of which mesh and step make about " + format_number(numerical, 2);
    Finding finding = judged_residual(sentence, ratio, expected);
    if (finding.level == CheckLevel::passed) return {finding};
    const std::string names = suspect_names(*job.earlier);
    const std::string
        diagnose = "diagnose names the effect that is missing (myoloop diagnose, or Diagnose in the window)";
    finding.way_out = names.empty() ? "no check explains it: " + diagnose
                                    : "suspected, in this order: " + names + "; once these are settled, " + diagnose;
    return {finding};
}

}  // namespace

std::vector<Finding> check_residual(const CheckedJob& job) {
    // A run with other values, as after a search for signals, gives no finding.
    if (job.calibration != nullptr) return of_fit(job);
    return job.as_declared ? of_declared_values(job) : std::vector<Finding>{};
}

}  // namespace myo::check
