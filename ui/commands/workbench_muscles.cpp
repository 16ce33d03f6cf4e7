#include "commands/workbench.hpp"

// Muscles: where they are on the body, and edits of paint and signals.

namespace myo::ui::commands {

void Workbench::on(const Paint& asked) {
    const auto index = static_cast<std::size_t>(asked.muscle);
    if (!state_.body || !asked.paint || asked.muscle < 0 || index >= state_.settings.muscles.size()) return;
    // the mesh has been replaced since the stroke began
    if (asked.paint->count() != state_.body->mesh.cell_count()) return;
    // Settings hold a mask that does not depend on the mesh. The paint itself is cached: converting it back takes long.
    const auto mask = std::make_shared<const fibre::PaintedMask>(fibre::mask_of_cells(state_.body->mesh, *asked.paint));
    placed_.remember(state_.body, mask, asked.paint);
    Settings settings = state_.settings;
    settings.muscles[index].paint = mask;
    change_settings({settings, asked.what, false});
}

void Workbench::on(const ImportSignal& asked) {
    const auto index = static_cast<std::size_t>(asked.muscle);
    if (asked.muscle < 0 || index >= state_.settings.muscles.size()) return;
    const Result<fibre::Signal> signal = backend_->read_signal(asked.path, state_.settings.muscles[index].name);
    if (!signal) return log_failure(signal.error(), "Cannot import the signal");
    Settings settings = state_.settings;
    settings.muscles[index].signal = *signal;
    change_settings({settings, "import signal", false});
    log(LogLevel::done, "Signal of " + settings.muscles[index].name + " read from " + asked.path.string() + ".");
}

void Workbench::on(const ExportSignal& asked) {
    const Result<void> written = backend_->write_signal(asked.path, asked.muscle, asked.signal);
    if (!written) return log_failure(written.error(), "Cannot export the signal");
    log(LogLevel::done, "Signal of " + asked.muscle + " written to " + asked.path.string() + ".");
}

void Workbench::place_muscles() {
    state_.paint.clear();
    state_.part_paint.reset();
    if (!state_.body) return;
    if (const int part = state_.brush.part; part >= 0 && part <= static_cast<int>(state_.scene->parts.size())) {
        // A part that is not painted yet, such as a new one, begins blank.
        const bool is_new = part == static_cast<int>(state_.scene->parts.size());
        const auto mask = is_new ? nullptr : state_.scene->parts[static_cast<std::size_t>(part)].mask;
        state_.part_paint = placed_.of(mask, state_.body);
    }
    for (const Muscle& muscle : state_.settings.muscles) state_.paint.push_back(placed_.of(muscle, state_.body));
}

void Workbench::on(const ChooseMuscle& c) {
    state_.muscle = std::clamp(c.muscle, 0, std::max(0, static_cast<int>(state_.settings.muscles.size()) - 1));
}

void Workbench::on(const ChangeBrush& c) {
    const bool another = c.brush.part != state_.brush.part;
    state_.brush = c.brush;
    if (another) place_muscles();
}

}  // namespace myo::ui::commands
