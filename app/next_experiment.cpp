#include "next_experiment.hpp"

#include <algorithm>
#include <numeric>

#include "base/files.hpp"
#include "planning/reported_rivals.hpp"

namespace myo::app {

Result<std::optional<planning::Proposal>> next_experiment(const setup::Setup& setup,
                                                          const diagnosis::Diagnosis& diagnosis,
                                                          const std::filesystem::path& declaration,
                                                          const Progress& progress) {
    const std::optional<planning::Proposal> none;
    const std::optional<std::array<planning::Rival, 2>> rivals = planning::diagnosed_rivals(diagnosis);
    if (!rivals) return none;
    const Result<std::string> text = read_file(declaration);
    if (!text) return text.error();
    const planning::PlanningPolicy policy;
    // Cost is counted in runs, which, unlike seconds, do not depend on the machine: the proposal is reproducible.
    const int runs = std::accumulate(diagnosis.cost.begin(), diagnosis.cost.end(), 0,
                                     [](int sum, const diagnosis::PhaseCost& cost) { return sum + cost.runs; });
    // A run with its derivatives counts as one per parameter, as in the costs of a diagnosis.
    // A trial is predicted by both rivals with the derivatives of all their parameters.
    const double of_a_trial = 2.0 +
                              static_cast<double>((*rivals)[0].parameters.size() + (*rivals)[1].parameters.size());
    const auto affordable = static_cast<std::size_t>(policy.proposal.most_time * runs / of_a_trial);
    const setup::Setup diagnosed = diagnosis::as_diagnosed(diagnosis, setup);
    Result<planning::Proposal> proposal = planning::propose_trial(
        {diagnosed, *rivals, *text, declaration, {}, {}, std::max(policy.proposal.fewest_trials, affordable), policy},
        progress);
    // A cancelled search ends with an error as well, which says nothing.
    if (progress.cancelled()) return none;
    if (!proposal) return proposal.error();
    return proposal->best() ? std::optional<planning::Proposal>(*std::move(proposal)) : none;
}

Result<void> write_signal(const std::filesystem::path& folder, const planning::Proposal& proposal) {
    const planning::RatedTrial* const best = proposal.best();
    if (!best || !best->trial.signal) return {};
    return measurement::write_actuation_csv(folder / planning::signal_file, *best->trial.signal);
}

}  // namespace myo::app
