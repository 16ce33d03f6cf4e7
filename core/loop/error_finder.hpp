#pragma once

#include <memory>
#include <vector>

#include "loop/numerical_error.hpp"

namespace myo {

/// Paths take the memory of many runs: they stay only where others start.
void forget_paths(std::vector<TrialPrediction>& predictions);

/// Predictions of trials with the values of a fit, and levels that follow from them.
std::vector<TrialPrediction> fitted_predictions(const Study& study, const std::vector<std::size_t>& trials, const StudyValues& fitted, const Progress& progress);

/// Finds the numerical errors of a study's runs. Meshes the body finer once, when it is first asked.
class ErrorFinder {
public:
    /// @param study  outlives this; steps as they are when it is asked
    ErrorFinder(const Study& study, bool refine_mesh) : study_(study), refine_mesh_(refine_mesh) {}

    /// match_stiffness() for all that is found from now on. True: the study is to take the modulus factor of error.stiffening.
    bool match(const StudyValues& fitted, const FitData& data, NumericalError& error, const Progress& progress);

    /// numerical_error() with a fit's values, in all runs or, where `alike` is given, with those; the shift is to be added to predictions with `fitted` in any case.
    NumericalError at(const StudyValues& fitted, const std::vector<std::size_t>& trials, const NumericalError* known, const Progress& progress,
                      const AlikeValues* alike = nullptr);

private:
    const Study& study_;
    bool refine_mesh_;
    NumericalError plain_;   // with which the stiffening was found
    std::unique_ptr<Study> refined_;
};

}  // namespace myo
