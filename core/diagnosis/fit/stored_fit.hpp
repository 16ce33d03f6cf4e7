#pragma once

#include "diagnosis/diagnosis_policy.hpp"
#include "diagnosis/fit/fit_store.hpp"
#include "diagnosis/fit/joint_fit.hpp"

namespace myo::diagnosis {

/// joint_fit() that goes on from where the store says it ended, and tells the store where it ends. What cannot be kept
/// is done again.
JointFit stored_fit(FitStore& store, const setup::Setup& setup, const FitData& data,
                    const prediction::ParameterValues& start, EffectFreedom freedom, const Effort& effort,
                    const Neighbourhood& known, const Progress& progress);

}  // namespace myo::diagnosis
