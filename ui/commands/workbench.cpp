#include "commands/workbench.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "plot/ticks.hpp"

namespace myo {
namespace {

template <class... F>
struct Overloaded : F... {
    using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

Settings clamped(Settings s) {
    const auto limit = [](double& value, const Limits& limits) { value = std::clamp(value, limits.lowest, limits.highest); };
    limit(s.youngs_modulus_Pa, youngs_modulus_limits);
    limit(s.poissons_ratio, poissons_ratio_limits);
    limit(s.density_kg_m3, density_limits);
    limit(s.damping_s, damping_limits);
    limit(s.time_step_s, time_step_limits);
    limit(s.velocity_force_1_s, velocity_force_limits);
    limit(s.spectral_radius, spectral_radius_limits);
    for (Muscle& muscle : s.muscles) {
        limit(muscle.stiffness_Pa, muscle_stiffness_limits);
        limit(muscle.ratio, muscle_ratio_limits);
    }
    return s;
}

std::string millimetres(double metres) { return value_label(1e3 * metres, 3) + " mm"; }

}  // namespace

std::array<double, 2> time_span(const WorkbenchState& state) {
    std::array<double, 2> span{0.0, 0.0};
    bool first = true;
    const auto include = [&](const Eigen::VectorXd& time) {
        if (time.size() == 0) return;
        span[0] = first ? time[0] : std::min(span[0], time[0]);
        span[1] = first ? time[time.size() - 1] : std::max(span[1], time[time.size() - 1]);
        first = false;
    };
    if (const SceneTrial* trial = state.scene_trial()) include(trial->time_s);
    if (const SimulatedTrial* trial = state.simulated_trial()) include(trial->frame_time_s);
    return span;
}

const DiagnosisRow* WorkbenchState::diagnosis_row() const {
    if (!diagnosis || diagnosis->rows.empty()) return nullptr;
    if (const DiagnosisRow* const asked = diagnosis->row(candidate); asked && !candidate.empty()) return asked;
    for (const DiagnosisRow& row : diagnosis->rows)
        if (row.chosen) return &row;
    return diagnosis->rows.size() > 1 ? &diagnosis->rows[1] : &diagnosis->rows.front();
}

Workbench::Workbench(std::shared_ptr<Backend> backend, std::function<void()> wake)
    : backend_(std::move(backend)), wake_(std::move(wake)) {
    state_.materials = backend_->materials();
    state_.integrators = backend_->integrators();
    if (!state_.materials.empty()) state_.settings.material = state_.materials.front().id;
    if (!state_.integrators.empty()) state_.settings.integrator = state_.integrators.front().id;
}

void Workbench::log(LogLevel level, const std::string& text) { state_.log.push_back({level, text}); }

void Workbench::log_failure(const Error& error, const std::string& what) {
    log(LogLevel::failure, what + ": " + error.text());
}

void Workbench::execute(const Command& asked) {
    std::visit(Overloaded{
                   [&](const command::Open& c) { open(c.path, c.metres_per_unit); },
                   [&](const command::AnswerUnit& c) {
                       const auto path = std::exchange(state_.unit_question, std::nullopt);
                       if (path && c.metres_per_unit) open(*path, c.metres_per_unit);
                   },
                   [&](const command::ChangeSettings& c) { change_settings(c); },
                   [&](const command::Undo&) { set_settings(undo_.undo(state_.settings)); },
                   [&](const command::Redo&) { set_settings(undo_.redo(state_.settings)); },
                   [&](const command::BuildMesh&) {
                       if (may_start()) build_mesh({});
                   },
                   [&](const command::Run&) { run(); },
                   [&](const command::Calibrate&) { calibrate(); },
                   [&](const command::Diagnose&) { diagnose(); },
                   [&](const command::ChooseCandidate& c) {
                       state_.candidate = c.key;
                       look_at_forces();
                   },
                   [&](const command::AddEffect& c) { add_effect(c.key); },
                   [&](const command::ChooseMuscle& c) { state_.muscle = std::clamp(c.muscle, 0, std::max(0, static_cast<int>(state_.settings.muscles.size()) - 1)); },
                   [&](const command::Paint& c) { paint(c); },
                   [&](const command::ImportSignal& c) { import_signal(c); },
                   [&](const command::ExportSignal& c) { export_signal(c); },
                   [&](const command::ChangeBrush& c) { state_.brush = c.brush; },
                   [&](const command::Cancel&) {
                       if (job_) job_->cancel();
                   },
                   [&](const command::ChooseTrial& c) { choose_trial(c.trial); },
                   [&](const command::ChooseMarker& c) {
                       const int count = state_.scene ? static_cast<int>(state_.scene->markers.size()) : 0;
                       state_.marker = std::clamp(c.marker, 0, std::max(0, count - 1));
                   },
                   [&](const command::SetTime& c) {
                       const auto span = time_span(state_);
                       if (std::isfinite(c.time_s)) state_.time_s = std::clamp(c.time_s, span[0], span[1]);
                   },
                   [&](const command::Play& c) {
                       const auto span = time_span(state_);
                       state_.playing = c.playing && span[1] > span[0];
                       if (state_.playing && state_.time_s >= span[1]) state_.time_s = span[0];
                   },
                   [&](const command::SetSpeed& c) { state_.speed = std::clamp(c.speed, 0.01, 10.0); },
                   [&](const command::ChangeView& c) { state_.view = c.view; },
                   [&](const command::SetDampingFrequency& c) {
                       state_.damping_frequency_Hz = std::clamp(c.frequency_Hz, 0.01, 1000.0);
                       check_stability();
                   },
                   [&](const command::SetTheme& c) {
                       state_.theme = c.theme;
                       state_.scale = std::clamp(c.scale, 0.75f, 3.0f);
                   },
                   [&](const command::ClearLog&) { state_.log.clear(); },
               },
               asked);
    state_.can_undo = undo_.can_undo();
    state_.can_redo = undo_.can_redo();
    if (job_) state_.job = job_->view();
}

void Workbench::advance(double seconds) {
    take_live_diagnosis();
    if (job_) {
        if (auto completion = job_->take_result()) {
            // The completion may start the next job.
            job_.reset();
            state_.job.reset();
            if (*completion) (*completion)();
        }
        if (job_) state_.job = job_->view();
    }
    if (state_.playing) {
        const auto span = time_span(state_);
        state_.time_s += seconds * state_.speed;
        if (state_.time_s >= span[1]) {
            state_.time_s = span[1];
            state_.playing = false;
        }
    }
}

void Workbench::start(const std::string& name, Job::Work work, bool staged) {
    const auto failed = [this, name](const std::string& what) -> Job::Completion {
        return [this, name, what] { log(LogLevel::failure, name + " stopped: " + what); };
    };
    job_ = std::make_unique<Job>(name, std::move(work), failed, wake_, staged);
    state_.job = job_->view();
}

bool Workbench::may_start() {
    if (job_) {
        log(LogLevel::warning, "\"" + job_->view().name + "\" is still running. Cancel it first.");
        return false;
    }
    return true;
}

bool Workbench::may_compute() {
    if (!may_start()) return false;
    if (!state_.scene) {
        log(LogLevel::warning, "Open an experiment folder first.");
        return false;
    }
    if (!state_.scene->cannot_run.empty()) {
        log(LogLevel::warning, state_.scene->cannot_run);
        return false;
    }
    return true;
}

void Workbench::open(const std::filesystem::path& path, std::optional<double> metres_per_unit) {
    if (!may_start()) return;
    if (!metres_per_unit && backend_->needs_unit(path)) {
        state_.unit_question = path;
        return;
    }
    start("Open " + path.filename().string(), [this, path, metres_per_unit](const Progress& progress) -> Job::Completion {
        auto scene = std::make_shared<Result<Scene>>(backend_->open(path, metres_per_unit, progress));
        return [this, scene] {
            if (*scene) {
                show_scene(std::move(**scene));
            } else {
                log_failure(scene->error(), "Cannot open");
            }
        };
    });
}

void Workbench::show_scene(Scene scene) {
    state_.settings = clamped(scene.settings);
    if (scene.frequency_Hz > 0.0) state_.damping_frequency_Hz = scene.frequency_Hz;
    check_stability();
    state_.scene = std::make_shared<Scene>(std::move(scene));
    state_.body.reset();
    state_.ground.reset();
    state_.run.reset();
    state_.calibration.reset();
    state_.diagnosis.reset();
    state_.candidate.clear();
    state_.muscle = 0;
    if (state_.scene->surface.vertices.cols() > 0) state_.brush = brush_for(bounding_box(state_.scene->surface.vertices).size());
    place_muscles();
    undo_.clear();
    state_.can_undo = state_.can_redo = false;
    state_.playing = false;
    state_.marker = 0;
    choose_trial(0);
    state_.prediction = backend_->predict(*state_.scene, state_.settings);
    const auto counted = [](std::size_t count, const std::string& what) {
        return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
    };
    const bool measured = !state_.scene->trials.empty();
    log(LogLevel::done, "Opened " + state_.scene->name + (measured ? ": " + counted(state_.scene->trials.size(), "trial") + ", " +
                                                                         counted(state_.scene->markers.size(), "marker") + "." : "."));
    for (const std::string& warning : state_.scene->warnings) log(LogLevel::warning, warning);
    build_mesh({});
}

void Workbench::choose_trial(int trial) {
    const int count = state_.scene ? static_cast<int>(state_.scene->trials.size()) : 0;
    state_.trial = std::clamp(trial, 0, std::max(0, count - 1));
    const auto span = time_span(state_);
    state_.time_s = std::clamp(0.0, span[0], span[1]);
    state_.playing = false;
}

void Workbench::change_settings(const command::ChangeSettings& change) {
    const Settings settings = clamped(change.settings);
    if (settings == state_.settings) return;
    undo_.record(state_.settings, change.what, change.goes_on);
    set_settings(settings);
}

void Workbench::set_settings(const Settings& settings) {
    state_.settings = settings;
    state_.muscle = std::clamp(state_.muscle, 0, std::max(0, static_cast<int>(settings.muscles.size()) - 1));
    place_muscles();
    check_stability();
    if (state_.scene) state_.prediction = backend_->predict(*state_.scene, settings);
}

void Workbench::check_stability() {
    state_.critical_velocity_force_1_s.reset();
    const Choice* integrator = state_.integrator();
    if (state_.settings.velocity_force_1_s > 0.0 && integrator && integrator->critical_velocity_force)
        state_.critical_velocity_force_1_s = integrator->critical_velocity_force(2.0 * std::numbers::pi * state_.damping_frequency_Hz, state_.settings);
}

void Workbench::build_mesh(std::function<void()> then) {
    if (!state_.scene) {
        log(LogLevel::warning, "Open an experiment folder or a mesh first.");
        return;
    }
    const Settings settings = state_.settings;
    const auto scene = state_.scene;
    start("Mesh", [this, settings, scene, then = std::move(then)](const Progress& progress) -> Job::Completion {
        auto body = std::make_shared<Result<MeshedBody>>(backend_->mesh(*scene, settings, progress));
        const bool cancelled = progress.cancelled();
        std::shared_ptr<const PaintGround> ground;
        if (*body && !cancelled) ground = std::make_shared<const PaintGround>(scene->surface, (*body)->mesh);
        return [this, settings, body, ground, cancelled, then] {
            if (cancelled) {
                log(LogLevel::information, "Meshing cancelled.");
                return;
            }
            if (!*body) {
                log_failure(body->error(), "Cannot mesh");
                return;
            }
            state_.body = std::make_shared<MeshedBody>(std::move(**body));
            state_.body_settings = settings;
            state_.ground = ground;
            place_muscles();
            // Frames of the old mesh cannot be shown on the new one.
            state_.run.reset();
            state_.calibration.reset();
            for (const ReportLine& line : state_.body->report) {
                if (line.warning) log(LogLevel::warning, line.label + ": " + line.value);
            }
            if (then) then();
        };
    });
}

void Workbench::show_run(std::shared_ptr<const RunResult> result, const Settings& settings) {
    state_.run = std::move(result);
    state_.run_settings = settings;
    const auto span = time_span(state_);
    state_.time_s = std::clamp(state_.time_s, span[0], span[1]);
    if (!state_.run->problem.empty()) log(LogLevel::warning, state_.run->problem);
    for (const std::string& warning : state_.run->warnings) log(LogLevel::warning, warning);
}

void Workbench::run() {
    if (!may_compute()) return;
    if (!state_.mesh_is_current()) {
        build_mesh([this] { run(); });
        return;
    }
    const Settings settings = state_.settings;
    const auto scene = state_.scene;
    const auto body = state_.body;
    start("Simulate", [this, settings, scene, body](const Progress& progress) -> Job::Completion {
        auto result = std::make_shared<Result<RunResult>>(backend_->simulate(*scene, *body, settings, progress));
        const bool cancelled = progress.cancelled();
        return [this, settings, result, cancelled] {
            if (cancelled) {
                log(LogLevel::information, "Simulation cancelled.");
            } else if (!*result) {
                log_failure(result->error(), "Simulation failed");
            } else {
                const double seconds = (*result)->seconds;
                const double rms = (*result)->rms_m;
                state_.calibration.reset();
                show_run(std::make_shared<RunResult>(std::move(**result)), settings);
                log(LogLevel::done, "Simulated in " + value_label(seconds, 3) + " s" +
                                        (std::isfinite(rms) ? ", rms error " + millimetres(rms) + "." : "."));
            }
        };
    });
}

void Workbench::calibrate() {
    if (!may_compute()) return;
    if (state_.scene->calibrated.empty()) {
        log(LogLevel::warning, "Nothing to calibrate: the experiment has no measured trial or declares every value as known.");
        return;
    }
    if (!state_.mesh_is_current()) {
        build_mesh([this] { calibrate(); });
        return;
    }
    const Settings settings = state_.settings;
    const auto scene = state_.scene;
    const auto body = state_.body;
    start("Calibrate", [this, settings, scene, body](const Progress& progress) -> Job::Completion {
        auto result = std::make_shared<Result<CalibrationResult>>(backend_->calibrate(*scene, *body, settings, progress));
        const bool cancelled = progress.cancelled();
        return [this, result, cancelled] {
            if (!*result && cancelled) log(LogLevel::information, "Calibration cancelled before it had any values; the settings are unchanged.");
            else if (!*result) log_failure(result->error(), "Calibration failed");
            else show_calibration(std::move(**result));
        };
    });
}

void Workbench::show_calibration(CalibrationResult result) {
    state_.calibration = std::make_shared<CalibrationResult>(std::move(result));
    const CalibrationResult& c = *state_.calibration;
    undo_.record(state_.settings, "calibration", false);
    state_.can_undo = true;
    state_.can_redo = false;
    set_settings(c.settings);
    show_run(std::shared_ptr<const RunResult>(state_.calibration, &c.run), c.settings);
    if (!c.problem.empty()) log(LogLevel::warning, c.problem);
    const std::string errors = "rms error " + millimetres(c.rms_before_m) + " before, " + millimetres(c.rms_after_m) + " after, " +
                               std::to_string(c.evaluations) + (c.evaluations == 1 ? " evaluation." : " evaluations.");
    if (c.stopped) log(LogLevel::warning, "Calibration stopped; the best values so far are kept: " + errors);
    else log(LogLevel::done, "Calibrated: " + errors);
    for (const std::string& warning : c.warnings) log(LogLevel::warning, warning);
}

}  // namespace myo
