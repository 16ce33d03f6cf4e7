#include <algorithm>

#include "check/checks.hpp"
#include "setup/actuator_signals.hpp"
#include "setup/signal_span.hpp"

namespace myo::check {

std::vector<Finding> check_signals(const CheckedJob& job) {
    const setup::Setup& setup = job.setup;
    std::vector<Finding> findings;
    for (const setup::MissedSignal& missed : setup::missed_signals(setup)) {
        Finding finding = passed_finding(setup.trials[missed.trial].name, setup::missed_signal_sentence(setup, missed));
        // Without the actuator's motion a fit would explain the recording by other parameters.
        finding.level = CheckLevel::wrong;
        findings.push_back(std::move(finding));
    }
    if (findings.empty() && !setup::actuator_names(setup.experiment).empty())
        findings.push_back(passed_finding("", "every signal acts within its trial"));
    return findings;
}

}  // namespace myo::check
