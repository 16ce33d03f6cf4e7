#pragma once

#include <string>

#include "planning/propose_trial.hpp"
#include "report/html_report.hpp"
#include "report/json.hpp"
#include "results/output_json.hpp"

namespace myo::planning {

/// Best trial, runners-up and text of the best.
/// A single sentence if no trial could be run.
std::string proposal_lines(const Proposal& proposal, const ProposalPolicy& policy);

/// `verdict.next_experiment` of a diagnosis: trial, separates, probability; with the name of its signal file, if it has
/// one. Asserts that there is a best trial.
report::Json next_experiment_json(const Proposal& proposal);

/// Schema proposal/1: all trials of the family, the best first.
/// @param experiment  name of the experiment's folder
report::Json proposal_json(const Proposal& proposal, const std::string& experiment, const results::RunFacts& facts);

/// The best trial as a section of a page.
report::Section proposal_section(const Proposal& proposal, const ProposalPolicy& policy);

}  // namespace myo::planning
