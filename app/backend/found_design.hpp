#pragma once

#include <vector>

#include "base/result.hpp"
#include "calibration/body_design.hpp"
#include "commands/backend.hpp"

namespace myo::backend {

/// The settings with what a search found of the body: paint of muscles and the body's modulus as settings, moduli of
/// parts and directions of muscles as edits of the declaration.
///
/// @param settings  those of the search: a found item names its muscle by the index in them
/// @param scene     whose declaration is edited
/// Errors: the declaration cannot be edited.
Result<ui::commands::Settings> with_found_design(ui::commands::Settings settings, const ui::commands::Scene& scene,
                                                 const std::vector<calibration::FoundItem>& found);

/// Declared and found values of the body, for the table of a search, in the unit of each item; without deviations.
std::vector<ui::commands::ParameterRow> design_rows(const std::vector<calibration::FoundItem>& found);

/// What can be sought of an experiment besides the signals: words of OptimizeRequest::seek, their labels, and the
/// muscle that each belongs to (empty: a modulus).
std::vector<ui::commands::SeekChoice> seek_choices(const experiment::Experiment& experiment);

}  // namespace myo::backend
