#include "check/checks.hpp"
#include "project/shared_recordings.hpp"

namespace myo {

std::vector<Finding> check_recordings(const CheckedJob& job) {
    const Experiment& experiment = job.study.experiment;
    std::vector<Finding> findings;
    for (const SharedRecording& shared : shared_recordings(experiment)) {
        Finding finding =
            fine_finding(experiment.trials[shared.validate].name, shared_recording_sentence(experiment, shared));
        finding.level = CheckLevel::doubtful;
        findings.push_back(std::move(finding));
    }
    if (findings.empty()) findings.push_back(fine_finding("", "no trial to predict is one that is fitted"));
    return findings;
}

}  // namespace myo
