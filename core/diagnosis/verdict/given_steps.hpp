#pragma once

#include "diagnosis/diagnosis_context.hpp"

namespace myo::diagnosis {

/// Context of a fit, and where it starts.
struct FitWithSteps {
    DiagnosisContext context;  // its setup and refinement with these steps
    JudgedFit fit;             // converted to them, without a numerical error
};

/// Whether the last fit must not have the longer steps of the search: the fit has a force with a corner, see
/// effect::Effect::has_corner, and steps were lengthened.
///
/// The error of a step across a corner follows no order, so that extrapolation does not remove it. An error of the
/// predictions of the size of one standard deviation in all may move a fitted value by as much as its noise does; in
/// example_dry_friction 10 ms for 2.5 ms move them by less than 0.2 noise levels (rms), and the force by a quarter.
bool needs_given_steps(const DiagnosisContext& context, const JudgedFit& fit);

/// Context and fit with the steps that were given to diagnose(); the motion of the cells stays the same but for the
/// error of the longer steps.
FitWithSteps with_given_steps(DiagnosisContext context, JudgedFit fit);

}  // namespace myo::diagnosis
