#include <cstdio>
#include <utility>

#include "commands/field_store.hpp"
#include "commands/scene_at_time.hpp"
#include "commands/workbench.hpp"
#include "viewport/color_map.hpp"

// The body and the experiment, written for other programs and people.

namespace myo::ui::commands {
namespace {

namespace fs = std::filesystem;

/// What a job writes: parts of the state at the request.
struct Exported {
    ShapeExport what;
    std::shared_ptr<const MeshedBody> body;
    std::shared_ptr<const RunResult> run;  // null: the body at rest
    std::size_t trial = 0;                 // index in the run
    double time_s = 0.0;                   // shown time of the trial
    Eigen::Matrix3Xd shown_m;              // positions at the shown time
    std::optional<FieldKind> colour;       // field that is written and colours the body; empty: none
    ViewOptions view;
};

/// The simulated trial; null if the body is written at rest.
const SimulatedTrial* trial_of(const Exported& exported) {
    const bool ran = exported.run && exported.trial < exported.run->trials.size() &&
                     !exported.run->trials[exported.trial].frames.empty();
    return ran ? &exported.run->trials[exported.trial] : nullptr;
}

/// Colours of the nodes as the view shows them.
Eigen::Matrix3Xf colours_of(const viewport::DrawnField& field) {
    Eigen::Matrix3Xf colours(3, field.values.size());
    const double span = field.highest - field.lowest;
    for (Eigen::Index i = 0; i < field.values.size(); ++i) {
        const double level = (field.values(i) - field.lowest) / span;
        colours.col(i) = field.diverging
                             ? viewport::diverging_color_map(level)
                             : viewport::color_maps()[static_cast<std::size_t>(field.color_map)].color(level);
    }
    return colours;
}

/// One frame of the run, with the values of the field.
///
/// @param frame  whose values are written
ShapeFrame shape_of(const Backend& backend, const Exported& exported, std::size_t frame,
                    const Eigen::Matrix3Xd& positions_m) {
    ShapeFrame shape;
    shape.positions_m = positions_m;
    shape.metres_per_unit = exported.what.metres_per_unit;
    const SimulatedTrial* const trial = trial_of(exported);
    if (!exported.colour || !trial) return shape;
    const auto values_at = [&](std::size_t f) {
        return backend.field(exported.colour->id, *exported.body, *exported.run, exported.trial, f);
    };
    FieldFrame values{values_at(frame), {}};
    // Only colours need the range over the trial.
    if (exported.what.format == ShapeFormat::glb)
        values.trial_range = range_over_trial(trial->frames.size(), values_at);
    const std::optional<viewport::DrawnField> drawn = drawn_field(exported.view, *exported.colour, values,
                                                                  positions_m.cols());
    if (!drawn) return shape;
    shape.field = drawn->name + (drawn->unit.empty() ? "" : " [" + drawn->unit + "]");
    shape.values = drawn->values;
    shape.colours = colours_of(*drawn);
    return shape;
}

/// Writes the body as shown: positions interpolated to the shown time, values of the nearest frame.
Result<void> write_shown(const Backend& backend, const Exported& exported) {
    std::size_t nearest = 0;
    if (const SimulatedTrial* const trial = trial_of(exported)) {
        const TimePlace place = place_in_time(trial->frame_time_s, exported.time_s);
        nearest = static_cast<std::size_t>(place.weight < 0.5 ? place.index : place.next);
    }
    return backend.write_shape(exported.what.path, *exported.body,
                               shape_of(backend, exported, nearest, exported.shown_m));
}

/// Writes every frame into a folder next to the collection. Error: cancelled, or a file cannot be written.
Result<void> write_frames(const Backend& backend, const Exported& exported, const Progress& progress) {
    const SimulatedTrial& trial = *trial_of(exported);
    const fs::path folder = exported.what.path.stem().string() + "_frames";
    std::vector<double> times_s;
    std::vector<fs::path> files;
    for (std::size_t f = 0; f < trial.frames.size(); ++f) {
        if (progress.cancelled()) return Error{"cancelled", ""};
        progress.report({"frames", static_cast<double>(f), static_cast<double>(trial.frames.size()), "frames", {}});
        char name[32];
        std::snprintf(name, sizeof name, "%04zu.vtu", f);
        files.push_back(folder / name);
        times_s.push_back(trial.frame_time_s(static_cast<Eigen::Index>(f)));
        const Result<void> written = backend.write_shape(exported.what.path.parent_path() / files.back(),
                                                         *exported.body,
                                                         shape_of(backend, exported, f, trial.frames[f]));
        if (!written) return written;
    }
    return backend.write_shape_series(exported.what.path, times_s, files);
}

}  // namespace

void Workbench::on(const ExportBody& command) {
    if (!state_.body) return log(LogLevel::warning, "Build the mesh first: there is no body to write.");
    // Copies and shared pointers: the job writes what is shown now, whatever is edited meanwhile.
    Exported exported{command.what,
                      state_.body,
                      state_.shown_run(),
                      static_cast<std::size_t>(state_.trial),
                      state_.time_s,
                      positions_at_time(state_),
                      shown_field(state_, *backend_),
                      state_.view};
    // The force of a diagnosis is known on patches only, not in every frame.
    if (exported.colour && of_diagnosis(*exported.colour)) exported.colour.reset();
    if (command.what.all_frames && !trial_of(exported))
        return log(LogLevel::warning, "There are no frames to write before a run.");
    // Without end_task(): an export is no result that the history could compare or restore.
    request("Export", [this, exported = std::move(exported)] {
        start(request_->name, [this, exported](const Progress& progress) -> Job::Completion {
            const Result<void> written = exported.what.all_frames ? write_frames(*backend_, exported, progress)
                                                                  : write_shown(*backend_, exported);
            const bool cancelled = progress.cancelled();
            return [this, written, cancelled, path = exported.what.path] {
                if (cancelled) return log(LogLevel::information, "Export cancelled.");
                if (!written) return log_failure(written.error(), "Cannot export the body");
                log(LogLevel::done, "Wrote " + path.string() + ".");
            };
        });
    });
}

void Workbench::on(const SaveExperimentAs& command) {
    if (!state_.scene || !state_.scene->is_experiment) return;
    const Result<void> written = backend_->write_experiment_copy(command.folder, *state_.scene,
                                                                 state_.settings.declaration);
    if (!written) return log_failure(written.error(), "Cannot save the experiment");
    remember_recent(command.folder);
    log(LogLevel::done, "Saved a copy of the experiment, with its edits, in " + command.folder.string() + ".");
}

}  // namespace myo::ui::commands
