#include "commands/field_store.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

#include "commands/force_arrows.hpp"
#include "commands/scene_at_time.hpp"

namespace myo::ui::commands {
namespace {

/// Id of the field of a diagnosis, in project files.
constexpr const char* force_field = "effect_force";

// Number of frames that are searched for the range of a trial. Extremes change little from one frame to the next.
constexpr std::size_t range_frames = 24;

/// Least and greatest finite value; {inf, -inf} if there is none.
std::array<double, 2> range_of(const Eigen::VectorXd& values) {
    std::array<double, 2> range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const double v : values)
        if (std::isfinite(v)) range = {std::min(range[0], v), std::max(range[1], v)};
    return range;
}

/// Magnitude of the force on the patch of each node. Null if no force is known.
std::shared_ptr<const FieldFrame> force_frame(const WorkbenchState& state) {
    const PatchForces* const forces = shown_forces(state);
    if (!forces) return nullptr;
    const Eigen::Matrix3Xd now = force_at_time(*forces, state.time_s);
    if (now.cols() == 0) return nullptr;
    const Eigen::VectorXi& patch = state.diagnosis->patch_of_node;
    FieldFrame frame;
    frame.values.resize(patch.size());
    for (Eigen::Index i = 0; i < patch.size(); ++i) frame.values(i) = now.col(patch(i)).norm();
    frame.trial_range = {0.0, forces->largest_N};
    return std::make_shared<const FieldFrame>(std::move(frame));
}

}  // namespace

std::array<double, 2> range_over_trial(std::size_t count,
                                       const std::function<Eigen::VectorXd(std::size_t)>& values_at) {
    std::array<double, 2> range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    const std::size_t samples = std::min(count, range_frames);
    for (std::size_t k = 0; k < samples; ++k) {
        // Evenly spread, with the first and the last frame among them.
        const std::size_t frame = samples > 1 ? k * (count - 1) / (samples - 1) : 0;
        const auto here = range_of(values_at(frame));
        range = {std::min(range[0], here[0]), std::max(range[1], here[1])};
    }
    return range;
}

std::vector<FieldKind> field_kinds(const Backend& backend) {
    std::vector<FieldKind> kinds = backend.fields();
    kinds.push_back({force_field, "Residual force |f|", "mN", 1e-3, false,
                     "Size of the missing force on each part of the body, by the selected row of "
                     "the diagnosis."});
    return kinds;
}

std::optional<FieldKind> shown_field(const WorkbenchState& state, const Backend& backend) {
    const std::vector<FieldKind> kinds = field_kinds(backend);
    const auto shown = std::find_if(kinds.begin(), kinds.end(),
                                    [&](const FieldKind& kind) { return kind.id == state.view.field; });
    return shown != kinds.end() ? std::optional(*shown) : std::nullopt;
}

bool of_diagnosis(const FieldKind& kind) { return kind.id == force_field; }

std::string needed_for(const FieldKind& kind, const WorkbenchState& state) {
    if (!of_diagnosis(kind)) return state.drawn_trial() ? "" : "Needs a run.";
    if (!state.diagnosis || !state.diagnosis->complete) return "Available after Diagnose.";
    return shown_forces(state) ? "" : "The selected row of the diagnosis has no forces on this body in this trial.";
}

void FieldStore::take(Answer answer) {
    if (!(answer.source == source_)) return;  // the request has changed since: this answer is of no use
    if (answer.range) range_ = answer.range;
    if (answer.values.size() > 0) frame_ = answer.frame;
    auto frame = std::make_shared<FieldFrame>();
    // An answer holds values or a range; what it does not hold stays as it was.
    if (answer.values.size() > 0 || !shown_)
        frame->values = std::move(answer.values);
    else
        frame->values = shown_->values;
    frame->trial_range = range_;
    shown_ = std::move(frame);
}

const std::shared_ptr<const FieldFrame>& FieldStore::update_force(const WorkbenchState& state) {
    // An answer that is still being computed belongs to no source then, so that take() drops it.
    change_source({});
    const ForceKey key{state.diagnosis, state.body, state.candidate, state.trial, state.time_s};
    if (!(force_key_ == key)) shown_ = force_frame(state);
    force_key_ = key;
    return shown_;
}

void FieldStore::change_source(const Source& wanted) {
    // Values of another field or body cannot be shown on this one. Values of another run of the same field and body
    // stay visible until the new ones arrive, so that a preview does not flicker.
    const bool keeps = source_.field == wanted.field && source_.body == wanted.body;
    if (!keeps) shown_.reset();
    source_ = wanted;
    frame_.reset();
    range_.reset();
}

void FieldStore::request_frame(const Source& wanted, std::size_t frame, const Backend& backend) {
    job_ = std::async(std::launch::async, [wanted, frame, &backend] {
        return Answer{wanted, frame, backend.field(wanted.field, *wanted.body, *wanted.run, wanted.trial, frame), {}};
    });
}

void FieldStore::request_range(const Source& wanted, std::size_t count, const Backend& backend) {
    job_ = std::async(std::launch::async, [wanted, count, &backend] {
        const auto values_at = [&](std::size_t frame) {
            return backend.field(wanted.field, *wanted.body, *wanted.run, wanted.trial, frame);
        };
        const std::array<double, 2> range = range_over_trial(count, values_at);
        return Answer{wanted, 0, {}, range};
    });
}

std::shared_ptr<const FieldFrame> FieldStore::update(const WorkbenchState& state, const Backend& backend) {
    // Never wait for the background thread here: the UI must not stall.
    if (job_.valid() && job_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) take(job_.get());
    const SimulatedTrial* const trial = state.drawn_trial();
    if (state.view.field == force_field) return update_force(state);
    // shown_ belongs to a run's field from here on.
    force_key_.reset();
    Source wanted{state.drawn_run(), state.body, state.view.field, static_cast<std::size_t>(state.trial)};
    if (wanted.field.empty() || !trial || trial->frames.empty() || !state.body) {
        change_source({});
        shown_.reset();
        return nullptr;
    }
    if (!(wanted == source_)) change_source(wanted);
    const TimePlace place = place_in_time(trial->frame_time_s, state.time_s);
    const auto nearest = static_cast<std::size_t>(place.weight < 0.5 ? place.index : place.next);
    // One request at a time: the backend is free for the next frame that is shown.
    if (job_.valid()) return shown_;
    // First the values of the shown frame, then the range of the trial, which takes up to range_frames times as long.
    if (frame_ != nearest)
        request_frame(wanted, nearest, backend);
    else if (!range_)
        request_range(wanted, trial->frames.size(), backend);
    // Fast fields are ready within this frame, without a frame of old values.
    if (job_.valid() && job_.wait_for(std::chrono::milliseconds(4)) == std::future_status::ready) take(job_.get());
    return shown_;
}

}  // namespace myo::ui::commands
