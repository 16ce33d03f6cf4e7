#pragma once

#include <filesystem>
#include <string>

#include "base/progress.hpp"
#include "base/result.hpp"
#include "validation/synthetic_case.hpp"

namespace myo::validation {

/// An experiment that was made, with its truth.
struct MadeExperiment {
    SyntheticCase truth;  // with the final amounts of its effects
    // Size of the smallest effect at the markers of the fit trials [noise levels], see EffectLevel.
    double level = 0.0;
    int attempts = 1;  // draws until the effect was visible
    // Degrees of freedom of the mesh on which the truth was simulated.
    int truth_dofs = 0;
    // Wall-clock time of making.
    double seconds = 0.0;
};

/// Draws a case, scales each effect so that its level lies between min_level and max_level and a fit leaves min_fitted,
/// of several effects more than min_fitted of each beside the others, simulates it with its own scheme on a finer mesh
/// of other cells than the default, and writes the folder: experiment.toml, traces, actuations, STL. No file reveals
/// the truth.
///
/// Errors: none of 12 draws could be run and was visible; the folder cannot be written; cancelled.
Result<MadeExperiment> make_experiment(const CaseChoice& choice, int number, const std::filesystem::path& folder,
                                       const Progress& progress = {});

/// Range of the level of an effect [noise levels]: invisible below, obvious far above. Swapped markers may exceed it.
inline constexpr double min_level = 3.0, max_level = 15.0;
/// Level that a nonlinear recalibration must leave: a fit also shifts phases, which first order does not.
inline constexpr double min_fitted = 1.0;

}  // namespace myo::validation
