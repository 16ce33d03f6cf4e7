#include "check/checks.hpp"

namespace myo::check {

std::vector<Finding> check_influence(const CheckedJob& job) {
    std::vector<Finding> findings;
    if (job.calibration == nullptr) return findings;
    const calibration::Calibration& calibration = *job.calibration;
    for (std::size_t i = 0; i < calibration.parameters.size(); ++i) {
        // The calibration has already decided by the singular values of its Jacobian; here the result becomes a
        // finding.
        const std::string reason = calibration.undetermined_reason(i);
        if (reason.empty()) continue;
        const std::string& name = calibration.parameters[i].parameter.name;
        Finding finding = passed_finding(name, name + ": " + reason);
        finding.level = CheckLevel::doubtful;
        finding.way_out = "leave it out of the fit, or record a trial that it moves";
        // One of the warnings of the calibration states it.
        finding.warned = true;
        findings.push_back(std::move(finding));
    }
    if (findings.empty()) findings.push_back(passed_finding("", "the data determine every parameter"));
    return findings;
}

}  // namespace myo::check
