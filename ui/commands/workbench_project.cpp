#include <algorithm>
#include <chrono>
#include <system_error>
#include <utility>

#include "commands/workbench.hpp"

// Projects: saving, recovery, and questions before work would be lost.

namespace myo::ui::commands {

namespace fs = std::filesystem;

namespace {

/// Deletes a project file and the folder with its masks. Errors are ignored: the files may not exist.
void remove_project(const fs::path& file) {
    std::error_code ignored;
    fs::remove(file, ignored);
    fs::remove_all(fs::path(file).replace_extension(".files"), ignored);
}

}  // namespace

Project Workbench::project() const {
    std::error_code ignored;
    // Absolute, so that the project finds it from any working folder.
    return {fs::absolute(state_.scene->path, ignored),
            state_.metres_per_unit,
            state_.settings,
            state_.view,
            state_.scene_trial() ? state_.scene_trial()->name : "",
            state_.self_contained};
}

void Workbench::save() {
    if (!state_.scene) return;
    // Without a file name, the window asks for one; saving continues in save_as().
    if (state_.project.empty())
        state_.asks_where_to_save = true;
    else
        save_as(state_.project);
}

bool Workbench::claim(const fs::path& file) {
    if (claim_.file == file && !claim_.refusal) return true;
    Result<std::shared_ptr<const void>> claimed = backend_->claim_project(file);
    // A claim that cannot be written, as in a folder without permission, is no refusal: writing the file itself reports
    // it.
    const bool taken = !claimed && claimed.error().where.empty();
    claim_ = {file, claimed ? *claimed : nullptr, taken ? std::optional(claimed.error()) : std::nullopt};
    return !taken;
}

bool Workbench::save_as(fs::path file) {
    state_.asks_where_to_save = false;
    if (!state_.scene) return false;
    if (!is_project(file)) file += project_ending;
    // This window keeps the file that it has until the new one is written.
    const Claim before = claim_;
    if (!claim(file)) {
        state_.pending.reset();
        log_failure(*claim_.refusal, "Cannot save");
        claim_ = before;
        return false;
    }
    const Result<void> written = backend_->write_project(file, project());
    if (!written) {
        // What waited for saving is dropped too, as continuing would lose the changes.
        state_.pending.reset();
        log_failure(written.error(), "Cannot save");
        claim_ = before;
        return false;
    }
    state_.project = file;
    state_.saved_settings = state_.settings;
    remember_recent(file);
    save_results(file);
    log(LogLevel::done, "Saved " + file.string() + (state_.self_contained ? ", with body and recordings." : "."));
    forget_recovered();
    go_on_with_pending();
    return true;
}

void Workbench::save_results(const fs::path& file) {
    if (!state_.self_contained || !state_.run) return;
    const auto written = backend_->write_report(fs::path(file).replace_extension(".files") / "results", *state_.scene,
                                                *state_.run, state_.found.get(), state_.diagnosis.get());
    if (!written) log_failure(written.error(), "The project is saved without its results");
}

void Workbench::on(const AnswerUnsaved& command) {
    if (!state_.pending) return;
    if (command.answer == UnsavedAnswer::cancel)
        state_.pending.reset();
    else if (command.answer == UnsavedAnswer::save)
        save();
    else {
        // The changes count as saved from here on, so that the pending action does not ask again.
        state_.saved_settings = state_.settings;
        forget_recovered();
        go_on_with_pending();
    }
}

void Workbench::forget_recovered() {
    if (!recovered_.empty()) remove_project(recovered_);
    recovered_.clear();
}

void Workbench::go_on_with_pending() {
    if (!state_.pending) return;
    const PendingAction action = *state_.pending;
    state_.pending.reset();
    if (action.quit)
        quit();
    else
        open(action.open, action.metres_per_unit);
}

void Workbench::quit() {
    // Quitting asks for unsaved changes first, then for a running job. Each answer calls quit() again.
    if (state_.unsaved()) {
        state_.pending = PendingAction{true, {}, {}};
        return;
    }
    if (request_ && !state_.asks_to_stop) {
        state_.asks_to_stop = true;
        return;
    }
    if (job_) job_->cancel();
    state_.quit = true;
}

void Workbench::on(const WriteReport& command) {
    if (!state_.scene || !state_.run) return log(LogLevel::warning, "A report needs a run.");
    const auto written = backend_->write_report(command.folder, *state_.scene, *state_.run, state_.found.get(),
                                                state_.diagnosis.get());
    if (!written) return log_failure(written.error(), "Cannot write the report");
    const std::size_t files = written->size() + static_cast<std::size_t>(command.others);
    log(LogLevel::done, "Report written to " + command.folder.string() + ": " + std::to_string(files) +
                            (files == 1 ? " file." : " files."));
}

void Workbench::remember_recent(const fs::path& path) {
    std::error_code ignored;
    const fs::path whole = fs::absolute(path, ignored).lexically_normal();
    auto& recent = state_.preferences.recent;
    // An entry that is there already moves to the front.
    std::erase(recent, whole);
    recent.insert(recent.begin(), whole);
    if (recent.size() > max_recent) recent.resize(max_recent);
}

void Workbench::autosave(const fs::path& file) {
    std::error_code ignored;
    if (autosave_job_.valid()) return;  // the last one is still being written
    if (!state_.unsaved()) return remove_project(file);
    if (state_.settings == autosaved_ && fs::exists(file, ignored)) return;
    // Stored before writing, so that edits during the writing are noticed at the next call.
    autosaved_ = state_.settings;
    Project copy = project();
    copy.copy_of = state_.project;
    copy.self_contained = false;  // the experiment is where it was; only what is unsaved needs a copy
    autosave_job_ = std::async(std::launch::async, [backend = backend_, file, project = std::move(copy)] {
        return backend->write_project(file, project);
    });
}

void Workbench::take_autosaved() {
    if (!autosave_job_.valid() || autosave_job_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    const Result<void> written = autosave_job_.get();
    if (!written) autosaved_ = state_.saved_settings;  // to be tried again
    if (!written && !autosave_failed_) log_failure(written.error(), "Cannot keep a copy for recovery");
    autosave_failed_ = !written;
}

void Workbench::finish_autosave() {
    if (autosave_job_.valid()) autosave_job_.wait();
    take_autosaved();
}

void Workbench::on(const Recover& command) {
    // Other recovery files are offered again at the next start.
    state_.recovered.clear();
    state_.recovered_words.clear();
    if (const auto other = std::exchange(after_recovery_, std::nullopt))
        log(LogLevel::information,
            other->open.filename().string() + " is not opened: the recovered work is shown instead.");
    dropped_with_body_.reset();
    recovered_ = command.file;
    request("Recover", [this, file = command.file] {
        start(request_->name, [this, file](const Progress& progress) -> Job::Completion {
            auto project = std::make_shared<Result<Project>>(backend_->read_project(file));
            auto scene = std::make_shared<Result<Scene>>(Error{"not read", ""});
            if (*project && (*project)->source_missing)
                *scene = Error{"what it was made for is not there", (*project)->source.string()};
            else if (*project)
                *scene = backend_->open((*project)->source, (*project)->metres_per_unit, progress);
            else
                *scene = project->error();
            return [this, project, scene] {
                if (!*scene) return log_failure(scene->error(), "Cannot recover");
                // Without a file: the recovery file is deleted after saving, so it is no place to save to.
                show_project({}, std::move(**project), std::move(**scene));
                // The recovered work is saved nowhere else, so it must count as unsaved.
                state_.saved_settings = state_.scene->settings;
                log(LogLevel::done, "Unsaved work was recovered. Save it to keep it.");
                build_mesh({});
            };
        });
    });
}

void Workbench::on(const DiscardRecovery&) {
    if (state_.recovered.empty()) return;
    remove_project(state_.recovered.back());
    state_.recovered.pop_back();
    state_.recovered_words.pop_back();
    if (!state_.recovered.empty()) return;
    if (const auto next = std::exchange(after_recovery_, std::nullopt)) open(next->open, next->metres_per_unit);
}

void Workbench::on(const Save&) { save(); }

void Workbench::on(const SaveAs& c) {
    // The project is written with the new choice; after a failure it is as before.
    const bool before = state_.self_contained;
    state_.self_contained = c.self_contained.value_or(before);
    if (!save_as(c.file)) state_.self_contained = before;
}

void Workbench::on(const AskWhereToSave& c) {
    state_.asks_where_to_save = c.asks && state_.scene;
    if (!c.asks) state_.pending.reset();
}

void Workbench::on(const OfferRecovery& c) {
    state_.recovered = c.files;
    state_.recovered_words.clear();
    for (const fs::path& file : c.files) state_.recovered_words.push_back(backend_->recovery_words(file));
}

void Workbench::on(const Quit&) { quit(); }

void Workbench::on(const AnswerStop& c) {
    if (c.stops && state_.asks_to_stop) quit();
    state_.asks_to_stop = false;
}

}  // namespace myo::ui::commands
