#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "dynamics/simulate.hpp"

namespace myo::test {

/// Simulates from the straight body until `end` [s] with steps of h [s]. The tolerance of the stages is far below the
/// errors in time. Fails the test if the run is incomplete.
dynamics::Trace run(const model::Model& model, const dynamics::TimeScheme& scheme, double h, double end);

/// Options for the default integrator, with a tolerance of the stages far below the errors in time.
dynamics::SimulationOptions short_steps(dynamics::StartKind start, double h, double end);

/// Largest difference between two motions, relative to the largest displacement. Both have the same number of states.
double relative_difference(const dynamics::Trace& a, const dynamics::Trace& b);

/// A time scheme with a name for test output.
struct NamedScheme {
    const char* name;
    dynamics::TimeScheme scheme;
};

/// Every integrator; generalised-alpha also with a spectral radius other than its default.
std::vector<NamedScheme> all_schemes();

}  // namespace myo::test
