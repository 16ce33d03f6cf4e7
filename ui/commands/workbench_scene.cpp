#include <algorithm>
#include <utility>

#include "commands/workbench.hpp"

// Opening an experiment, a mesh or a project, and meshing its body.

namespace myo::ui::commands {

Workbench::OpenedFile Workbench::read_file(Backend& backend, const std::filesystem::path& path,
                                           std::optional<double> metres_per_unit, const std::filesystem::path& located,
                                           const Progress& progress) {
    OpenedFile opened;
    if (is_project(path)) {
        Result<Project> read = backend.read_project(path);
        if (read) {
            opened.project = std::move(*read);
            if (!located.empty()) opened.project->source = located, opened.project->source_missing = false;
            if (opened.project->source_missing) return opened;  // the user is asked
            opened.scene = backend.open(opened.project->source, opened.project->metres_per_unit, progress);
        } else {
            opened.scene = read.error();
        }
    } else {
        opened.scene = backend.open(path, metres_per_unit, progress);
    }
    return opened;
}

void Workbench::show_opened(const std::filesystem::path& path, std::optional<double> metres_per_unit,
                            OpenedFile& opened) {
    if (opened.project && opened.project->source_missing) {
        state_.missing = MissingSource{path, opened.project->source};
        log(LogLevel::warning,
            path.filename().string() + " belongs to " + opened.project->source.string() + ", which is not there.");
        return;
    }
    if (!opened.scene) {
        log_failure(opened.scene.error(), "Cannot open");
        return;
    }
    if (opened.project)
        show_project(path, std::move(*opened.project), std::move(*opened.scene));
    else
        show_scene(std::move(*opened.scene), metres_per_unit);
    // Only what could be opened becomes a recent file.
    remember_recent(path);
    if (const auto recording = std::exchange(dropped_with_body_, std::nullopt)) read_recording(*recording, {});
    build_mesh({});
}

void Workbench::open(const std::filesystem::path& given, std::optional<double> metres_per_unit,
                     const std::filesystem::path& located) {
    std::filesystem::path path = given.lexically_normal();
    if (!path.has_filename()) path = path.parent_path();  // "folder/"
    if (!state_.recovered.empty()) {
        // The user decides first what happens to the recovered work; then this file is opened.
        after_recovery_ = PendingAction{false, path, metres_per_unit};
        return;
    }
    if (request_) {
        log(LogLevel::warning, "\"" + request_->name + "\" is still running. Cancel it before another file is opened.");
        return;
    }
    // Questions that must be answered before the file is opened. The answers call open() again.
    if (state_.unsaved()) {
        state_.pending = PendingAction{false, path, metres_per_unit};
        return;
    }
    if (!is_project(path) && !metres_per_unit && backend_->needs_unit(path)) {
        state_.unit_question = path;
        return;
    }
    request("Open " + path.filename().string(), [this, path, metres_per_unit, located] {
        start(request_->name, [this, path, metres_per_unit, located](const Progress& progress) -> Job::Completion {
            auto opened = std::make_shared<OpenedFile>(read_file(*backend_, path, metres_per_unit, located, progress));
            return [this, path, metres_per_unit, opened] { show_opened(path, metres_per_unit, *opened); };
        });
    });
}

void Workbench::forget_scene() {
    stop_live();
    state_.body.reset();
    state_.actuators = {};
    state_.part_shares.resize(0, 0);
    state_.brush.part = -1;
    state_.ground.reset();
    state_.run.reset();
    state_.found.reset();
    state_.search.reset();
    state_.diagnosis.reset();
    state_.checks.reset();
    state_.import.reset();
    state_.view.clip = {};
    state_.history.clear();
    state_.candidate.clear();
    state_.refused.clear();
    state_.muscle = 0;
}

void Workbench::report_scene() {
    const auto counted = [](std::size_t count, const std::string& what) {
        return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
    };
    const bool measured = !state_.scene->trials.empty();
    const std::string content = counted(state_.scene->trials.size(), "trial") + ", " +
                                counted(state_.scene->markers.size(), "marker") + ".";
    log_done("Opened " + state_.scene->name + (measured ? ": " + content : "."), state_.scene->checks);
    for (const std::string& warning : state_.scene->warnings) log(LogLevel::warning, warning);
    show_checks(state_.scene->checks, state_.settings);
}

void Workbench::show_scene(Scene scene, std::optional<double> metres_per_unit) {
    // From here on everything that belongs to the previous scene is replaced or removed.
    state_.settings = state_.saved_settings = autosaved_ = within_limits(scene.settings);
    state_.project.clear();
    claim_ = {};
    state_.self_contained = false;
    state_.metres_per_unit = metres_per_unit;
    if (scene.frequency_Hz > 0.0) state_.damping_frequency_Hz = scene.frequency_Hz;
    check_stability();
    state_.scene = std::make_shared<Scene>(std::move(scene));
    // The request that opened the scene continues with meshing, for which it needs the new scene and settings.
    if (request_) request_->scene = state_.scene, request_->settings = state_.settings;
    forget_scene();
    if (state_.scene->surface.vertices.cols() > 0) state_.brush = brush_for(state_.scene->surface);
    place_muscles();
    // Earlier settings belong to another scene.
    undo_.clear();
    state_.can_undo = state_.can_redo = false;
    state_.playing = false;
    state_.marker = 0;
    choose_trial(0);
    state_.prediction = backend_->predict(*state_.scene, state_.settings);
    report_scene();
}

void Workbench::show_project(const std::filesystem::path& file, Project project, Scene scene) {
    for (const std::string& warning : project.warnings) log(LogLevel::warning, warning);
    // The experiment may have changed since the project was saved.
    for (Muscle& muscle : project.settings.muscles) {
        const auto& declared = scene.settings.muscles;
        const bool known = std::any_of(declared.begin(), declared.end(),
                                       [&](const Muscle& own) { return own.name == muscle.declared; });
        if (muscle.declared.empty() || known) continue;
        log(LogLevel::warning, "The experiment no longer has the muscle " + muscle.declared +
                                   "; the project keeps it as its own muscle" +
                                   (muscle.paint ? "." : ", without paint."));
        // Without a declared counterpart the muscle is kept as one created in the workbench.
        muscle.declared.clear();
    }
    // The scene is shown as the project declares it at once: edits of trials and markers are refused while a request
    // runs, and opening is one.
    if (const Declaration& kept = project.settings.declaration; kept.text && scene.is_experiment) {
        if (Result<Scene> declared = backend_->redeclared(scene, kept, nullptr)) {
            scene = std::move(*declared);
        } else {
            log(LogLevel::warning,
                "The project's edits of the experiment no longer apply: " + declared.error().text() + ".");
            project.settings.declaration = {};
        }
    }
    show_scene(std::move(scene), project.metres_per_unit);
    state_.project = file;
    if (!file.empty() && !claim(file))
        log(LogLevel::warning, claim_.refusal->text() + ". Save under another name here, or close one of the two.");
    state_.self_contained = project.self_contained;
    state_.view = project.view;
    set_settings(project.settings);
    state_.saved_settings = autosaved_ = state_.settings;
    if (request_) request_->settings = state_.settings;
    for (std::size_t t = 0; t < state_.scene->trials.size(); ++t)
        if (state_.scene->trials[t].name == project.trial) choose_trial(static_cast<int>(t));
}

bool Workbench::end_without_mesh(const Result<MeshedBody>& body, bool cancelled) {
    if (cancelled) {
        log(LogLevel::information, "Meshing cancelled.");
        end_task(JobOutcome::stopped, "meshing cancelled");
        return true;
    }
    if (!body) {
        log_failure(body.error(), "Cannot mesh");
        end_task(JobOutcome::failed, body.error().text());
        return true;
    }
    return false;
}

void Workbench::build_mesh(std::function<void()> then) {
    const Settings settings = request_->settings;
    // Preparing the body for painting takes long on large meshes, so it belongs to the same job.
    const auto scene = request_->scene;
    start("Mesh", [this, settings, scene, then = std::move(then)](const Progress& progress) -> Job::Completion {
        auto body = std::make_shared<Result<MeshedBody>>(backend_->mesh(*scene, settings, progress));
        const std::shared_ptr<const PaintGround> ground = *body ? paint_ground(scene->surface, (*body)->mesh, progress)
                                                                : nullptr;
        const bool cancelled = progress.cancelled();
        return [this, settings, body, ground, cancelled, then] {
            if (end_without_mesh(*body, cancelled)) return;
            request_->on = {std::make_shared<const MeshedBody>(std::move(**body)), ground, settings};
            show_body(request_->on);
            for (const ReportLine& line : state_.body->report) {
                if (line.warning) log(LogLevel::warning, line.label + ": " + line.value);
            }
            // `then` continues the request. Without it, a request that only meshes ends here; opening ends without a
            // record.
            if (then)
                then();
            else if (request_->name == "Mesh")
                end_task(JobOutcome::done,
                         std::to_string(state_.body->mesh.cell_count()) + " " + to_string(settings.element));
        };
    });
}

void Workbench::show_body(const PlacedBody& on) {
    if (on.body == state_.body) return;
    stop_live();
    state_.body = on.body;
    // The mesh has the actuators of its time; edits since then may have moved them on it.
    const bool as_meshed = on.settings.declaration == state_.settings.declaration;
    state_.actuators = as_meshed ? on.body->actuators : backend_->actuators(*state_.scene, *on.body);
    state_.ground = on.ground;
    state_.body_settings = on.settings;
    place_parts();
    place_muscles();
    stop_preview();
    state_.run.reset();
    state_.found.reset();
}

void Workbench::on(const Open& c) {
    dropped_with_body_.reset();
    open(c.path, c.metres_per_unit);
}

void Workbench::on(const AnswerUnit& c) {
    const auto path = std::exchange(state_.unit_question, std::nullopt);
    if (path && c.metres_per_unit) open(*path, c.metres_per_unit);
}

void Workbench::on(const Locate& c) {
    const auto missing = std::exchange(state_.missing, std::nullopt);
    if (missing && !c.source.empty()) open(missing->project, std::nullopt, c.source);
}

void Workbench::on(const BuildMesh&) {
    if (state_.scene) request("Mesh", [this] { build_mesh({}); });
}

}  // namespace myo::ui::commands
