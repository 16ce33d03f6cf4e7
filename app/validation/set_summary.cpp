#include "validation/set_summary.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/text.hpp"

namespace myo::validation {
namespace {

/// Probabilities outside of this range leave nothing open; bins of at least ten of those within, at most ten bins.
constexpr double least_open = 0.05, most_open = 0.95;
constexpr std::size_t bin_count = 10, most_bins = 10;

bool holds(const std::vector<std::string>& ids, const std::string& id) {
    return std::find(ids.begin(), ids.end(), id) != ids.end();
}

/// A stated probability that an effect acts, and whether it does.
struct StatedProbability {
    double probability = 0.0;
    bool acts = false;
};

/// Mean over bins of equal count, weighted by their counts.
double calibration_error_of(std::vector<StatedProbability> stated) {
    if (stated.empty()) return std::numeric_limits<double>::quiet_NaN();
    std::sort(stated.begin(), stated.end(), [](const auto& a, const auto& b) { return a.probability < b.probability; });
    const std::size_t bins = std::clamp(stated.size() / bin_count, std::size_t{1}, most_bins);
    double sum = 0.0;
    for (std::size_t b = 0; b < bins; ++b) {
        double excess = 0.0;
        for (std::size_t i = b * stated.size() / bins; i < (b + 1) * stated.size() / bins; ++i)
            excess += stated[i].probability - (stated[i].acts ? 1.0 : 0.0);
        sum += std::abs(excess);
    }
    return sum / static_cast<double>(stated.size());
}

}  // namespace

SetSummary set_summary(const std::vector<CaseRecord>& records) {
    SetSummary s;
    std::vector<StatedProbability> open;
    for (const CaseRecord& record : records) {
        if (!record.answered() || record.kind == CaseKind::deleted) continue;
        const std::vector<std::string> members = record.members();
        s.exact[static_cast<int>(members.size())].add(record.right());
        bool included = false;
        for (const std::string& id : record.answer) {
            if (id == "none" || id == "unknown") continue;
            s.precision.add(holds(members, id));
            included = included || !holds(members, id);
        }
        s.false_inclusion.add(included);
        for (const std::string& id : members) s.recall.add(holds(record.answer, id));
        for (const ParameterError& error : record.errors)
            if (error.covered) s.covered.add(*error.covered);
        for (const auto& [id, probability] : record.probabilities)
            if (probability >= least_open && probability <= most_open)
                open.push_back({probability, holds(members, id)});
    }
    s.open_probabilities = static_cast<int>(open.size());
    s.probability_error = calibration_error_of(std::move(open));
    return s;
}

std::vector<NamedShare> set_proportions(const SetSummary& s) {
    std::vector<NamedShare> all;
    for (const auto& [size, share] : s.exact)
        all.push_back({"exact where " + (size == 0   ? "no effect acts"
                                         : size == 1 ? "one effect acts"
                                                     : std::to_string(size) + " effects act"),
                       share});
    all.push_back({"asserted effects that act", s.precision});
    all.push_back({"acting effects that are asserted", s.recall});
    all.push_back({"cases with an asserted effect that does not act", s.false_inclusion, true});
    all.push_back({"true numbers within their 95 % intervals", s.covered});
    return all;
}

std::string set_summary_text(const SetSummary& s) {
    std::string text;
    for (const auto& [name, share, is_fault] : set_proportions(s))
        if (share.of > 0)
            text += (text.empty() ? "" : "\n") + name + ": " +
                    (is_fault ? at_most_words(share) : at_least_words(share));
    if (s.open_probabilities > 0)
        text += "\nerror of " + std::to_string(s.open_probabilities) + " probabilities between " +
                format_number(least_open, 2) + " and " + format_number(most_open, 2) + ": " +
                format_number(s.probability_error, 3);
    return text;
}

report::Json set_summary_json(const SetSummary& s) {
    report::Json json;
    for (const auto& [size, share] : s.exact) json["exact"][std::to_string(size)] = proportion_json(share);
    json["precision"] = proportion_json(s.precision);
    json["recall"] = proportion_json(s.recall);
    json["false_inclusion"] = proportion_json(s.false_inclusion);
    json["covered"] = proportion_json(s.covered);
    json["open_probabilities"] = s.open_probabilities;
    json["probability_error"] = report::json_number(s.probability_error);
    return json;
}

}  // namespace myo::validation
