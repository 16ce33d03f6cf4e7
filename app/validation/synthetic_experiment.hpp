#pragma once

#include <filesystem>
#include <string>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "validation/synthetic_case.hpp"

namespace myo::validation {

/// What came of making an experiment.
struct MadeExperiment {
    SyntheticCase truth;  // its effect as large as it was made
    double level = 0.0;   // what the effect does to the markers of the fit trials [noise levels], see effect_level()
    int attempts = 1;     // draws until the effect could be seen well
    int truth_dofs = 0;
    double seconds = 0.0;
};

/// Draws a case, makes its effect so large that it does between least_level and most_level to the markers and a fit
/// leaves least_fitted of it, simulates it by its own scheme on a mesh of other and finer cells than the diagnosis
/// would take, and writes the folder: experiment.toml, traces, actuations, STL.
///
/// The folder says nothing of the truth. Errors: no draw in 12 could be run and seen; the folder cannot be written;
/// cancelled.
Result<MadeExperiment> make_experiment(const CaseChoice& choice, int number, const std::filesystem::path& folder,
                                       const Progress& progress = {});

/// Bounds of what an effect does, in noise levels: below, no one can see it; far above, anyone can. A swap of markers
/// may be above.
inline constexpr double least_level = 3.0, most_level = 15.0;
/// What recalibration has to leave of it: a fit moves phases, which first order does not.
inline constexpr double least_fitted = 1.0;

}  // namespace myo::validation
