#pragma once

#include "commands/diagnosis_view.hpp"
#include "diagnosis/diagnosis.hpp"

// Conversion of a diagnosis to the form that the workbench displays.

namespace myo::backend {

/// Input of a diagnosis.
struct DiagnosisSource {
    const setup::Setup& setup;
    // Effects of the fitted values start with those of the file; the rest becomes settings of a row.
    std::size_t file_effects = 0;  // number of effects declared in the file; later ones were added in the workbench
    // Settings with which the diagnosis was started; a row's settings are these with its fitted values.
    ui::commands::Settings settings;
};

/// Displayed form of a diagnosis, complete or in progress; without forces.
///
/// Empty until the declared model is fitted. Forces cost extra simulations and are added by add_forces().
ui::commands::DiagnosisView diagnosis_view(const DiagnosisSource& source, const diagnosis::Diagnosis& diagnosis);

/// Adds the forces of the fitted effects along the motion, and the missing force.
///
/// The motion is that of the model with the verdict's effects for these, otherwise of the declared model. Costs several
/// evaluations of the body's forces each: about a second. Asserts a complete diagnosis.
void add_forces(const DiagnosisSource& source, const diagnosis::Diagnosis& diagnosis,
                ui::commands::DiagnosisView& view);

}  // namespace myo::backend
