#include "base/text.hpp"
#include "calibration/values_at_bounds.hpp"
#include "check/checks.hpp"

namespace myo::check {

std::vector<Finding> check_bounds(const CheckedJob& job) {
    std::vector<Finding> findings;
    if (job.calibration == nullptr) return findings;
    const calibration::Calibration& calibration = *job.calibration;
    for (const calibration::ValueAtBound& at : calibration::values_at_bounds(calibration)) {
        const prediction::ModelParameter& parameter = calibration.parameters[at.parameter];
        Finding finding = passed_finding(parameter.parameter.name,
                                         calibration::bound_sentence(job.setup, calibration, at));
        finding.level = CheckLevel::doubtful;
        finding.figure = at.value;
        finding.threshold = at.bound;
        finding.unit = parameter.unit;
        finding.warned = true;  // bound_sentence() is a warning of the calibration already
        findings.push_back(std::move(finding));
    }
    // Bounds of [[unknown]] that lie outside of what the parameter may have are not used; the finding states which are.
    for (const prediction::ModelParameter& unmet : prediction::unmet_bounds(job.setup)) {
        const auto number = [&](double value) {
            return format_number(value, 3) + (unmet.unit.empty() ? "" : " ") + unmet.unit;
        };
        Finding finding = passed_finding(unmet.parameter.name,
                                         unmet.parameter.name +
                                             ": its bounds in [[unknown]] leave nothing of those that it may "
                                             "have, " +
                                             number(unmet.parameter.lower) + " to " + number(unmet.parameter.upper) +
                                             ", which hold");
        finding.level = CheckLevel::doubtful;
        finding.way_out = "declare bounds within these";
        findings.push_back(std::move(finding));
    }
    // Passed checks are reported as well, with what they found.
    if (findings.empty()) findings.push_back(passed_finding("", "all values lie within their bounds"));
    return findings;
}

}  // namespace myo::check
