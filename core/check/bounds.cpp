#include "check/checks.hpp"
#include "project/values_at_bounds.hpp"

namespace myo {

std::vector<Finding> check_bounds(const CheckedJob& job) {
    std::vector<Finding> findings;
    if (job.calibration == nullptr) return findings;
    const Calibration& calibration = *job.calibration;
    for (const ValueAtBound& at : values_at_bounds(calibration)) {
        const StudyParameter& parameter = calibration.parameters[at.parameter];
        Finding finding = fine_finding(parameter.parameter.name, bound_sentence(job.study, calibration, at));
        finding.level = CheckLevel::doubtful;
        finding.figure = at.value;
        finding.threshold = at.bound;
        finding.unit = parameter.unit;
        finding.told = true;
        findings.push_back(std::move(finding));
    }
    if (findings.empty()) findings.push_back(fine_finding("", "all values lie within their bounds"));
    return findings;
}

}  // namespace myo
