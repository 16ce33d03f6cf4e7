#pragma once

#include "diagnosis/fit_store.hpp"
#include "diagnosis/joint_fit.hpp"

namespace myo::diagnosis {

/// How far a fit goes: evaluations, and the decrease of the squares that is no longer worth one (of thousands of
/// squares, 1e-4 is a quarter of a standard deviation, and the step before was larger).
struct Effort {
    int evaluations = 0;
    double relative_decrease = 1e-4;
    int most_jacobians = 1000;  // beside what is known where it starts
};

/// joint_fit() that goes on from where the store says it ended, and tells the store where it ends. What cannot be kept
/// is done again.
JointFit stored_fit(FitStore& store, const setup::Setup& setup, const FitData& data,
                    const prediction::ParameterValues& start, EffectFreedom freedom, const Effort& effort,
                    const Neighbourhood& known, const Progress& progress);

}  // namespace myo::diagnosis
