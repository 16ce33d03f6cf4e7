#include "validation/validation_summary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text.hpp"
#include "validation/finite_median.hpp"

namespace myo::validation {
namespace {

/// Tolerances of parameters, and the residual in noise levels below which a trial counts as explained.
constexpr double good_relative = 0.1, good_place_m = 5e-3, explained_over_noise = 1.3;
/// Bins are narrower near 1, where stated confidences accumulate.
constexpr double bin_edges[] = {0.0, 0.5, 0.7, 0.85, 0.95, 1.0};

/// Share of right answers per confidence bin; the last bin includes 1.
std::vector<ConfidenceBin> reliability_of(const std::vector<CaseRecord>& records) {
    std::vector<ConfidenceBin> bins;
    for (std::size_t i = 0; i + 1 < std::size(bin_edges); ++i) {
        ConfidenceBin bin{bin_edges[i], bin_edges[i + 1], 0.0, {}};
        double sum = 0.0;
        for (const CaseRecord& record : records) {
            const bool last = i + 2 == std::size(bin_edges);
            // A confidence that is not stated falls into no bin.
            if (!record.answered() || !(record.confidence >= bin.from) ||
                (last ? record.confidence > bin.to : record.confidence >= bin.to))
                continue;
            bin.right.add(record.right());
            sum += record.confidence;
        }
        bin.mean = bin.right.of > 0 ? sum / bin.right.of : std::numeric_limits<double>::quiet_NaN();
        bins.push_back(bin);
    }
    return bins;
}

/// Expected calibration error: mean distance of confidence and share of right answers, weighted by the cases of a bin.
double calibration_error_of(const std::vector<ConfidenceBin>& bins) {
    double sum = 0.0, count = 0.0;
    for (const ConfidenceBin& bin : bins) {
        if (bin.right.of == 0) continue;
        sum += bin.right.of * std::abs(bin.mean - bin.right.share());
        count += bin.right.of;
    }
    return count > 0.0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

/// Median error and share of good values per effect and parameter.
std::vector<ParameterQuality> qualities_of(const std::vector<CaseRecord>& records) {
    std::map<std::pair<std::string, std::string>, std::vector<ParameterError>> all;
    for (const CaseRecord& record : records)
        for (const ParameterError& error : record.errors) all[{error.effect, error.name}].push_back(error);
    std::vector<ParameterQuality> list;
    for (const auto& [name, errors] : all) {
        ParameterQuality quality{name.first, name.second, 0.0, is_place(name.second), {}};
        std::vector<double> sizes;
        for (const ParameterError& error : errors) {
            // No error is relative to a truth of 0.
            if (!quality.is_place && std::isnan(error.relative)) continue;
            sizes.push_back(quality.is_place ? error.absolute : error.relative);
            quality.good.add(sizes.back() <= (quality.is_place ? good_place_m : good_relative));
        }
        if (sizes.empty()) continue;
        quality.median = finite_median(sizes);
        list.push_back(quality);
    }
    return list;
}

}  // namespace

ValidationSummary validation_summary(const std::vector<CaseRecord>& records) {
    ValidationSummary s;
    std::vector<double> before, after, diagnose_s, make_s;
    for (const CaseRecord& record : records) {
        ++s.cases;
        ++s.families[record.family + (record.muscles ? " with muscles" : "")];
        // Failed cases count in no rate.
        if (!record.answered()) {
            ++s.failed;
            continue;
        }
        diagnose_s.push_back(record.diagnose_s);
        make_s.push_back(record.make_s);
        ++s.confusion[record.kind == CaseKind::deleted ? "(" + record.truth + ")" : record.truth]
                     [join(record.answer, " + ")];
        // An answered record has at least one entry.
        const bool says_none = record.answer.front() == "none", says_unknown = record.answer.front() == "unknown";
        if (record.kind == CaseKind::none) s.false_alarms.add(!says_none);
        if (record.kind == CaseKind::deleted) {
            s.unknown.add(says_unknown);
            // Another effect that predicts the held-out trial within the noise cannot be refuted by this experiment.
            const bool mimicked = !says_unknown && !says_none && record.after_over_noise <= explained_over_noise;
            s.mimicked.add(mimicked);
            if (!mimicked) s.unknown_unmimicked.add(says_unknown);
        }
        if (record.kind != CaseKind::named) continue;
        s.missed.add(says_none);
        // Sets are counted apart, see set_summary().
        if (record.members().size() > 1) continue;
        s.top_1.add(record.right());
        s.top_2.add(record.right_within(2));
        s.in_group.add(record.right_or_grouped());
        // Separable: no other effect is declared indistinguishable.
        if (!record.grouped()) {
            s.separable_top_1.add(record.right());
            s.separable_top_2.add(record.right_within(2));
        }
        if (record.right()) {
            before.push_back(record.before_over_noise);
            after.push_back(record.after_over_noise);
        }
    }
    s.sets = set_summary(records);
    s.parameters = qualities_of(records);
    // Sum over all parameters: a value counts once, however many parameters an effect has.
    for (const ParameterQuality& quality : s.parameters) {
        s.parameters_good.count += quality.good.count;
        s.parameters_good.of += quality.good.of;
    }
    s.reliability = reliability_of(records);
    s.calibration_error = calibration_error_of(s.reliability);
    s.validation_before = finite_median(before);
    s.validation_after = finite_median(after);
    s.median_diagnose_s = finite_median(diagnose_s);
    s.longest_diagnose_s = diagnose_s.empty() ? std::numeric_limits<double>::quiet_NaN()
                                              : *std::max_element(diagnose_s.begin(), diagnose_s.end());
    s.median_make_s = finite_median(make_s);
    return s;
}

std::string summary_text(const ValidationSummary& s) {
    std::string text = std::to_string(s.cases) + " cases";
    for (const auto& [family, count] : s.families) text += ", " + std::to_string(count) + " " + family;
    if (s.failed > 0) text += "; " + std::to_string(s.failed) + " of them failed";
    text += "\n\nright first:            " + at_least_words(s.top_1);
    text += "\nright among two:        " + at_least_words(s.top_2);
    text += "\n  where separable:      " + at_least_words(s.separable_top_1) + "; among two " +
            at_least_words(s.separable_top_2);
    text += "\n  right or of its group: " + at_least_words(s.in_group);
    text += "\nmissed effects:         " + at_most_words(s.missed);
    text += "\nfalse alarms:           " + at_most_words(s.false_alarms);
    text += "\ndeleted -> unknown:     " + at_least_words(s.unknown) +
            "; mimicked by another within 1.3 noise levels: " + std::to_string(s.mimicked.count);
    text += "\n  where not mimicked:   " + at_least_words(s.unknown_unmimicked);
    text += "\n" + set_summary_text(s.sets);
    text += "\nparameters within 10 %, places within 5 mm: " + at_least_words(s.parameters_good);
    text += "\nheld-out trial, medians: " + format_number(s.validation_before, 3) + " -> " +
            format_number(s.validation_after, 3) + " noise levels";
    text += "\ncalibration error:      " + format_number(s.calibration_error, 3);
    for (const ConfidenceBin& bin : s.reliability)
        if (bin.right.of > 0)
            text += "\n  confidence " + format_number(bin.from, 3) + " ... " + format_number(bin.to, 3) + " (mean " +
                    format_number(bin.mean, 3) + "): right " + at_least_words(bin.right);
    text += "\n\ntruth -> answers";
    for (const auto& [truth, answers] : s.confusion) {
        text += "\n  " + truth + ":";
        for (const auto& [answer, count] : answers) text += "  " + answer + " " + std::to_string(count);
    }
    text += "\n\ntime of a diagnosis on one thread: median " + format_number(s.median_diagnose_s, 3) + " s, longest " +
            format_number(s.longest_diagnose_s, 3) + " s; of making a case: median " +
            format_number(s.median_make_s, 3) + " s";
    return text;
}

report::Json summary_json(const ValidationSummary& s) {
    report::Json json{{"cases", s.cases}, {"failed", s.failed}, {"families", s.families}};
    json["top_1"] = proportion_json(s.top_1);
    json["top_2"] = proportion_json(s.top_2);
    json["separable_top_1"] = proportion_json(s.separable_top_1);
    json["separable_top_2"] = proportion_json(s.separable_top_2);
    json["right_or_of_its_group"] = proportion_json(s.in_group);
    json["missed"] = proportion_json(s.missed);
    json["false_alarms"] = proportion_json(s.false_alarms);
    json["deleted_unknown"] = proportion_json(s.unknown);
    json["deleted_mimicked"] = proportion_json(s.mimicked);
    json["deleted_unknown_unmimicked"] = proportion_json(s.unknown_unmimicked);
    json["parameters_good"] = proportion_json(s.parameters_good);
    json["sets"] = set_summary_json(s.sets);
    // Places have their error in m, all others relative to the truth.
    json["parameters"] = report::Json::array();
    for (const ParameterQuality& q : s.parameters)
        json["parameters"].push_back(
            {{"effect", q.effect},
             {"parameter", q.parameter},
             {q.is_place ? "median_distance_m" : "median_relative", report::json_number(q.median)},
             {"good", proportion_json(q.good)}});
    json["confusion"] = s.confusion;
    json["reliability"] = report::Json::array();
    for (const ConfidenceBin& bin : s.reliability)
        json["reliability"].push_back({{"from", bin.from},
                                       {"to", bin.to},
                                       {"mean_confidence", report::json_number(bin.mean)},
                                       {"right", proportion_json(bin.right)}});
    json["calibration_error"] = report::json_number(s.calibration_error);
    json["validation_before_over_noise"] = report::json_number(s.validation_before);
    json["validation_after_over_noise"] = report::json_number(s.validation_after);
    json["median_diagnose_s"] = report::json_number(s.median_diagnose_s);
    json["longest_diagnose_s"] = report::json_number(s.longest_diagnose_s);
    json["median_make_s"] = report::json_number(s.median_make_s);
    return json;
}

}  // namespace myo::validation
