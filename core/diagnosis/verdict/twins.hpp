#pragma once

#include "diagnosis/diagnosis.hpp"

namespace myo::diagnosis {

/// Other effects that move the body as a named one does, up to what the declared parameters compensate: the cosine of
/// both contributions to the residual, with those parameters projected out, is at least ConfusionPolicy::twin_cosine. A
/// contribution is the change by the effect of a fit without it. Which of them fits better then says nothing.
/// @param effect  named by the verdict
std::vector<std::string> twins_of(const Diagnosis& diagnosis, const std::string& effect);

/// The diagnosis with the twins of its named effects: they are ranked behind the named ones, and the confidence of the
/// answer is shared among all of them.
Diagnosis with_twins(Diagnosis diagnosis);

}  // namespace myo::diagnosis
