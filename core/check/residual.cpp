#include <algorithm>
#include <cmath>

#include "base/text.hpp"
#include "check/catalogue.hpp"
#include "check/checks.hpp"
#include "report/length.hpp"

namespace myo {
namespace {

/// A model that lacks nothing leaves 1, beside its numerical errors; the noise itself is known to some tens of percent.
constexpr double doubtful_ratio = 1.5, wrong_ratio = 10.0;
/// Numerical errors that raise what is expected by less than this are not worth a word.
constexpr double least_told_rise = 1.1;

/// What was found doubtful so far and may leave a residual, the worst first.
std::vector<Finding> suspects(const std::vector<Finding>& earlier) {
    std::vector<Finding> list;
    for (const CheckLevel level : {CheckLevel::wrong, CheckLevel::doubtful})
        std::copy_if(earlier.begin(), earlier.end(), std::back_inserter(list),
                     [&](const Finding& finding) {
                         const Check* const check = find_check(finding.check);
                         return finding.level == level && check != nullptr && check->explains_residual;
                     });
    return list;
}

}  // namespace

std::vector<Finding> check_residual(const CheckedJob& job) {
    if (job.calibration == nullptr || !std::isfinite(job.run->fit_rms_m)) return {};
    const double noise = mean_noise(job.study), ratio = job.run->fit_rms_m / noise;
    const double numerical = job.calibration->numerical.motion_noise_levels, expected = std::hypot(1.0, numerical);
    const bool numerical_is_seen = expected > least_told_rise;
    Finding finding = fine_finding("", "what the model leaves of the fit trials, " + length_words(job.run->fit_rms_m) +
                                           " rms, is " + format_number(ratio, 3) + " times the noise" +
                                           (numerical_is_seen ? ", of which mesh and step make about " +
                                                                    format_number(numerical, 2)
                                                              : ""));
    finding.figure = ratio;
    finding.threshold = doubtful_ratio * expected;
    if (ratio <= finding.threshold) return {finding};
    finding.level = ratio > wrong_ratio * expected ? CheckLevel::wrong : CheckLevel::doubtful;
    std::vector<std::string> names;
    for (const Finding& suspect : suspects(*job.earlier)) {
        const std::string name = suspect.check + (suspect.subject.empty() ? "" : " (" + suspect.subject + ")");
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    const std::string diagnose = "myoloop diagnose names the effect that is missing";
    finding.way_out = names.empty()
                          ? "nothing that is checked explains it: " + diagnose
                          : "suspected, in this order: " + join(names, ", ") + "; once these are settled, " + diagnose;
    return {finding};
}

}  // namespace myo
