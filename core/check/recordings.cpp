#include "check/checks.hpp"
#include "experiment/shared_recordings.hpp"

namespace myo::check {

std::vector<Finding> check_recordings(const CheckedJob& job) {
    const experiment::Experiment& experiment = job.setup.experiment;
    std::vector<Finding> findings;
    // One finding per validation trial; the sentence contains the remedy.
    for (const experiment::SharedRecording& shared : experiment::shared_recordings(experiment)) {
        Finding finding = passed_finding(experiment.trials[shared.validate].name,
                                         experiment::shared_recording_sentence(experiment, shared));
        finding.level = CheckLevel::doubtful;
        findings.push_back(std::move(finding));
    }
    if (findings.empty()) findings.push_back(passed_finding("", "no trial to predict is one that is fitted"));
    return findings;
}

}  // namespace myo::check
