#include "validation/defaults_record.hpp"

#include <algorithm>
#include <cmath>

#include "base/name_table.hpp"
#include "validation/slip.hpp"

namespace myo::validation {
namespace {

constexpr NameTable<DefaultsAnswer, 5> answer_names{{{{DefaultsAnswer::right, "right"},
                                                      {DefaultsAnswer::cause_named, "cause named"},
                                                      {DefaultsAnswer::other_warning, "other warning"},
                                                      {DefaultsAnswer::silent, "silent"},
                                                      {DefaultsAnswer::failed, "failed"}}}};

/// Checks that explain wrong numbers of a correct declaration: discretisation, and data that do not determine them.
const std::vector<std::string> checks_without_slip{"mesh", "markers", "step", "pose", "inside_out", "influence"};

/// Whether a word is in a list.
bool contains(const std::vector<std::string>& list, const std::string& word) {
    return std::find(list.begin(), list.end(), word) != list.end();
}

/// Whether one of these checks did not pass.
bool has_remark(const DefaultsRecord& record, const std::vector<std::string>& checks) {
    return std::any_of(record.remarks.begin(), record.remarks.end(),
                       [&](const Remark& remark) { return contains(checks, remark.check); });
}

/// An undetermined number is right if a check says so.
bool all_right(const DefaultsRecord& record) {
    return !record.numbers.empty() &&
           std::all_of(record.numbers.begin(), record.numbers.end(), [&](const FittedNumber& number) {
               return is_right(number) || (!std::isfinite(number.deviation) && has_remark(record, {"influence"}));
           });
}

/// Fitted numbers as JSON; an undetermined standard deviation is null.
report::Json numbers_json(const std::vector<FittedNumber>& numbers) {
    report::Json list = report::Json::array();
    for (const FittedNumber& n : numbers)
        list.push_back(
            {{"name", n.name}, {"truth", n.truth}, {"value", n.value}, {"std", report::json_number(n.deviation)}});
    return list;
}

/// Inverse of numbers_json(). Throws report::Json::exception.
std::vector<FittedNumber> numbers_of(const report::Json& list) {
    std::vector<FittedNumber> numbers;
    for (const report::Json& n : list)
        numbers.push_back({n.at("name").get<std::string>(), n.at("truth").get<double>(), n.at("value").get<double>(),
                           n.at("std").is_null() ? std::nan("") : n.at("std").get<double>()});
    return numbers;
}

}  // namespace

bool is_right(const FittedNumber& number) {
    // Without a deviation only the relative tolerance counts.
    const double deviation = std::isfinite(number.deviation) ? number.deviation : 0.0;
    return std::abs(number.value - number.truth) <=
           defaults_judgement.relative * std::abs(number.truth) + defaults_judgement.deviations * deviation;
}

std::string to_string(DefaultsAnswer answer) { return answer_names.name(answer); }

// Order matters: a refusal ends the judgement; right numbers outweigh remarks; then the named cause decides.
DefaultsAnswer judged(const DefaultsRecord& record) {
    const Slip* const slip = find_slip(record.slip);
    if (!record.refusal.empty()) {
        const bool named = slip != nullptr && !slip->refusal.empty() &&
                           record.refusal.find(slip->refusal) != std::string::npos;
        return named ? DefaultsAnswer::cause_named : DefaultsAnswer::other_warning;
    }
    // A refusal was judged above; from here on something was fitted, or the fit failed.
    const std::vector<std::string>& causes = slip != nullptr ? slip->checks : checks_without_slip;
    if (all_right(record)) return DefaultsAnswer::right;
    if (has_remark(record, causes)) return DefaultsAnswer::cause_named;
    if (!record.failure.empty() || record.numbers.empty()) return DefaultsAnswer::failed;
    return record.remarks.empty() ? DefaultsAnswer::silent : DefaultsAnswer::other_warning;
}

bool is_false_alarm(const DefaultsRecord& record) {
    if (!record.slip.empty()) return false;
    if (!record.refusal.empty()) return true;
    if (judged(record) != DefaultsAnswer::right) return false;
    return std::any_of(record.remarks.begin(), record.remarks.end(), [&](const Remark& remark) {
        // A remark about parameters that the data do not determine is justified.
        const bool undetermined = std::any_of(record.numbers.begin(), record.numbers.end(),
                                              [](const FittedNumber& n) { return !std::isfinite(n.deviation); });
        return !(remark.check == "influence" && undetermined);
    });
}

report::Json record_json(const DefaultsRecord& r) {
    report::Json json{{"case", r.number},
                      {"shape", r.shape},
                      {"slip", r.slip},
                      {"facts", r.facts},
                      {"length_m", r.length_m},
                      {"modulus_Pa", r.modulus_Pa},
                      {"poissons_ratio", r.poissons_ratio},
                      {"frequency_Hz", r.frequency_Hz},
                      {"rate_Hz", r.rate_Hz},
                      {"dofs", r.dofs},
                      {"truth_dofs", r.truth_dofs},
                      {"failure", r.failure},
                      {"refusal", r.refusal},
                      {"numbers", numbers_json(r.numbers)},
                      {"remarks", report::Json::array()},
                      {"residual_over_noise", report::json_number(r.residual_over_noise)},
                      {"make_s", r.make_s},
                      {"fit_s", r.fit_s},
                      {"with_half_interval", numbers_json(r.with_half_interval)},
                      {"with_half_interval_s", r.with_half_interval_s}};
    for (const Remark& remark : r.remarks)
        json["remarks"].push_back({{"check", remark.check},
                                   {"level", remark.wrong ? "red" : "amber"},
                                   {"subject", remark.subject},
                                   {"sentence", remark.sentence}});
    return json;
}

Result<DefaultsRecord> defaults_record_from_json(const report::Json& json) {
    try {
        DefaultsRecord r;
        r.number = json.at("case").get<int>();
        r.shape = json.at("shape").get<std::string>();
        r.slip = json.at("slip").get<std::string>();
        r.facts = json.at("facts").get<std::string>();
        r.length_m = json.at("length_m").get<double>();
        r.modulus_Pa = json.at("modulus_Pa").get<double>();
        r.poissons_ratio = json.at("poissons_ratio").get<double>();
        r.frequency_Hz = json.at("frequency_Hz").get<double>();
        r.rate_Hz = json.at("rate_Hz").get<double>();
        r.dofs = json.at("dofs").get<int>();
        r.truth_dofs = json.at("truth_dofs").get<int>();
        r.failure = json.at("failure").get<std::string>();
        r.refusal = json.at("refusal").get<std::string>();
        r.numbers = numbers_of(json.at("numbers"));
        for (const report::Json& remark : json.at("remarks"))
            r.remarks.push_back({remark.at("check").get<std::string>(), remark.at("subject").get<std::string>(),
                                 remark.at("sentence").get<std::string>(), remark.at("level") == "red"});
        const report::Json& residual = json.at("residual_over_noise");
        r.residual_over_noise = residual.is_null() ? std::nan("") : residual.get<double>();
        r.make_s = json.at("make_s").get<double>();
        r.fit_s = json.at("fit_s").get<double>();
        r.with_half_interval = numbers_of(json.at("with_half_interval"));
        r.with_half_interval_s = json.at("with_half_interval_s").get<double>();
        return r;
    } catch (const report::Json::exception& error) {
        return Error{error.what(), ""};
    }
}

}  // namespace myo::validation
