#pragma once

#include <string>
#include <vector>

#include "base/progress.hpp"
#include "setup/setup.hpp"

namespace myo::prediction {
struct ParameterValues;
}  // namespace myo::prediction

namespace myo::diagnosis {

/// Lengthened time steps. A diagnosis may use longer steps than a single run, because their error is removed, see
/// numerical_error() and NumericsPolicy.
struct LongerSteps {
    std::vector<double> factors;  // per trial: factor of the step, a power of two
    int runs = 0;                 // trial runs
};

/// Longest steps for which the predictions of a trial change by at most max_m [m, rms], and which do not exceed a
/// sampling interval.
/// Trials that hold a pose, and those that cannot be run, keep the factor 1.
LongerSteps longer_steps(const setup::Setup& setup, const prediction::ParameterValues& values, double max_m,
                         const Progress& progress);

/// Whether a factor exceeds 1.
bool any_longer(const std::vector<double>& factors);

/// Range of the steps of all trials as text, such as "2.5 to 5 ms". Factors multiply the steps; empty: 1.
std::string steps_in_words(const setup::Setup& setup, const std::vector<double>& factors = {});

}  // namespace myo::diagnosis
