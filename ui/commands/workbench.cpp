#include "commands/workbench.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "plot/ticks.hpp"

namespace myo::ui::commands {
namespace {

/// Corrects the predicted size by the mesh at hand: a finer mesh of the same element type is not smaller. A finely
/// triangulated surface may produce more elements than its edge length alone suggests.
MeshPrediction no_smaller_than_coarser(MeshPrediction prediction, const WorkbenchState& state,
                                       const Settings& settings) {
    if (!state.body || prediction.exact || state.body_settings.element != settings.element ||
        state.body_settings.resolution_m < settings.resolution_m)
        return prediction;
    prediction.elements = std::max(prediction.elements, static_cast<double>(state.body->mesh.cell_count()));
    prediction.dofs = std::max(prediction.dofs, state.body->dofs);
    return prediction;
}

/// Combines lambdas into one visitor for std::visit.
template <class... F>
struct Overloaded : F... {
    using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

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
    // During an import the timeline shows the recording; its times count from the chosen start.
    if (state.import) {
        include(state.import->file.recording->time_s.array() - state.import->choices.start_s);
        return span;
    }
    if (const SceneTrial* trial = state.scene_trial()) include(trial->time_s);
    if (const SimulatedTrial* trial = state.simulated_trial()) include(trial->frame_time_s);
    return span;
}

const DiagnosisRow* WorkbenchState::diagnosis_row() const {
    // An id that no longer exists, and an empty one, fall back to the verdict's row, then to the best effect.
    if (!diagnosis || diagnosis->rows.empty()) return nullptr;
    if (const DiagnosisRow* const asked = diagnosis->row(candidate); asked && !candidate.empty()) return asked;
    for (const DiagnosisRow& row : diagnosis->rows)
        if (row.chosen) return &row;
    return diagnosis->rows.size() > 1 ? &diagnosis->rows[1] : &diagnosis->rows.front();
}

Workbench::Workbench(std::shared_ptr<Backend> backend, std::function<void()> wake)
    : backend_(std::move(backend)), wake_(std::move(wake)) {
    // Valid ids before anything is opened, so that the panels always find the selected entries.
    state_.materials = backend_->materials();
    state_.integrators = backend_->integrators();
    state_.examples = backend_->examples();
    if (!state_.materials.empty()) state_.settings.material = state_.materials.front().id;
    if (!state_.integrators.empty()) state_.settings.integrator = state_.integrators.front().id;
}

void Workbench::log(LogLevel level, const std::string& text) {
    if (state_.log.size() >= most_log_lines)
        // A tenth at once, as erasing at the front of a vector moves all other lines.
        state_.log.erase(state_.log.begin(), state_.log.begin() + most_log_lines / 10);
    state_.log.push_back({level, text});
    ++state_.logged;
}

void Workbench::log_failure(const Error& error, const std::string& what) {
    log(LogLevel::failure, what + ": " + error.text());
}

void Workbench::execute(const Command& asked) {
    std::visit(Overloaded{
                   [&](const Open& c) {
                       dropped_with_body_.reset();
                       open(c.path, c.metres_per_unit);
                   },
                   [&](const Drop& c) { drop(c.files); },
                   [&](const AnswerUnit& c) {
                       const auto path = std::exchange(state_.unit_question, std::nullopt);
                       if (path && c.metres_per_unit) open(*path, c.metres_per_unit);
                   },
                   [&](const ChangeSettings& c) { change_settings(c); },
                   [&](const Undo&) { set_settings(undo_.undo(state_.settings)); },
                   [&](const Redo&) { set_settings(undo_.redo(state_.settings)); },
                   [&](const BuildMesh&) {
                       if (state_.scene) request("Mesh", [this] { build_mesh({}); });
                   },
                   [&](const Run&) { run(); },
                   [&](const ChangePreview& c) { change_preview(c); },
                   [&](const Calibrate&) { calibrate(); },
                   [&](const ChangeOptimize& c) { state_.optimize = c.request; },
                   [&](const Optimize&) { optimize(); },
                   [&](const Diagnose&) { diagnose(); },
                   [&](const ChooseCandidate& c) {
                       state_.candidate = c.key;
                       look_at_forces();
                   },
                   [&](const AddEffect& c) { add_effect(c.key); },
                   [&](const ChooseMuscle& c) {
                       state_.muscle = std::clamp(c.muscle, 0,
                                                  std::max(0, static_cast<int>(state_.settings.muscles.size()) - 1));
                   },
                   [&](const Paint& c) { paint(c); },
                   [&](const ImportSignal& c) { import_signal(c); },
                   [&](const ExportSignal& c) { export_signal(c); },
                   [&](const ChangeBrush& c) { state_.brush = c.brush; },
                   [&](const Cancel&) {
                       if (job_) job_->cancel();
                   },
                   [&](const Pause& c) {
                       if (job_) job_->pause(c.paused);
                   },
                   [&](const Unqueue& c) {
                       std::erase_if(queue_, [&](const Task& task) { return task.id == c.id; });
                       update_queue();
                   },
                   [&](const RestoreRecord& c) { restore(c.id); },
                   [&](const CompareRecord& c) {
                       for (JobRecord& record : state_.history)
                           if (record.id == c.id) record.compared = c.compared && record.run;
                   },
                   [&](const ForgetRecord& c) { forget(c.id); },
                   [&](const Save&) { save(); },
                   [&](const SaveAs& c) { save_as(c.file); },
                   [&](const AskWhereToSave& c) {
                       state_.asks_where_to_save = c.asks && state_.scene;
                       if (!c.asks) state_.pending.reset();
                   },
                   [&](const AnswerUnsaved& c) { answer_unsaved(c.answer); },
                   [&](const OfferRecovery& c) { state_.recovered = c.files; },
                   [&](const Recover& c) { recover(c.file); },
                   [&](const DiscardRecovery&) { discard_recovery(); },
                   [&](const Quit&) { quit(); },
                   [&](const AnswerStop& c) {
                       if (c.stops && state_.asks_to_stop) quit();
                       state_.asks_to_stop = false;
                   },
                   [&](const ChooseTrial& c) { choose_trial(c.trial); },
                   [&](const ChooseMarker& c) {
                       const int count = state_.scene ? static_cast<int>(state_.scene->markers.size()) : 0;
                       state_.marker = std::clamp(c.marker, 0, std::max(0, count - 1));
                   },
                   [&](const SetTime& c) {
                       const auto span = time_span(state_);
                       if (std::isfinite(c.time_s)) state_.time_s = std::clamp(c.time_s, span[0], span[1]);
                   },
                   [&](const Play& c) {
                       const auto span = time_span(state_);
                       state_.playing = c.playing && span[1] > span[0];
                       // Playing at the end starts again from the beginning.
                       if (state_.playing && state_.time_s >= span[1]) state_.time_s = span[0];
                   },
                   [&](const SetSpeed& c) { state_.speed = std::clamp(c.speed, 0.01, 10.0); },
                   [&](const ChangeView& c) { state_.view = c.view; },
                   [&](const SetDampingFrequency& c) {
                       state_.damping_frequency_Hz = std::clamp(c.frequency_Hz, 0.01, 1000.0);
                       check_stability();
                   },
                   [&](const SetTheme& c) {
                       state_.preferences.theme = c.theme;
                       state_.preferences.scale = std::clamp(c.scale, least_scale, greatest_scale);
                   },
                   [&](const SetLayout& c) { state_.preferences.layout = c.layout; },
                   [&](const Bookmark& c) {
                       auto& kept = state_.preferences.bookmarks;
                       std::erase(kept, c.folder);
                       if (c.kept) kept.push_back(c.folder);
                   },
                   [&](const UsePreferences& c) {
                       state_.preferences = c.preferences;
                       if (c.preferences.scale > 0.0f)
                           state_.preferences.scale = std::clamp(c.preferences.scale, least_scale, greatest_scale);
                   },
                   [&](const ClearLog&) { state_.log.clear(); },
                   [&](const Tell& c) { log(c.level, c.text); },
                   [&](const WriteReport& c) { write_report(c.folder); },
                   [&](const ReadRecording& c) { read_recording(c.path, c.reading); },
                   [&](const ChangeImport& c) { change_import(c.choices); },
                   [&](const ChooseLabel& c) { choose_label(c.label, c.placing); },
                   [&](const ProposeMarkers&) { propose_markers(); },
                   [&](const AlignImport&) { align_import(); },
                   [&](const AddRecording&) { add_recording(); },
                   [&](const GiveUpImport&) { give_up_import(); },
               },
               // Values that follow from others are updated once here, not in each handler.
               asked);
    state_.can_undo = undo_.can_undo();
    state_.can_redo = undo_.can_redo();
    if (job_) state_.job = job_->view();
}

void Workbench::advance(double seconds) {
    // Values of running jobs first: their completion below must see the last ones.
    take_autosaved();
    take_live();
    if (job_) {
        if (auto completion = job_->take_result()) {
            // The completion may start the next job of the same request.
            job_.reset();
            state_.job.reset();
            if (*completion) (*completion)();
            if (!job_) begin_next();
            if (!task_) state_.asks_to_stop = false;  // the user who was asked sees the result first
        }
        if (job_) state_.job = job_->view();
    }
    advance_preview();
    if (state_.playing) {
        const auto span = time_span(state_);
        state_.time_s += seconds * state_.speed;
        // The best iterate of a search and a preview are played in a loop.
        if (state_.time_s >= (state_.previewing() ? state_.preview.end_s : span[1]) &&
            (state_.searching() || state_.previewing())) {
            state_.time_s = span[0];
        } else if (state_.time_s >= span[1]) {
            state_.time_s = span[1];
            state_.playing = false;
        }
    }
}

void Workbench::take_live() {
    if (live_diagnosis_)
        if (auto known = live_diagnosis_->take()) state_.diagnosis = std::move(known);
    if (live_search_)
        if (auto known = live_search_->take()) {
            // The first motion of a search is played, as it is what the user waits for.
            const bool first = known->best && !(state_.search && state_.search->best);
            state_.search = std::move(known);
            if (first) execute(Play{});
        }
}

void Workbench::choose_trial(int trial) {
    const int count = state_.scene ? static_cast<int>(state_.scene->trials.size()) : 0;
    state_.trial = std::clamp(trial, 0, std::max(0, count - 1));
    // Each trial starts at t = 0, if it contains it.
    const auto span = time_span(state_);
    state_.time_s = std::clamp(0.0, span[0], span[1]);
    state_.playing = false;
    stop_preview();
    want_preview();
}

void Workbench::change_settings(const ChangeSettings& change) {
    Settings settings = within_limits(change.settings);
    // Setting a step marks it as the user's own, unless the same edit switches the automatic choice.
    const bool given_back = settings.own_step != state_.settings.own_step;
    if (settings.time_step_s != state_.settings.time_step_s && !given_back) settings.own_step = true;
    if (settings == state_.settings) return;
    undo_.record(state_.settings, change.what, change.goes_on);
    set_settings(settings);
}

void Workbench::set_settings(const Settings& settings) {
    // All changes of the settings pass here: commands, undo, restored jobs and results of searches.
    state_.settings = settings;
    state_.muscle = std::clamp(state_.muscle, 0, std::max(0, static_cast<int>(settings.muscles.size()) - 1));
    place_muscles();
    check_stability();
    if (state_.scene)
        state_.prediction = no_smaller_than_coarser(backend_->predict(*state_.scene, settings), state_, settings);
    want_preview();
}

void Workbench::check_stability() {
    // Can take long for some schemes, so it is computed per change and not per frame.
    state_.critical_velocity_force_1_s.reset();
    const Choice* integrator = state_.integrator();
    if (integrator && integrator->critical_velocity_force)
        state_.critical_velocity_force_1_s = integrator->critical_velocity_force(
            2.0 * std::numbers::pi * state_.damping_frequency_Hz, state_.settings);
}

}  // namespace myo::ui::commands
