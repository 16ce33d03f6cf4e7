#pragma once

#include <vector>

#include "base/result.hpp"
#include "calibration/body_design.hpp"
#include "commands/backend.hpp"

namespace myo::backend {

/// The settings with what a search found of the body: paint of muscles, moduli, directions in the declaration.
///
/// @param setup  that of the search, whose muscles are those of the settings
/// Errors: the declaration cannot be edited.
Result<ui::commands::Settings> with_found_design(ui::commands::Settings settings, const ui::commands::Scene& scene,
                                                 const std::vector<calibration::FoundItem>& found);

/// Declared and found values of the body, for the table of a search.
std::vector<ui::commands::ParameterRow> design_rows(const std::vector<calibration::FoundItem>& found);

/// What can be sought of an experiment besides the signals: words of OptimizeRequest::seek and their labels.
std::vector<ui::commands::SeekChoice> seek_choices(const experiment::Experiment& experiment);

}  // namespace myo::backend
