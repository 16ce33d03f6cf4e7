#pragma once

#include <string>

#include "diagnosis/fit/fit_store.hpp"
#include "diagnosis/fit/joint_fit.hpp"
#include "diagnosis/phase_log.hpp"

namespace myo::diagnosis {

/// Text under which the fit is stored: effort, shift, modulus factor, steps, effects and start values. The warm start
/// does not belong to it.
std::string fit_key(const FitTask& task);

/// joint_fit() with a store: a stored fit is evaluated once at its stored values, and a new result is stored. A result
/// that cannot be written is fitted again next time.
JointFit stored_fit(const FitTask& task, FitStore& store, const Progress& progress);

/// stored_fit() as a phase: its time and runs are logged. Not usable if it failed or was cancelled.
JointFit logged_fit(const std::string& phase, const FitTask& task, FitStore& store, PhaseLog& log);

}  // namespace myo::diagnosis
