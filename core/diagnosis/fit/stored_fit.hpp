#pragma once

#include "diagnosis/diagnosis_policy.hpp"
#include "diagnosis/fit/fit_store.hpp"
#include "diagnosis/fit/joint_fit.hpp"

namespace myo::diagnosis {

/// joint_fit() with a store: a stored fit is evaluated once at its stored values, and a new result is stored. A result
/// that cannot be written is fitted again next time.
JointFit stored_fit(FitStore& store, const setup::Setup& setup, const FitData& data,
                    const prediction::ParameterValues& start, EffectFreedom freedom, const Effort& effort,
                    const Neighbourhood& known, const Progress& progress);

}  // namespace myo::diagnosis
