#pragma once

#include <optional>
#include <string>
#include <vector>

#include "chart/chart.hpp"
#include "sweep/sweep_table.hpp"

namespace myo::sweep {

/// Figures of a sweep: one per number that is shown, over the axis with most values; one curve per combination of the
/// other axes.
struct SweepFigures {
    std::vector<chart::Chart> charts;
    std::string missing = {};  // why there are none; empty: there are, or nothing is to be shown
};

/// Makes the figures, in the order of the shown columns. Rows without a number are gaps; bands are one standard
/// deviation.
///
/// @param policy  more curves than it allows give no figure
SweepFigures sweep_figures(const SweepTable& table, const SweepPolicy& policy = {});

}  // namespace myo::sweep
