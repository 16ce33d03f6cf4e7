#pragma once

#include "commands/diagnosis_view.hpp"
#include "diagnosis/diagnosis.hpp"

// A diagnosis as the workbench shows it.

namespace myo::backend {

/// What was diagnosed.
struct DiagnosisSource {
    const setup::Setup& setup;
    std::size_t
        file_effects = 0;  // effects that the experiment's file declares; those behind them were added in the workbench
    ui::commands::Settings settings;
};

/// What is known of a diagnosis, complete or not; without forces.
ui::commands::DiagnosisView diagnosis_view(const DiagnosisSource& source, const diagnosis::Diagnosis& diagnosis);

/// The forces of the fitted effects along the motion, that of the model with the verdict's effects for these, else of
/// the declared model; and the missing force. Some evaluations of the body's forces for each: about a second. Asserts a
/// complete diagnosis.
void add_forces(const DiagnosisSource& source, const diagnosis::Diagnosis& diagnosis,
                ui::commands::DiagnosisView& view);

/// An added effect as an experiment declares it, to be fitted along.
effect::EffectDeclaration declaration(const ui::commands::AddedEffect& effect);

}  // namespace myo::backend
