#pragma once

#include <string>
#include <vector>

#include "base/progress.hpp"
#include "setup/setup.hpp"

namespace myo::prediction {
struct ParameterValues;
}  // namespace myo::prediction

namespace myo::diagnosis {

/// Steps of a diagnosis may be longer than those of a run that shall be right by itself: their error is taken off, see
/// numerical_error() and NumericsPolicy.
struct LongerSteps {
    std::vector<double> factors;  // of the steps, one per trial; powers of two
    int runs = 0;                 // of trials, that it took
};

/// How much longer steps may be with these values, so that predictions of a trial change by no more than most_m (rms)
/// and no step is longer than a sampling interval.
LongerSteps longer_steps(const setup::Setup& setup, const prediction::ParameterValues& values, double most_m,
                         const Progress& progress);

bool any_longer(const std::vector<double>& factors);

/// The steps of all trials, such as "2.5 to 5 ms". Factors multiply them; empty: 1.
std::string steps_in_words(const setup::Setup& setup, const std::vector<double>& factors = {});

}  // namespace myo::diagnosis
