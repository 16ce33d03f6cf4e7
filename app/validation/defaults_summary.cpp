#include "validation/defaults_summary.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "base/text.hpp"
#include "validation/finite_median.hpp"

namespace myo::validation {
namespace {

/// Whether there are numbers and all of them are right.
bool all_right(const std::vector<FittedNumber>& numbers) {
    return !numbers.empty() && std::all_of(numbers.begin(), numbers.end(), is_right);
}

/// Right, with informative standard deviations: a number that is right because its deviation is huge says nothing.
bool all_tell_the_truth(const std::vector<FittedNumber>& numbers) {
    return all_right(numbers) && std::all_of(numbers.begin(), numbers.end(), [](const FittedNumber& n) {
               return n.deviation <= defaults_judgement.max_deviation * std::abs(n.truth);
           });
}

/// A wrong number whose cause is named misleads nobody.
bool counts_as_right(DefaultsAnswer answer) {
    return answer == DefaultsAnswer::right || answer == DefaultsAnswer::cause_named;
}

/// Relative error with the stated deviation, both in percent of the truth: "youngs_modulus 0.31 ± 0.05 %".
std::string number_words(const FittedNumber& n) {
    return n.name + " " + format_number(100.0 * n.error(), 3) + " ± " +
           format_number(100.0 * n.deviation / n.truth, 2) + " %";
}

/// All fitted numbers in words; empty if nothing was fitted.
std::string numbers_words(const DefaultsRecord& r) {
    std::vector<std::string> words;
    for (const FittedNumber& n : r.numbers) words.push_back(number_words(n));
    return join(words, ", ");
}

/// Checks with a remark, each once, the red ones marked.
std::string remark_words(const DefaultsRecord& r) {
    std::vector<std::string> words;
    for (const Remark& remark : r.remarks) {
        const std::string word = remark.check + (remark.wrong ? " (red)" : "");
        if (std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
    }
    return join(words, ", ");
}

/// Refusal, failure and remarks of a case in one phrase.
std::string what_was_said(const DefaultsRecord& r) {
    if (!r.refusal.empty()) return "refused: " + r.refusal;
    return (r.failure.empty() ? "" : "failed: " + r.failure + "; ") + remark_words(r);
}

/// Rates with one-sided confidence bounds, in total, by declaration error and by shape.
report::Table rate_table(const DefaultsSummary& s) {
    report::Table table{"Bounds are one-sided at 95 % (Clopper and Pearson).",
                        {{"What"}, {"Cases"}, {"Of"}, {"Share", "%", 3}, {"At least", "%", 3}, {"At most", "%", 3}},
                        {}};
    const auto add = [&](const std::string& name, const Proportion& p) {
        table.rows.push_back({name, p.count, p.of, 100.0 * p.share(), 100.0 * p.lower(), 100.0 * p.upper()});
    };
    add("right, or the true cause named", s.right);
    add("wrong without a warning", s.silent);
    add("false alarms", s.false_alarms);
    add("right with half a sampling interval as step, without a slip", s.half_interval_right);
    for (const auto& [slip, p] : s.by_slip) add("right or named, slip: " + slip, p);
    for (const auto& [shape, p] : s.by_shape) add("right or named, " + shape, p);
    return table;
}

/// Cases that are not right, and false alarms.
report::Table case_table(const std::vector<DefaultsRecord>& records) {
    report::Table table{"Cases that are not right, and false alarms.",
                        {{"Case"}, {"Experiment"}, {"Slip"}, {"Answer"}, {"Errors"}, {"Said"}},
                        {}};
    for (const DefaultsRecord& r : records) {
        const DefaultsAnswer answer = judged(r);
        if (counts_as_right(answer) && !is_false_alarm(r)) continue;
        table.rows.push_back({r.number, r.shape + ", " + r.facts, r.slip,
                              is_false_alarm(r) ? "false alarm" : to_string(answer), numbers_words(r),
                              what_was_said(r)});
    }
    return table;
}

}  // namespace

DefaultsSummary defaults_summary(const std::vector<DefaultsRecord>& records) {
    DefaultsSummary s;
    std::vector<double> ratios, fit_s, make_s;
    std::map<std::string, std::pair<double, int>> squares;
    for (const DefaultsRecord& r : records) {
        ++s.cases;
        const DefaultsAnswer answer = judged(r);
        ++s.answers[answer];
        make_s.push_back(r.make_s);
        // Without a truth there is nothing to judge.
        if (answer == DefaultsAnswer::failed && r.truth_dofs == 0) continue;
        const bool right = counts_as_right(answer);
        s.right.add(right);
        s.silent.add(answer == DefaultsAnswer::silent);
        s.by_slip[r.slip.empty() ? "none" : r.slip].add(right);
        s.by_shape[r.shape].add(right);
        if (r.fit_s > 0.0) fit_s.push_back(r.fit_s);
        // The remaining statistics need a correct declaration.
        if (!r.slip.empty()) continue;
        s.false_alarms.add(is_false_alarm(r));
        const bool was_right = all_tell_the_truth(r.with_half_interval);
        s.half_interval_right.add(was_right);
        if (was_right && r.with_half_interval_s > 0.0) {
            ratios.push_back(r.fit_s / r.with_half_interval_s);
            // Times are compared where the cheap step gave the right answer.
            s.twice_the_time_at_most.add(ratios.back() <= 2.0);
        }
        for (const FittedNumber& n : r.numbers) {
            if (!std::isfinite(n.deviation)) continue;
            squares[n.name].first += n.normalised() * n.normalised();
            ++squares[n.name].second;
        }
    }
    for (const auto& [name, sum] : squares) s.normalised_rms[name] = std::sqrt(sum.first / sum.second);
    s.median_time_ratio = finite_median(ratios);
    s.longest_fit_s = fit_s.empty() ? std::numeric_limits<double>::quiet_NaN()
                                    : *std::max_element(fit_s.begin(), fit_s.end());
    s.median_fit_s = finite_median(fit_s);
    s.median_make_s = finite_median(make_s);
    return s;
}

std::string record_line(const DefaultsRecord& r) {
    char line[160];
    std::snprintf(line, sizeof line, "%5d  %-7s %-24s %-13s %4.0f + %3.0f s  ", r.number, r.shape.c_str(),
                  r.slip.c_str(), is_false_alarm(r) ? "FALSE ALARM" : to_string(judged(r)).c_str(), r.make_s, r.fit_s);
    return line + numbers_words(r) + "; rest " + format_number(r.residual_over_noise, 3) + "  " + what_was_said(r) +
           "\n       " + r.facts;
}

std::string summary_text(const DefaultsSummary& s) {
    std::string text = std::to_string(s.cases) + " cases";
    for (const auto& [answer, count] : s.answers) text += ", " + std::to_string(count) + " " + to_string(answer);
    text += "\n\nright, or the true cause named: " + at_least_words(s.right);
    text += "\nwrong without a warning:        " + at_most_words(s.silent);
    text += "\nfalse alarms:                   " + at_most_words(s.false_alarms);
    for (const auto& [slip, p] : s.by_slip) text += "\n  slip " + slip + ": " + at_least_words(p);
    for (const auto& [shape, p] : s.by_shape) text += "\n  " + shape + ": " + at_least_words(p);
    text += "\nerrors over stated deviations, rms:";
    for (const auto& [name, rms] : s.normalised_rms) text += " " + name + " " + format_number(rms, 3);
    text += "\nright with half a sampling interval as step: " + at_least_words(s.half_interval_right);
    text += "\ntime over that with half a sampling interval, where right: median " +
            format_number(s.median_time_ratio, 3) + ", at most twice in " + at_least_words(s.twice_the_time_at_most);
    return text + "\ntime of a fit: median " + format_number(s.median_fit_s, 3) + " s, longest " +
           format_number(s.longest_fit_s, 3) + " s; of making a case: median " + format_number(s.median_make_s, 3) +
           " s";
}

report::Json summary_json(const DefaultsSummary& s) {
    report::Json json{{"cases", s.cases},
                      {"right_or_named", proportion_json(s.right)},
                      {"silent", proportion_json(s.silent)},
                      {"false_alarms", proportion_json(s.false_alarms)},
                      {"half_interval_right", proportion_json(s.half_interval_right)},
                      {"normalised_error_rms", s.normalised_rms},
                      {"median_time_ratio", report::json_number(s.median_time_ratio)},
                      {"twice_the_time_at_most", proportion_json(s.twice_the_time_at_most)},
                      {"median_fit_s", report::json_number(s.median_fit_s)},
                      {"longest_fit_s", report::json_number(s.longest_fit_s)},
                      {"median_make_s", report::json_number(s.median_make_s)}};
    for (const auto& [answer, count] : s.answers) json["answers"][to_string(answer)] = count;
    for (const auto& [slip, p] : s.by_slip) json["by_slip"][slip] = proportion_json(p);
    for (const auto& [shape, p] : s.by_shape) json["by_shape"][shape] = proportion_json(p);
    return json;
}

report::HtmlReport defaults_report(const std::vector<DefaultsRecord>& records, const std::string& command_line) {
    const DefaultsSummary s = defaults_summary(records);
    report::HtmlReport report{.title = "Reliability of the defaults"};
    report.summary = {std::to_string(s.cases) +
                          " random experiments, simulated by another element with mesh and step refined until they "
                          "settle, calibrated with nothing but defaults; a third of them declared with a slip.",
                      "Right: modulus and damping within 2 % and three stated deviations, or a check that names the "
                      "true cause."};
    const auto percent = [](double share) { return format_number(100.0 * share, 3); };
    report.key_figures = {
        {"right or named", percent(s.right.share()), "%", "at least " + percent(s.right.lower()) + " %"},
        {"wrong without a warning", percent(s.silent.share()), "%", "at most " + percent(s.silent.upper()) + " %"},
        {"false alarms", percent(s.false_alarms.share()), "%", "at most " + percent(s.false_alarms.upper()) + " %"},
        {"time", format_number(s.median_time_ratio, 3), "", "over that with half a sampling interval, median"}};
    report.sections.push_back({"Rates", {rate_table(s)}});
    report.sections.push_back(
        {"Cases that were not right", {case_table(records), report::EmbeddedJson{"study", summary_json(s)}}});
    report.footer = command_line;
    return report;
}

}  // namespace myo::validation
