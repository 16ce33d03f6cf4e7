#include "planning/power_output.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/text.hpp"
#include "diagnosis/report/diagnosis_json.hpp"
#include "effect/catalogue.hpp"
#include "planning/planning_policy.hpp"
#include "report/length.hpp"

namespace myo::planning {
namespace {

/// "47 %", "<1 %" and ">99 %" near the ends.
std::string percent(double probability) {
    const double hundred = 100.0 * probability;
    if (hundred < 1.0) return "<1 %";
    if (hundred > 99.0) return ">99 %";
    return format_number(std::round(hundred)) + " %";
}

/// Whether the experiment can show the effect at some plausible size.
bool wholly_seen(const EffectPower& power) { return power.unseen.empty(); }

/// "0.012", with a note where it lies below the plausible range.
std::string detected_words(const EffectPower& power) {
    if (!power.detected) return "-";
    return format_number(*power.detected, 2) + (power.beyond_range ? " *" : "");
}

/// Most similar effect with its cosine; a dash if there is none.
std::string confusion_words(const EffectPower& power) {
    return power.confused_with.empty() ? "-" : power.confused_with + " (" + format_number(power.cosine, 3) + ")";
}

/// Sizes and probabilities: "1 12 %, 22 >99 %".
std::string size_words(const EffectPower& power) {
    std::vector<std::string> words;
    for (const SizePower& size : power.sizes)
        words.push_back((std::isfinite(size.size) ? format_number(size.size, 2) + " " : std::string()) +
                        percent(size.probability));
    return join(words, ",  ");
}

/// What the map assumes: level, noise, numerical error, parameters that are calibrated, trials.
std::string numbers_line(const PowerMap& map) {
    return "tests of level " + format_number(map.alpha) + "; noise " + report::length_words(map.noise_m) +
           ", numerical error " + report::length_words(map.numerical_error_m) +
           " (1 sigma); calibrated with it: " + (map.parameters.empty() ? "nothing" : join(map.parameters)) +
           "; trials: " + join(map.trials);
}

constexpr const char* below_range = "* weaker than the plausible range";

/// Whether a note on sizes below the plausible range is needed.
bool any_beyond(const PowerMap& map) {
    return std::any_of(map.effects.begin(), map.effects.end(), [](const EffectPower& p) { return p.beyond_range; });
}

}  // namespace

std::string power_lines(const PowerMap& map) {
    char line[400];
    std::snprintf(line, sizeof line, "%-21s %-20s %-36s %-11s %s", "effect", "size", "probability of detection",
                  ("from (" + percent(map.wanted) + ")").c_str(), "most like (cosine)");
    std::string text = numbers_line(map) + "\n\n" + line;
    for (const EffectPower& power : map.effects) {
        if (!wholly_seen(power)) continue;
        std::snprintf(line, sizeof line, "\n%-21s %-20s %-36s %-11s %s", power.id.c_str(), power.amount.c_str(),
                      size_words(power).c_str(), detected_words(power).c_str(), confusion_words(power).c_str());
        text += line;
    }
    if (any_beyond(map)) text += std::string("\n") + below_range;
    std::string unseen;
    for (const EffectPower& power : map.effects)
        if (!wholly_seen(power))
            unseen += "\n" + power.id + ": " + power.unseen +
                      (power.sizes.empty() ? "" : " (" + size_words(power) + ")");
    if (!unseen.empty()) text += "\n\nnot to be seen in this experiment:" + unseen;
    return text;
}

report::Json power_json(const PowerMap& map, const std::string& experiment, const results::RunFacts& facts) {
    report::Json json{{"schema", "power/1"},          {"experiment", experiment},
                      {"alpha", map.alpha},           {"wanted_probability", map.wanted},
                      {"noise_m", map.noise_m},       {"numerical_error_m", map.numerical_error_m},
                      {"samples", map.samples},       {"trials", map.trials},
                      {"calibrated", map.parameters}, {"effects", report::Json::array()}};
    for (const EffectPower& power : map.effects) {
        report::Json entry{{"id", power.id}, {"seen", power.unseen.empty()}};
        if (!power.unseen.empty()) entry["reason"] = power.unseen;
        if (!power.amount.empty()) entry["size"] = power.amount;
        if (!power.example.empty()) entry["example"] = diagnosis::effect_parameters_json(power.example);
        for (const SizePower& size : power.sizes) {
            report::Json one;
            // An effect without a size has one entry, with its probability only.
            if (std::isfinite(size.size)) one["size"] = size.size;
            one["change_rms_m"] = report::json_number(size.change_m);
            one["noncentrality"] = report::json_number(size.noncentrality);
            one["probability"] = report::json_number(size.probability);
            entry["sizes"].push_back(std::move(one));
        }
        if (power.detected) {
            entry["detected_from"] = report::json_number(*power.detected);
            entry["below_plausible_range"] = power.beyond_range;
        }
        if (!power.sizes.empty()) entry["kept_by_recalibration"] = report::json_number(power.kept);
        if (!power.confused_with.empty())
            entry["most_like"] = {{"id", power.confused_with}, {"cosine", report::json_number(power.cosine)}};
        json["effects"].push_back(std::move(entry));
    }
    json["runs"] = map.runs;
    json["seconds"] = report::json_number(map.seconds);
    json["version"] = facts.version;
    json["command"] = facts.command;
    return json;
}

report::HtmlReport power_report(const PowerMap& map, const std::string& title, const results::RunFacts& facts) {
    report::HtmlReport page{.title = title + ": what the experiment can show", .summary = {numbers_line(map)}};
    report::Table seen{.caption =
                           "Effects that the experiment can show. Size: the value of the parameter; similar: the "
                           "effect whose change of the markers is most alike after recalibration, and the cosine "
                           "between both."};
    seen.columns = {{"effect"}, {"size"}, {"probability of detection"}, {"detected from"}, {"similar"}, {"cosine"}};
    report::Table unseen{.caption = "Effects that it cannot show."};
    unseen.columns = {{"effect"}, {"reason"}, {"probability of detection"}};
    for (const EffectPower& power : map.effects)
        if (wholly_seen(power))
            seen.rows.push_back(
                {power.id, power.amount, size_words(power), detected_words(power), power.confused_with, power.cosine});
        else
            unseen.rows.push_back({power.id, power.unseen, size_words(power)});
    page.key_figures = {{"effects that can be shown", std::to_string(seen.rows.size()), "", ""},
                        {"effects that cannot", std::to_string(unseen.rows.size()), "", ""}};
    page.sections.push_back({"What it can show", {std::move(seen)}});
    if (any_beyond(map)) page.sections.back().blocks.push_back(report::Paragraph{below_range});
    if (!unseen.rows.empty()) page.sections.push_back({"What it cannot show", {std::move(unseen)}});
    page.footer = "myoloop " + facts.version + ", " + join(facts.command, " ") + ", " + format_number(map.seconds, 3) +
                  " s";
    return page;
}

}  // namespace myo::planning
