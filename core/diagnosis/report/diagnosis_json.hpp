#pragma once

#include "diagnosis/diagnosis.hpp"
#include "report/json.hpp"

namespace myo::diagnosis {

/// Report of an experiment (schema report/1): verdict, errors before and after, and the evidence under `details`.
/// Asserts a complete diagnosis.
///
/// @param folder  name of the experiment's folder
report::Json diagnosis_json(const setup::Setup& setup, const Diagnosis& diagnosis, const std::string& folder);

/// Parameters of an effect in the form of the report.
report::Json effect_parameters_json(const effect::EffectParameters& parameters);

/// 95 % intervals of the fitted numbers of a named effect, under the names of its parameters: [low, high], of a vector
/// one such pair per component; null where the data do not determine it. Directions, which are fitted as angles,
/// have none.
report::Json intervals_json(const JointFit& fit, const std::string& effect);

}  // namespace myo::diagnosis
