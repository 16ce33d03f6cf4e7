#include "experiment/shared_recordings.hpp"

#include <limits>
#include <system_error>

#include "base/files.hpp"

namespace myo::experiment {
namespace {

// Open time windows extend to infinity; windows that only share an end point have at most one sample in common.
bool windows_meet(const TrialDeclaration& a, const TrialDeclaration& b) {
    constexpr double ever = std::numeric_limits<double>::infinity();
    const auto start = [&](const TrialDeclaration& t) { return t.start_s.value_or(-ever); };
    const auto end = [&](const TrialDeclaration& t) { return t.end_s.value_or(ever); };
    return start(a) < end(b) && start(b) < end(a);
}

// Sizes are compared before contents, as traces can be large.
bool is_same_content(const std::filesystem::path& a, const std::filesystem::path& b) {
    std::error_code code;
    // Links and different spellings of one path need no comparison of contents.
    if (std::filesystem::equivalent(a, b, code)) return true;
    const auto size_a = std::filesystem::file_size(a, code);
    if (code) return false;
    const auto size_b = std::filesystem::file_size(b, code);
    if (code || size_a != size_b) return false;
    const Result<std::string> content_a = read_file(a), content_b = read_file(b);
    return content_a && content_b && *content_a == *content_b;
}

}  // namespace

std::vector<SharedRecording> shared_recordings(const Experiment& experiment) {
    std::vector<SharedRecording> found;
    const std::vector<TrialDeclaration>& trials = experiment.trials;
    for (std::size_t v = 0; v < trials.size(); ++v) {
        if (trials[v].role != TrialRole::validate) continue;
        for (std::size_t f = 0; f < trials.size(); ++f) {
            // Contents are compared, not names: a copied file is the same recording.
            if (trials[f].role != TrialRole::fit || !windows_meet(trials[f], trials[v]) ||
                !is_same_content(trials[f].trace, trials[v].trace))
                continue;
            // One fit trial suffices to make the prediction no test.
            found.push_back({f, v});
            break;
        }
    }
    return found;
}

std::string shared_recording_sentence(const Experiment& experiment, const SharedRecording& shared) {
    const TrialDeclaration& fit = experiment.trials[shared.fit];
    const TrialDeclaration& validate = experiment.trials[shared.validate];
    return "trial[" + std::to_string(shared.validate) + "].trace: " + validate.trace.filename().string() +
           " of the validate trial " + validate.name + " is the recording of the fit trial " + fit.name +
           ", so predicting it tests nothing; name a recording that the fit does not use";
}

}  // namespace myo::experiment
