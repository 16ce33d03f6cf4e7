#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/diagnosis.hpp"
#include "report/json.hpp"
#include "validation/synthetic_experiment.hpp"

namespace myo::validation {

/// Error of one parameter of an effect.
struct ParameterError {
    std::string name;
    double absolute = 0.0;        // norm of the difference, in the unit of the parameter
    double relative = 0.0;        // over the norm of the truth; NaN for positions and where the truth is 0
    std::string effect;           // id
    std::optional<bool> covered;  // whether the 95 % interval holds the truth; empty: a vector, or no interval
};
/// Whether a parameter of this name is a position, whose relative error would depend on the choice of the origin.
bool is_place(const std::string& parameter);

/// Answer of a diagnosis to a case with known truth; one JSON line of a file.
struct CaseRecord {
    int number = 0;
    CaseKind kind = CaseKind::none;
    // Body, see to_string(BodyFamily).
    std::string family;
    bool muscles = false;
    std::string truth;   // id of the effect; of several in alphabetical order, "a + b"; "none"
    double level = 0.0;  // size of the effect, of several that of the smallest, in noise levels
    // Parameters of the true effect by name, of several under their ids; empty without an effect.
    report::Json truth_parameters = report::Json::object();
    /// Ids of the asserted effects; or "none" or "unknown" alone.
    std::vector<std::string> answer;
    report::Json answer_parameters = report::Json::object();  // of the first asserted effect
    std::vector<std::string> ranking;                         // first five entries
    double confidence = 0.0;                                  // stated by the verdict, 0 ... 1
    std::map<std::string, double> probabilities;              // that an effect acts, stated by the verdict
    std::vector<std::string> group;                           // effects declared indistinguishable from the truth
    std::vector<ParameterError> errors;                       // of asserted effects that act
    double before_over_noise = 0.0;                           // rms of the validation trials over noise, declared model
    double after_over_noise = 0.0;                            // the same with the answer
    double fit_over_noise = 0.0;                              // rms of the fit trials with the answer, over noise
    double make_s = 0.0, diagnose_s = 0.0;                    // wall-clock times
    int dofs = 0;                                             // of the model that the diagnosis used
    int attempts = 1;                                         // draws until the effect was visible
    std::string failure;                                      // reason for a missing answer

    bool answered() const { return failure.empty(); }
    /// Ids of the effects that act, in alphabetical order; empty for "none".
    std::vector<std::string> members() const;
    /// The right answer: the effects' ids in alphabetical order, "none", or "unknown" for an effect withheld from the
    /// diagnosis.
    std::vector<std::string> expected() const;
    /// Whether the answer is the right one, in any order.
    bool right() const;
    /// Whether the right answer, of a single effect, is among the first `places` of the ranking; five are stored.
    bool right_within(int places) const;
    bool grouped() const { return !group.empty(); }
    /// Whether the answer is right, or each effect of it acts or is declared indistinguishable from one that does.
    bool right_or_grouped() const;
};

/// Compares a diagnosis with the truth.
///
/// @param made       the experiment with its true effect and level
/// @param setup      as the diagnosis received it, read from the folder
/// @return           a failed case if the diagnosis is not complete
CaseRecord judged_case(const MadeExperiment& made, const setup::Setup& setup, const diagnosis::Diagnosis& diagnosis);

/// Record of a case that could not be made or diagnosed.
///
/// @param failure  reason, a sentence for the report
CaseRecord failed_case(const SyntheticCase& drawn, const std::string& failure);

/// JSON form of a record, a line of cases.jsonl; numbers that are not finite are null.
report::Json record_json(const CaseRecord& record);
/// Inverse of record_json(); null becomes NaN. Errors: a key is missing or of another type.
Result<CaseRecord> record_from_json(const report::Json& json);

/// Errors of an effect's parameters, by name; names of markers, trials and the like are skipped. Parameters are
/// compared in the form of Effect::comparable: a tilt counts as the vector along its axis.
///
/// @param truth  the true effect
/// @param found  the same effect as fitted
std::vector<ParameterError> parameter_errors(const effect::EffectDeclaration& truth,
                                             const effect::EffectDeclaration& found);

}  // namespace myo::validation
