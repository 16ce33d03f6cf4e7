#pragma once

#include "diagnosis/diagnosis.hpp"
#include "report/json.hpp"

namespace myo::diagnosis {

/// report/1 of an experiment: verdict, errors before and after, and below `details` what led to it. Asserts a complete
/// diagnosis.
///
/// @param folder  name of the experiment's folder
report::Json diagnosis_json(const setup::Setup& setup, const Diagnosis& diagnosis, const std::string& folder);

/// Parameters of an effect as the report has them.
report::Json effect_parameters_json(const effect::EffectParameters& parameters);

}  // namespace myo::diagnosis
