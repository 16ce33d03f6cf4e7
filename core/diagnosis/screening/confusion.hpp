#pragma once

#include "diagnosis/diagnosis.hpp"

namespace myo::diagnosis {

/// Finds candidates that explain the residual in the same way, according to scores or fits, and the experiment that
/// would separate them.
void find_confusions(Diagnosis& diagnosis);

/// Confusions that concern the verdict: those with a named effect, or all if it names none.
std::vector<Confusion> confusions_of_verdict(const Diagnosis& diagnosis);

/// Whether the fits decide between two confounded effects: one is in the verdict, the other was fitted and has
/// negligible weight.
bool is_decided(const Diagnosis& diagnosis, const Confusion& confusion);

}  // namespace myo::diagnosis
