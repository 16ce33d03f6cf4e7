#include <algorithm>
#include <numbers>

#include "commands/workbench.hpp"

// Edits of the settings and what follows from them.

namespace myo::ui::commands {
namespace {

/// Corrects the predicted size by the mesh at hand: a finer mesh of the same element type is not smaller. A finely
/// triangulated surface may produce more elements than its edge length alone suggests.
MeshPrediction no_smaller_than_coarser(MeshPrediction prediction, const WorkbenchState& state,
                                       const Settings& settings) {
    if (!state.body || prediction.exact || state.body_settings.element != settings.element ||
        state.body_settings.resolution_m < settings.resolution_m)
        return prediction;
    if (!(prediction.elements > 0.0) || !(prediction.dofs > 0.0)) return prediction;
    // One factor for both: their ratio is that of the element.
    const double factor = std::max({1.0, static_cast<double>(state.body->mesh.cell_count()) / prediction.elements,
                                    state.body->dofs / prediction.dofs});
    prediction.elements *= factor;
    prediction.dofs *= factor;
    return prediction;
}

}  // namespace

void Workbench::change_settings(const ChangeSettings& change) {
    Settings settings = within_limits(change.settings);
    // Setting a step marks it as the user's own, unless the same edit switches the automatic choice.
    const bool given_back = settings.own_step != state_.settings.own_step;
    if (settings.time_step_s != state_.settings.time_step_s && !given_back) settings.own_step = true;
    if (settings == state_.settings) return;
    const Settings before = state_.settings;
    if (set_settings(settings)) undo_.record(before, change.what, change.goes_on);
}

bool Workbench::set_settings(const Settings& settings) {
    // All changes of the settings pass here: commands, undo, restored jobs and results of searches.
    // The declaration first, as it alone can be refused; the preview last, as it runs with all that was set before.
    if (!take_declaration(settings.declaration, state_.body.get())) return false;
    state_.settings = settings;
    state_.muscle = std::clamp(state_.muscle, 0, std::max(0, static_cast<int>(settings.muscles.size()) - 1));
    place_muscles();
    follow_settings_live();
    check_stability();
    if (state_.scene)
        state_.prediction = no_smaller_than_coarser(backend_->predict(*state_.scene, settings), state_, settings);
    want_preview();
    return true;
}

bool Workbench::take_declaration(const Declaration& declaration, const MeshedBody* body) {
    if (declaration == state_.settings.declaration) return true;
    if (!redeclare(declaration, body)) return false;
    state_.settings.declaration = declaration;
    return true;
}

void Workbench::check_stability() {
    // Can take long for some schemes, so it is computed per change and not per frame.
    state_.critical_velocity_force_1_s.reset();
    const Choice* integrator = state_.integrator();
    if (integrator && integrator->critical_velocity_force)
        state_.critical_velocity_force_1_s = integrator->critical_velocity_force(
            2.0 * std::numbers::pi * state_.damping_frequency_Hz, state_.settings);
}

void Workbench::on(const ChangeSettings& c) { change_settings(c); }

// While an import is open, undo and redo mean its choices. An entry that is refused goes back to where it was, so that
// it can be tried again.

void Workbench::on(const Undo&) {
    if (step_import(true)) return;
    const Settings wanted = undo_.undo(state_.settings);
    if (!set_settings(wanted)) undo_.redo(wanted);
}

void Workbench::on(const Redo&) {
    if (step_import(false)) return;
    const Settings wanted = undo_.redo(state_.settings);
    if (!set_settings(wanted)) undo_.undo(wanted);
}

void Workbench::on(const SetDampingFrequency& c) {
    state_.damping_frequency_Hz = std::clamp(c.frequency_Hz, damping_frequency_limits.lowest,
                                             damping_frequency_limits.highest);
    check_stability();
}

}  // namespace myo::ui::commands
