#include "validation/case_record.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "base/text.hpp"
#include "diagnosis/report/diagnosis_json.hpp"
#include "diagnosis/verdict/probabilities.hpp"
#include "effect/catalogue.hpp"

namespace myo::validation {
namespace {

using Eigen::VectorXd;

constexpr std::size_t kept_places = 5;             // stored entries of a ranking
constexpr std::string_view together_sign = " + ";  // between effects that act together

/// A number or a vector as a vector; empty for names.
VectorXd as_vector(const effect::EffectParameter& value) {
    if (const auto* const number = std::get_if<double>(&value)) return VectorXd::Constant(1, *number);
    if (const auto* const vector = std::get_if<VectorXd>(&value)) return *vector;
    return {};
}

// JSON has no NaN; it is stored as null.
double number_or_nan(const report::Json& json) {
    return json.is_number() ? json.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

/// Whether a 95 % interval of a number holds the truth; empty where there is no such interval.
std::optional<bool> covered(const effect::EffectDeclaration& truth, const std::string& parameter,
                            const report::Json& intervals) {
    const auto value = truth.parameters.find(parameter);
    if (value == truth.parameters.end() || !intervals.contains(parameter)) return {};
    const auto* const number = std::get_if<double>(&value->second);
    const report::Json& interval = intervals.at(parameter);
    if (!number || !interval.is_array() || interval.size() != 2 || !interval[0].is_number() || !interval[1].is_number())
        return {};
    return *number >= interval[0].get<double>() && *number <= interval[1].get<double>();
}

/// Ids of the effects in alphabetical order, joined as CaseRecord::truth.
std::string truth_words(const SyntheticCase& c) {
    std::vector<std::string> ids;
    for (const effect::EffectDeclaration& effect : c.effects) ids.push_back(effect.id);
    std::sort(ids.begin(), ids.end());
    return ids.empty() ? "none" : join(ids, together_sign);
}

/// Errors and coverage of the asserted effects that act.
std::vector<ParameterError> errors_of(const SyntheticCase& c, const diagnosis::Diagnosis& d) {
    std::vector<ParameterError> all;
    for (const effect::EffectDeclaration& found : d.verdict.effects)
        for (const effect::EffectDeclaration& truth : c.effects) {
            if (truth.id != found.id) continue;
            const report::Json intervals = diagnosis::intervals_json(d.augmented.fit, found.id);
            for (ParameterError& error : parameter_errors(truth, found)) {
                error.covered = covered(truth, error.name, intervals);
                all.push_back(std::move(error));
            }
        }
    return all;
}

/// Parameters in a form in which equivalent effects are equal.
effect::EffectParameters comparable(const effect::EffectDeclaration& effect) {
    const effect::Effect* const entry = effect::find_effect(effect.id);
    return entry && entry->comparable ? entry->comparable(effect.parameters) : effect.parameters;
}

}  // namespace

bool is_place(const std::string& parameter) {
    return parameter == "position_m" || parameter == "anchor_m" || parameter == "centre_m";
}

std::vector<std::string> CaseRecord::members() const {
    std::vector<std::string> ids;
    if (truth == "none") return ids;
    std::size_t begin = 0;
    for (std::size_t end = truth.find(together_sign); end != std::string::npos;
         end = truth.find(together_sign, begin)) {
        ids.push_back(truth.substr(begin, end - begin));
        begin = end + together_sign.size();
    }
    ids.push_back(truth.substr(begin));
    return ids;
}

std::vector<std::string> CaseRecord::expected() const {
    if (kind == CaseKind::deleted) return {"unknown"};
    return kind == CaseKind::none ? std::vector<std::string>{"none"} : members();
}

bool CaseRecord::right() const {
    std::vector<std::string> found = answer;
    std::sort(found.begin(), found.end());
    return answered() && found == expected();
}

bool CaseRecord::right_within(int places) const {
    const std::vector<std::string> wanted = expected();
    const auto last = ranking.begin() + std::min<std::ptrdiff_t>(places, static_cast<std::ptrdiff_t>(ranking.size()));
    return answered() && wanted.size() == 1 && std::find(ranking.begin(), last, wanted.front()) != last;
}

bool CaseRecord::right_or_grouped() const {
    if (right()) return true;
    const std::vector<std::string> wanted = expected();
    const auto holds = [](const std::vector<std::string>& ids, const std::string& id) {
        return std::find(ids.begin(), ids.end(), id) != ids.end();
    };
    return answered() && answer.size() == wanted.size() &&
           std::all_of(answer.begin(), answer.end(),
                       [&](const std::string& id) { return holds(wanted, id) || holds(group, id); });
}

std::vector<ParameterError> parameter_errors(const effect::EffectDeclaration& truth,
                                             const effect::EffectDeclaration& found) {
    std::vector<ParameterError> errors;
    const effect::EffectParameters right = comparable(truth), estimated = comparable(found);
    for (const auto& [name, value] : right) {
        const auto other = estimated.find(name);
        // An axis is part of the vector that `comparable` makes, or has no size to compare.
        if (other == estimated.end() || name == "axis") continue;
        const VectorXd a = as_vector(value), b = as_vector(other->second);
        if (a.size() == 0 || a.size() != b.size()) continue;
        const double distance = (b - a).norm();
        errors.push_back(
            {name,
             distance,
             is_place(name) || a.norm() == 0.0 ? std::numeric_limits<double>::quiet_NaN() : distance / a.norm(),
             truth.id,
             {}});
    }
    return errors;
}

CaseRecord judged_case(const MadeExperiment& made, const setup::Setup& setup, const diagnosis::Diagnosis& d) {
    // Starts as a failed case: without a complete diagnosis it remains one.
    CaseRecord record = failed_case(made.truth, d.failure);
    record.level = made.level;
    record.make_s = made.seconds;
    record.attempts = made.attempts;
    record.diagnose_s = d.seconds;
    record.dofs = setup.body->dofs();
    if (!d.complete()) return record;
    if (d.verdict.kind == diagnosis::VerdictKind::none) record.answer = {"none"};
    if (d.verdict.kind == diagnosis::VerdictKind::unknown) record.answer = {"unknown"};
    for (const effect::EffectDeclaration& effect : d.verdict.effects) record.answer.push_back(effect.id);
    if (!d.verdict.effects.empty())
        record.answer_parameters = diagnosis::effect_parameters_json(d.verdict.effects.front().parameters);
    record.ranking.assign(
        d.verdict.ranking.begin(),
        d.verdict.ranking.begin() + static_cast<std::ptrdiff_t>(std::min(kept_places, d.verdict.ranking.size())));
    record.confidence = d.verdict.confidence;
    record.probabilities = diagnosis::effect_probabilities(d);
    // Confusions are symmetric; the group holds the partners of the effects that act.
    for (const std::string& member : record.members())
        for (const diagnosis::Confusion& confusion : d.confusions) {
            if (confusion.first == member) record.group.push_back(confusion.second);
            if (confusion.second == member) record.group.push_back(confusion.first);
        }
    std::sort(record.group.begin(), record.group.end());
    record.group.erase(std::unique(record.group.begin(), record.group.end()), record.group.end());
    if (record.kind == CaseKind::named) record.errors = errors_of(made.truth, d);
    // The true noise, not the estimated one: records of all cases are comparable.
    record.before_over_noise = d.before.validation_rms_m / made.truth.noise_m;
    record.after_over_noise = d.after.validation_rms_m / made.truth.noise_m;
    record.fit_over_noise = d.augmented.rms_m / made.truth.noise_m;
    return record;
}

CaseRecord failed_case(const SyntheticCase& drawn, const std::string& failure) {
    CaseRecord record;
    record.number = drawn.number;
    record.kind = drawn.kind;
    record.family = to_string(drawn.body.family);
    record.muscles = !drawn.muscles.empty();
    record.truth = truth_words(drawn);
    if (drawn.effects.size() == 1)
        record.truth_parameters = diagnosis::effect_parameters_json(drawn.effects.front().parameters);
    else
        for (const effect::EffectDeclaration& effect : drawn.effects)
            record.truth_parameters[effect.id] = diagnosis::effect_parameters_json(effect.parameters);
    record.failure = failure;
    return record;
}

report::Json record_json(const CaseRecord& r) {
    // `right` is for readers of the file; record_from_json() computes it again.
    report::Json json{{"case", r.number},
                      {"kind", to_string(r.kind)},
                      {"family", r.family},
                      {"muscles", r.muscles},
                      {"truth", r.truth}};
    json["level_over_noise"] = report::json_number(r.level);
    json["truth_parameters"] = r.truth_parameters;
    json["answer"] = r.answer;
    json["right"] = r.right();
    json["answer_parameters"] = r.answer_parameters;
    json["ranking"] = r.ranking;
    json["confidence"] = report::json_number(r.confidence);
    json["probabilities"] = report::Json::object();
    for (const auto& [id, probability] : r.probabilities) json["probabilities"][id] = report::json_number(probability);
    json["group"] = r.group;
    json["errors"] = report::Json::array();
    for (const ParameterError& error : r.errors) {
        report::Json entry{{"name", error.name},
                           {"absolute", report::json_number(error.absolute)},
                           {"relative", report::json_number(error.relative)}};
        if (error.effect != r.truth) entry["effect"] = error.effect;
        if (error.covered) entry["covered"] = *error.covered;
        json["errors"].push_back(std::move(entry));
    }
    json["validation_before_over_noise"] = report::json_number(r.before_over_noise);
    json["validation_after_over_noise"] = report::json_number(r.after_over_noise);
    json["fit_over_noise"] = report::json_number(r.fit_over_noise);
    json["make_s"] = report::json_number(r.make_s);
    json["diagnose_s"] = report::json_number(r.diagnose_s);
    json["dofs"] = r.dofs;
    json["attempts"] = r.attempts;
    json["failure"] = r.failure;
    return json;
}

Result<CaseRecord> record_from_json(const report::Json& json) {
    CaseRecord r;
    try {
        r.number = json.at("case").get<int>();
        if (!parse_case_kind(json.at("kind").get<std::string>(), r.kind)) return Error{"not a kind of case", "kind"};
        r.family = json.at("family").get<std::string>();
        r.muscles = json.at("muscles").get<bool>();
        r.truth = json.at("truth").get<std::string>();
        r.level = number_or_nan(json.at("level_over_noise"));
        r.truth_parameters = json.at("truth_parameters");
        r.answer = json.at("answer").get<std::vector<std::string>>();
        r.answer_parameters = json.at("answer_parameters");
        r.ranking = json.at("ranking").get<std::vector<std::string>>();
        r.confidence = number_or_nan(json.at("confidence"));
        r.group = json.at("group").get<std::vector<std::string>>();
        // Records from before sets of effects state no probabilities and no coverage.
        if (json.contains("probabilities"))
            for (const auto& [id, probability] : json.at("probabilities").items())
                r.probabilities[id] = number_or_nan(probability);
        for (const report::Json& error : json.at("errors")) {
            r.errors.push_back({error.at("name").get<std::string>(),
                                number_or_nan(error.at("absolute")),
                                number_or_nan(error.at("relative")),
                                error.value("effect", r.truth),
                                {}});
            if (error.contains("covered")) r.errors.back().covered = error.at("covered").get<bool>();
        }
        r.before_over_noise = number_or_nan(json.at("validation_before_over_noise"));
        r.after_over_noise = number_or_nan(json.at("validation_after_over_noise"));
        r.fit_over_noise = number_or_nan(json.at("fit_over_noise"));
        r.make_s = number_or_nan(json.at("make_s"));
        r.diagnose_s = number_or_nan(json.at("diagnose_s"));
        r.dofs = json.at("dofs").get<int>();
        r.attempts = json.at("attempts").get<int>();
        r.failure = json.at("failure").get<std::string>();
    } catch (const nlohmann::json::exception& broken) {
        return Error{broken.what(), ""};
    }
    return r;
}

}  // namespace myo::validation
