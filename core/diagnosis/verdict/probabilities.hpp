#pragma once

#include <map>
#include <string>

#include "diagnosis/diagnosis.hpp"

namespace myo::diagnosis {

/// Share of the evidence of all fits in which every effect of a fit acts: of the fit itself, and of larger sets.
double presence(const Diagnosis& diagnosis, const JudgedFit& fit);

/// For each candidate the probability that it acts: the share of the evidence of all fits with it, times the trust in
/// the answer if that names effects, or else what `none` or `unknown` leave over.
/// Twins of the verdict share the sum of theirs equally. A named effect has at least the confidence of the verdict. The
/// probabilities need not add up to one, as several effects may act.
std::map<std::string, double> effect_probabilities(const Diagnosis& diagnosis);

/// Confidence in one of the named effects: that of the whole answer, or its own probability where several are named.
double confidence_in(const Diagnosis& diagnosis, const std::string& effect);

}  // namespace myo::diagnosis
