#include "planning/proposal_output.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "base/text.hpp"
#include "report/length.hpp"

namespace myo::planning {
namespace {

/// Probability in words, without false precision near 1.
std::string percent_words(double probability) {
    if (probability > 0.99) return "more than 99 %";
    return format_number(std::round(100.0 * probability)) + " %";
}

/// The rivals as "a / b".
std::string both(const Proposal& proposal) {
    return rival_words(proposal.rivals[0]) + " / " + rival_words(proposal.rivals[1]);
}

/// What to do next and what it would achieve, for text and page.
std::string best_sentence(const Proposal& proposal) {
    const RatedTrial* const best = proposal.best();
    if (!best) return "No trial of the family can be run with both " + both(proposal) + ".";
    return "Next experiment, to tell apart " + both(proposal) + ": " + best->trial.words + ". With " +
           percent_words(best->probability) +
           " probability the wrong one is then rejected; after recalibration they "
           "differ by " +
           report::length_words(best->difference_m) + " (noise " + report::length_words(proposal.noise_m) +
           ", numerical error " + report::length_words(proposal.numerical_error_m) + ").";
}

/// Rivals as a list of effects: a single one by its id.
report::Json rival_json(const std::vector<std::string>& ids) {
    if (ids.empty()) return "none";
    return ids.size() == 1 ? report::Json(ids.front()) : report::Json(ids);
}

/// Both rivals. A plain list of two pairs of words would become an object.
report::Json separated_json(const Proposal& proposal) {
    return report::Json::array({rival_json(proposal.rivals[0]), rival_json(proposal.rivals[1])});
}

/// A trial with its rating, or with the reason why it could not be run.
report::Json rated_json(const RatedTrial& rated) {
    report::Json json{{"name", rated.trial.name}, {"what", rated.trial.words}};
    if (rated.failure.empty()) {
        json["probability"] = report::json_number(rated.probability);
        json["noncentrality"] = report::json_number(rated.noncentrality);
        json["difference_rms_m"] = report::json_number(rated.difference_m);
    } else {
        json["failure"] = rated.failure;
    }
    json["trial"] = trial_text(rated.trial);
    return json;
}

}  // namespace

std::string proposal_lines(const Proposal& proposal, const ProposalPolicy& policy) {
    std::string text = best_sentence(proposal);
    const RatedTrial* const best = proposal.best();
    if (!best) return text;
    text += "\n\n" + trial_text(best->trial) + "\nothers of the " + std::to_string(proposal.trials.size()) + " trials:";
    // Trial 0 is the best one, shown above.
    for (std::size_t i = 1; i < proposal.trials.size() && i <= static_cast<std::size_t>(policy.runners_up); ++i) {
        const RatedTrial& other = proposal.trials[i];
        text += "\n  " +
                (other.failure.empty()
                     ? percent_words(other.probability) + ", " + report::length_words(other.difference_m)
                     : "not run (" + other.failure + ")") +
                ": " + other.trial.words;
    }
    return text;
}

report::Json next_experiment_json(const Proposal& proposal) {
    const RatedTrial* const best = proposal.best();
    assert(best);
    report::Json json{{"trial", trial_text(best->trial)},
                      {"separates", separated_json(proposal)},
                      {"probability", report::json_number(best->probability)},
                      {"what", best->trial.words}};
    if (best->trial.signal) json["signal"] = signal_file;
    return json;
}

report::Json proposal_json(const Proposal& proposal, const std::string& experiment, const results::RunFacts& facts) {
    report::Json json{{"schema", "proposal/1"},
                      {"experiment", experiment},
                      {"alpha", proposal.alpha},
                      {"noise_m", report::json_number(proposal.noise_m)},
                      {"numerical_error_m", report::json_number(proposal.numerical_error_m)},
                      {"separates", separated_json(proposal)}};
    if (proposal.best()) json["next_experiment"] = next_experiment_json(proposal);
    json["trials"] = report::Json::array();
    for (const RatedTrial& rated : proposal.trials) json["trials"].push_back(rated_json(rated));
    json["runs"] = proposal.runs;
    json["seconds"] = report::json_number(proposal.seconds);
    json["version"] = facts.version;
    json["command"] = facts.command;
    return json;
}

report::Section proposal_section(const Proposal& proposal, const ProposalPolicy& policy) {
    report::Section section{"The next experiment", {report::Paragraph{best_sentence(proposal)}}};
    const RatedTrial* const best = proposal.best();
    if (!best) return section;
    section.blocks.push_back(report::Preformatted{trial_text(best->trial)});
    report::Table table{.caption =
                            "Trials that were compared, the best first. Difference: rms between both after "
                            "recalibration."};
    table.columns = {{"trial"}, {"probability", "", 3}, {"difference", "mm", 3}};
    for (const RatedTrial& rated : proposal.trials) {
        if (table.rows.size() > static_cast<std::size_t>(policy.runners_up)) break;
        if (rated.failure.empty())
            table.rows.push_back({rated.trial.words, rated.probability, 1e3 * rated.difference_m});
    }
    section.blocks.push_back(std::move(table));
    return section;
}

}  // namespace myo::planning
