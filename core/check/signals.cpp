#include <algorithm>

#include "check/checks.hpp"
#include "project/signal_span.hpp"

namespace myo {

std::vector<Finding> check_signals(const CheckedJob& job) {
    const Study& study = job.study;
    std::vector<Finding> findings;
    for (const MissedSignal& missed : missed_signals(study)) {
        Finding finding = fine_finding(study.trials[missed.trial].name, missed_signal_sentence(study, missed));
        finding.level = CheckLevel::wrong;
        findings.push_back(std::move(finding));
    }
    if (findings.empty() && !study.experiment.muscles.empty())
        findings.push_back(fine_finding("", "every signal acts within its trial"));
    return findings;
}

}  // namespace myo
