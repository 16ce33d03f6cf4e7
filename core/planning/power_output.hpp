#pragma once

#include <string>

#include "planning/power_map.hpp"
#include "report/html_report.hpp"
#include "report/json.hpp"
#include "results/output_json.hpp"

namespace myo::planning {

/// The map as a table of text, one line per effect that can be shown, then those that cannot, with reasons.
std::string power_lines(const PowerMap& map);

/// Schema power/1. Keys without a value are absent.
///
/// @param experiment  name of the experiment's folder
report::Json power_json(const PowerMap& map, const std::string& experiment, const results::RunFacts& facts);

/// The map as a page.
///
/// @param title  name of the experiment
report::HtmlReport power_report(const PowerMap& map, const std::string& title, const results::RunFacts& facts);

}  // namespace myo::planning
