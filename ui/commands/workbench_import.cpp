#include <algorithm>
#include <utility>

#include "commands/workbench.hpp"

// Import of recordings as trials.

namespace myo::ui::commands {

void Workbench::read_recording(const std::filesystem::path& path, const ReadingOptions& reading) {
    // Checked at the request and again at its start: the body may be opened by the job before it.
    const auto has_body = [this] {
        if (!state_.scene) log(LogLevel::warning, "Open an experiment or a mesh first: the recording needs a body.");
        return state_.scene != nullptr;
    };
    if (!request_ && !has_body()) return;
    request("Read " + path.filename().string(), [this, path, reading, has_body] {
        if (!has_body()) return;  // the file that was being opened could not be read
        start(request_->name, [this, path, reading](const Progress& progress) -> Job::Completion {
            auto file = std::make_shared<Result<RecordingFile>>(backend_->read_recording(path, reading));
            const bool cancelled = progress.cancelled();
            return [this, file, cancelled] {
                if (cancelled) return log(LogLevel::information, "Reading cancelled.");
                if (!*file) return log_failure(file->error(), "Cannot import");
                if (state_.scene) begin_import(std::move(**file));
            };
        });
    });
}

void Workbench::begin_import(RecordingFile file) {
    // Reading the same file again, for example with another unit, keeps the assignments of its labels.
    const bool known = state_.import && state_.import->file.path == file.path &&
                       state_.import->file.recording->labels.size() == file.recording->labels.size();
    const bool had_no_unit = known && state_.import->file.asks_unit && !state_.import->file.reading.metres_per_unit;
    RecordingImport import;
    if (!known) import_undo_.clear();
    if (known)
        import = *state_.import;
    else {
        import.choices.markers.resize(file.recording->labels.size());
        import.choices.trial = marker_name(file.path.stem().string());
    }
    // Another sample rate changes all times, so the start has to be found again.
    if (!known || file.recording->time_s != state_.import->file.recording->time_s)
        import.choices.start_s = file.start_s.value_or(file.recording->time_s[0]);
    import.file = std::move(file);
    import.declared = backend_->declared_markers(*state_.scene);
    import.view = backend_->view_import(*state_.scene, import.file, import.choices);
    state_.import = std::make_shared<const RecordingImport>(std::move(import));
    // Distances distinguish markers only once their unit is known.
    const ImportChoices& choices = state_.import->choices;
    const bool unassigned = std::all_of(choices.markers.begin(), choices.markers.end(),
                                        [](const ImportedMarker& marker) { return marker.name.empty(); });
    const bool unit_is_open = state_.import->file.asks_unit && !state_.import->file.reading.metres_per_unit;
    if ((!known || had_no_unit) && unassigned && !unit_is_open && !state_.import->declared.empty()) propose_markers();
    state_.playing = false;
    execute(SetTime{0.0});
}

void Workbench::change_import(const ImportChoices& choices) {
    if (!state_.import || choices.markers.size() != state_.import->choices.markers.size()) return;
    RecordingImport import = *state_.import;
    import.choices = choices;
    import.view = backend_->view_import(*state_.scene, import.file, choices);
    state_.import = std::make_shared<const RecordingImport>(std::move(import));
    // The start shifts the times of the timeline; the shown time must stay within them.
    execute(SetTime{state_.time_s});
}

void Workbench::on(const ChooseLabel& command) {
    if (!state_.import) return;
    RecordingImport import = *state_.import;
    import.label = std::clamp(command.label, 0, static_cast<int>(import.choices.markers.size()) - 1);
    import.placing = command.placing && state_.body;
    state_.import = std::make_shared<const RecordingImport>(std::move(import));
    if (!command.placing) return;
    // Clicks of the brush and of the import must not compete, and labels are placed on the body at rest.
    state_.brush.tool = BrushTool::none;
    state_.playing = false;
    execute(SetTime{0.0});
}

void Workbench::propose_markers() {
    if (!state_.import) return;
    if (!state_.body) return log(LogLevel::warning, "Mesh the body first.");
    const auto proposed = backend_->propose_markers(*state_.scene, *state_.body, state_.import->file,
                                                    state_.import->choices);
    if (!proposed) return log(LogLevel::warning, proposed.error().text());
    import_undo_.record(state_.import->choices, "proposal", false);
    change_import(*proposed);
    const auto named = std::count_if(proposed->markers.begin(), proposed->markers.end(),
                                     [](const ImportedMarker& m) { return !m.name.empty(); });
    log(LogLevel::information, "Proposed " + std::to_string(named) + (named == 1 ? " marker." : " markers.") +
                                   " Check their distances before you continue.");
}

void Workbench::on(const AlignImport&) {
    const SceneTrial* const trial = state_.scene_trial();
    const SimulatedTrial* const run = state_.simulated_trial();
    if (!state_.import || !trial || !run)
        return log(LogLevel::warning, "Run the trial first to align the recording with it.");
    const auto start = backend_->align_import(*state_.scene, *run, trial->time_s, state_.import->file,
                                              state_.import->choices);
    if (!start) return log(LogLevel::warning, "Not aligned. " + start.error().text());
    ImportChoices choices = state_.import->choices;
    choices.start_s = *start;
    import_undo_.record(state_.import->choices, "start", false);
    change_import(choices);
}

void Workbench::on(const AddRecording&) {
    if (!state_.import || !state_.import->view.problem.empty()) return;
    const RecordingImport import = *state_.import;
    // Copies: the import and the settings may be edited while the job waits and runs.
    const auto scene = state_.scene;
    const Settings settings = state_.settings;
    request("Add " + import.choices.trial, [this, import, scene, settings] {
        start(request_->name, [this, import, scene, settings](const Progress& progress) -> Job::Completion {
            auto place = std::make_shared<Result<std::filesystem::path>>(
                Error{"cancelled before anything was written", ""});
            // A cancel before the writing leaves the experiment as it is; a later one comes too late.
            if (!progress.cancelled()) *place = backend_->add_recording(*scene, settings, import.file, import.choices);
            auto made = std::make_shared<Result<Scene>>(Error{"not read", ""});
            if (*place) *made = backend_->open(**place, std::nullopt, progress);
            return [this, import, scene, settings, place, made] {
                if (!*place) return log_failure(place->error(), "Cannot add the trial");
                if (!*made)
                    return log_failure(made->error(), "The trial was added, but the experiment cannot be opened");
                if (state_.scene != scene) return;  // another scene was opened meanwhile
                // Everything that was set and painted on this body is kept.
                Settings kept = state_.settings;
                // The edits of the experiment are in its file now, together with the trial.
                if (!(kept.declaration == settings.declaration))
                    log(LogLevel::warning, "Edits of the experiment made while the trial was added are lost.");
                kept.declaration = {};
                // A copy of the experiment in another folder is not what the open project refers to.
                const std::filesystem::path project = import.choices.folder.empty() ? state_.project
                                                                                    : std::filesystem::path();
                show_scene(std::move(**made), std::nullopt);
                state_.project = project;
                set_settings(kept);
                if (request_) request_->settings = state_.settings;
                for (std::size_t t = 0; t < state_.scene->trials.size(); ++t)
                    if (state_.scene->trials[t].name == import.choices.trial) choose_trial(static_cast<int>(t));
                remember_recent(state_.scene->path);
                log(LogLevel::done, "Added the trial " + import.choices.trial +
                                        (settings.declaration.text ? ", with the edits of the experiment," : "") +
                                        " in " + (*place)->string() + ".");
                build_mesh({});
            };
        });
    });
}

void Workbench::on(const CancelImport&) {
    state_.import.reset();
    // The times of the recording end with the import.
    execute(SetTime{state_.time_s});
}

void Workbench::on(const ReadRecording& c) { read_recording(c.path, c.reading); }

void Workbench::on(const ChangeImport& c) {
    if (!state_.import) return;
    // A drag or a text that is typed is one step; each marker is one.
    const bool same_markers = c.choices.markers == state_.import->choices.markers;
    import_undo_.record(state_.import->choices, same_markers ? "choices" : "markers", same_markers);
    change_import(c.choices);
}

bool Workbench::step_import(bool back) {
    if (!state_.import) return false;
    if (back ? import_undo_.can_undo() : import_undo_.can_redo())
        change_import(back ? import_undo_.undo(state_.import->choices) : import_undo_.redo(state_.import->choices));
    return true;
}

void Workbench::on(const ProposeMarkers&) { propose_markers(); }

}  // namespace myo::ui::commands
