#pragma once

#include "diagnosis/diagnosis.hpp"

namespace myo::diagnosis {

/// Names the candidates that explain the residual in the same way, as foretold or as fitted, and what would tell them
/// apart.
void find_confusions(Diagnosis& diagnosis);

/// Confusions that concern the answer: if the verdict names effects, those with one of them, otherwise all.
std::vector<Confusion> confusions_of_verdict(const Diagnosis& diagnosis);

/// Whether the fits choose between two that look alike: one of them is the verdict, and the other was fitted and has
/// next to none of the evidence.
bool is_decided(const Diagnosis& diagnosis, const Confusion& confusion);

}  // namespace myo::diagnosis
