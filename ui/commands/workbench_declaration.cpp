#include <algorithm>
#include <utility>

#include "commands/effect_words.hpp"
#include "commands/part_edits.hpp"
#include "commands/workbench.hpp"

// Edits of the experiment's declaration: support, gravity, loads, trials, unknown values, effects, obstacles, parts.

namespace myo::ui::commands {
namespace {

/// Whether results of one scene can be shown in the other: the same markers and trials, in the same order.
bool same_shape(const Scene& a, const Scene& b) {
    const auto same_name = [](const auto& x, const auto& y) { return x.name == y.name; };
    return std::equal(a.markers.begin(), a.markers.end(), b.markers.begin(), b.markers.end(), same_name) &&
           std::equal(a.trials.begin(), a.trials.end(), b.trials.begin(), b.trials.end(),
                      [](const SceneTrial& x, const SceneTrial& y) {
                          return x.name == y.name && x.time_s.size() == y.time_s.size();
                      });
}

}  // namespace

void Workbench::on(const EditDeclaration& c) {
    if (!state_.scene || !state_.scene->is_experiment) return;
    Result<Declaration> edited = backend_->edited(*state_.scene, state_.settings.declaration, c.edits);
    if (!edited) {
        refuse(edited.error());
        return;
    }
    Settings settings = state_.settings;
    settings.declaration = std::move(*edited);
    // The list of effects that are off names them by index, which a removal shifts.
    settings.off = moved_by(std::move(settings.off), c.edits);
    change_settings({std::move(settings), c.what, c.goes_on});
}

void Workbench::on(const DeclareEffect& c) {
    if (!state_.scene || !state_.scene->is_experiment || c.added >= state_.settings.effects.size()) return;
    const AddedEffect& effect = state_.settings.effects[c.added];
    Result<Declaration> edited = backend_->edited(*state_.scene, state_.settings.declaration,
                                                  {AppendDeclared{{"effect"}, effect_text(effect.declaration)}});
    if (!edited) {
        refuse(edited.error());
        return;
    }
    Settings settings = state_.settings;
    settings.declaration = std::move(*edited);
    // The declared effect is the last one, and stays switched off if it was.
    if (effect.off) settings.off.push_back({state_.scene->effects.declared.size(), effect.declaration.id});
    // Declared and no longer added: a run must not have it twice.
    settings.effects.erase(settings.effects.begin() + static_cast<std::ptrdiff_t>(c.added));
    change_settings({std::move(settings), "effect/declare", false});
}

void Workbench::refuse(const Error& error) {
    state_.refused = error.text();
    log_failure(error, "Not changed");
}

bool Workbench::redeclare(const Declaration& declaration, const MeshedBody* body) {
    if (!state_.scene) return true;
    Result<Scene> scene = backend_->redeclared(*state_.scene, declaration, body);
    if (!scene) {
        refuse(scene.error());
        return false;
    }
    // Results are stored by the index of trial and marker. With another list they would be shown for the wrong ones.
    if (!same_shape(*scene, *state_.scene)) {
        // The result of the running job will be shown by index, too.
        if (request_) {
            log(LogLevel::warning,
                "\"" + request_->name + "\" is still running. Cancel it before trials or markers are changed.");
            return false;
        }
        stop_preview();
        state_.run.reset();
        state_.found.reset();
        state_.search.reset();
        state_.diagnosis.reset();
        state_.history.clear();
    }
    // The bar shows the newest message; that of the refusal would stand there although it is over.
    if (!state_.refused.empty()) log(LogLevel::information, "Changed; what was refused before is settled.");
    state_.refused.clear();
    // An edit of the trial that is shown leaves the time where it is.
    const std::string shown = state_.scene_trial() ? state_.scene_trial()->name : "";
    const double time_s = state_.time_s;
    const std::vector<ScenePart> parts = state_.scene->parts;
    keep_masks(parts, scene->parts);
    state_.scene = std::make_shared<const Scene>(std::move(*scene));
    follow_parts(parts);
    // The shares of a surface take the time of many frames, and most edits leave the places as they are.
    if (!same_places(parts, state_.scene->parts)) place_parts();
    // The mesh stays; what is declared of chambers and tendons on it may differ.
    if (state_.body) state_.actuators = backend_->actuators(*state_.scene, *state_.body);
    state_.marker = std::clamp(state_.marker, 0, std::max(0, static_cast<int>(state_.scene->markers.size()) - 1));
    choose_trial(state_.trial);
    if (state_.scene_trial() && state_.scene_trial()->name == shown) on(SetTime{time_s});
    return true;
}

void Workbench::on(const SaveDeclaration&) {
    if (!state_.scene || !state_.scene->is_experiment) return;
    const Result<void> written = backend_->write_declaration(*state_.scene, state_.settings.declaration);
    if (written)
        log(LogLevel::done, "Saved the experiment " + state_.scene->name + ".");
    else
        log_failure(written.error(), "Cannot save the experiment");
}

void Workbench::on(const MakeExperiment& c) {
    if (!state_.scene || state_.scene->is_experiment) return;
    const Result<void> written = backend_->write_plain_experiment(c.folder, *state_.scene, state_.settings);
    if (!written) {
        log_failure(written.error(), "Cannot make an experiment");
        return;
    }
    // What was set on the mesh is in the experiment now.
    state_.saved_settings = state_.settings;
    open(c.folder, std::nullopt);
}

}  // namespace myo::ui::commands
