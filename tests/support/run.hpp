#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "dynamics/simulate.hpp"

namespace myo::test {

/// A complete run from the straight body, its stages solved well below the errors in time.
Trace run(const Model& model, const TimeScheme& scheme, double h, double end);

/// Options of a run with the default integrator, its stages solved well below the errors in time.
SimulationOptions short_steps(StartKind start, double h, double end);

/// Largest distance between two motions, relative to the largest displacement.
double relative_difference(const Trace& a, const Trace& b);

struct NamedScheme {
    const char* name;
    TimeScheme scheme;
};

/// Every integrator; generalised-alpha also away from its default.
std::vector<NamedScheme> all_schemes();

}  // namespace myo::test
