#pragma once

#include <memory>
#include <vector>

#include "diagnosis/discretisation/numerical_error.hpp"

namespace myo::diagnosis {

/// Deletes stored paths: they need the memory of many runs and are kept only where further runs start.
void forget_paths(std::vector<prediction::TrialPrediction>& predictions);

/// Predictions with the values of a fit, with the levels of validation trials derived from those of the fit trials.
std::vector<prediction::TrialPrediction> fitted_predictions(const setup::Setup& setup,
                                                            const std::vector<std::size_t>& trials,
                                                            const prediction::ParameterValues& fitted,
                                                            const Progress& progress);

/// Computes numerical errors of the runs of a setup. The refined mesh is made once, at the first call of at().
class ErrorFinder {
public:
    /// @param setup  must outlive this object; its steps must not change after the first call of at()
    ErrorFinder(const setup::Setup& setup, bool refine_mesh) : setup_(setup), refine_mesh_(refine_mesh) {}

    /// match_modulus(); all later errors are found with its result. If it returns true, the caller must set the modulus
    /// factor of the setup to that of error.effective_modulus.
    bool match(const prediction::ParameterValues& fitted, const FitData& data, NumericalError& error,
               const Progress& progress);

    /// numerical_error() with the values of a fit in all runs, or with `matched` if given. In both cases the shift
    /// applies to predictions with `fitted`.
    NumericalError at(const prediction::ParameterValues& fitted, const std::vector<std::size_t>& trials,
                      const NumericalError* known, const Progress& progress, const MatchedValues* matched = nullptr);

private:
    const setup::Setup& setup_;
    bool refine_mesh_;
    NumericalError plain_;  // error with which the effective modulus was found
    std::unique_ptr<setup::Setup> refined_;
};

}  // namespace myo::diagnosis
