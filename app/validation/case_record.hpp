#pragma once

#include <map>
#include <string>
#include <vector>

#include "diagnosis/diagnosis.hpp"
#include "report/json.hpp"
#include "validation/synthetic_experiment.hpp"

namespace myo::validation {

/// One parameter of an effect, as found against its truth.
struct ParameterError {
    std::string name;
    double absolute = 0.0;  // length of the difference, in the parameter's unit
    double relative = 0.0;  // of the truth's length; NaN for places
};

/// What a diagnosis said of a case whose truth is known. A line of a file.
struct CaseRecord {
    int number = 0;
    CaseKind kind = CaseKind::none;
    std::string family;
    bool muscles = false;
    std::string truth;   // id; "none"
    double level = 0.0;  // of the effect, in noise levels
    report::Json truth_parameters = report::Json::object();
    std::vector<std::string> answer;                          // ids asserted, "none" or "unknown" alone
    report::Json answer_parameters = report::Json::object();  // of the first effect asserted
    std::vector<std::string> ranking;                         // its first five
    double confidence = 0.0;
    std::vector<std::string> group;      // effects named as not to be told apart from the truth
    std::vector<ParameterError> errors;  // where the answer is right
    double before_over_noise = 0.0;      // validation trials
    double after_over_noise = 0.0;
    double fit_over_noise = 0.0;  // rms of the fit trials with the answer
    double make_s = 0.0, diagnose_s = 0.0;
    int dofs = 0;  // of the diagnosis
    int attempts = 1;
    std::string failure;  // why there is no answer

    bool answered() const { return failure.empty(); }
    /// What would have been right: the effect's id, "none", or "unknown" for one that was deleted.
    std::string expected() const;
    bool right() const { return answered() && answer.size() == 1 && answer.front() == expected(); }
    /// The right one is among the first `places` of the ranking.
    bool right_within(int places) const;
    bool grouped() const { return !group.empty(); }
    /// The answer is right, or one that this experiment cannot tell from it, and is said not to.
    bool right_or_grouped() const;
};

/// What is told of a diagnosis against the truth.
CaseRecord judged_case(const MadeExperiment& made, const setup::Setup& setup, const diagnosis::Diagnosis& diagnosis);

/// A case that could not be made or diagnosed.
CaseRecord failed_case(const SyntheticCase& drawn, const std::string& failure);

report::Json record_json(const CaseRecord& record);
/// Error: a key is missing or of another type.
Result<CaseRecord> record_from_json(const report::Json& json);

/// How far the parameters of an effect are from its true ones; those that are names are left out. A tilt counts as the
/// vector along its axis.
std::vector<ParameterError> parameter_errors(const effect::EffectDeclaration& truth,
                                             const effect::EffectDeclaration& found);

}  // namespace myo::validation
