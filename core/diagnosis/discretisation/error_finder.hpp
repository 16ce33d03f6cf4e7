#pragma once

#include <memory>
#include <vector>

#include "diagnosis/discretisation/numerical_error.hpp"

namespace myo::diagnosis {

/// Paths take the memory of many runs: they stay only where others start.
void forget_paths(std::vector<prediction::TrialPrediction>& predictions);

/// Predictions of trials with the values of a fit, and levels that follow from them.
std::vector<prediction::TrialPrediction> fitted_predictions(const setup::Setup& setup,
                                                            const std::vector<std::size_t>& trials,
                                                            const prediction::ParameterValues& fitted,
                                                            const Progress& progress);

/// Finds the numerical errors of a setup's runs. Meshes the body finer once, when it is first asked.
class ErrorFinder {
public:
    /// @param setup  outlives this; steps as they are when it is asked
    ErrorFinder(const setup::Setup& setup, bool refine_mesh) : setup_(setup), refine_mesh_(refine_mesh) {}

    /// match_modulus() for all that is found from now on. True: the setup is to take the modulus factor of
    /// error.stiffening.
    bool match(const prediction::ParameterValues& fitted, const FitData& data, NumericalError& error,
               const Progress& progress);

    /// numerical_error() with a fit's values, in all runs or, where `alike` is given, with those; the shift is to be
    /// added to predictions with `fitted` in any case.
    NumericalError at(const prediction::ParameterValues& fitted, const std::vector<std::size_t>& trials,
                      const NumericalError* known, const Progress& progress, const MatchedValues* matched = nullptr);

private:
    const setup::Setup& setup_;
    bool refine_mesh_;
    NumericalError plain_;  // with which the stiffening was found
    std::unique_ptr<setup::Setup> refined_;
};

}  // namespace myo::diagnosis
