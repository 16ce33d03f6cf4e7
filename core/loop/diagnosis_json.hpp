#pragma once

#include "loop/diagnosis.hpp"
#include "report/json.hpp"

namespace myo {

/// report/1 of an experiment: verdict, errors before and after, and below `details` what led to it. Asserts a complete diagnosis.
///
/// @param folder  name of the experiment's folder
Json diagnosis_json(const Study& study, const Diagnosis& diagnosis, const std::string& folder);

/// Parameters of an effect as the report has them.
Json effect_parameters_json(const EffectParameters& parameters);

}  // namespace myo
