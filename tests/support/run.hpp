#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "dynamics/simulate.hpp"

namespace myo::test {

/// A complete run from the straight body, its stages solved well below the errors in time.
dynamics::Trace run(const model::Model& model, const dynamics::TimeScheme& scheme, double h, double end);

/// Options of a run with the default integrator, its stages solved well below the errors in time.
dynamics::SimulationOptions short_steps(dynamics::StartKind start, double h, double end);

/// Largest distance between two motions, relative to the largest displacement.
double relative_difference(const dynamics::Trace& a, const dynamics::Trace& b);

struct NamedScheme {
    const char* name;
    dynamics::TimeScheme scheme;
};

/// Every integrator; generalised-alpha also away from its default.
std::vector<NamedScheme> all_schemes();

}  // namespace myo::test
