#include "commands/field_store.hpp"

#include <algorithm>
#include <chrono>
#include <limits>

#include "commands/scene_at_time.hpp"

namespace myo {
namespace {

// Frames among which the range of a trial is looked for: extremes change little from one frame to the next.
constexpr std::size_t range_frames = 24;

std::array<double, 2> range_of(const Eigen::VectorXd& values) {
    std::array<double, 2> range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const double v : values)
        if (std::isfinite(v)) range = {std::min(range[0], v), std::max(range[1], v)};
    return range;
}

}  // namespace

void FieldStore::take(Answer answer) {
    if (!(answer.source == source_)) return;   // the person has gone on
    if (answer.range) range_ = answer.range;
    if (answer.values.size() > 0) frame_ = answer.frame;
    auto frame = std::make_shared<FieldFrame>();
    frame->values = answer.values.size() > 0 || !shown_ ? std::move(answer.values) : shown_->values;
    frame->trial_range = range_;
    shown_ = std::move(frame);
}

std::shared_ptr<const FieldFrame> FieldStore::update(const WorkbenchState& state, const Backend& backend) {
    if (job_.valid() && job_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) take(job_.get());
    const SimulatedTrial* const trial = state.simulated_trial();
    Source wanted{state.shown_run(), state.body, state.view.field, static_cast<std::size_t>(state.trial)};
    if (wanted.field.empty() || !trial || trial->frames.empty() || !state.body) {
        source_ = {};
        shown_.reset();
        return nullptr;
    }
    if (!(wanted == source_)) {
        // Of another field or body nothing can be shown; of another run of the same the last values will do until its own are there.
        const bool keeps = source_.field == wanted.field && source_.body == wanted.body;
        if (!keeps) shown_.reset();
        source_ = wanted;
        frame_.reset();
        range_.reset();
    }
    const TimePlace place = place_in_time(trial->frame_time_s, state.time_s);
    const auto nearest = static_cast<std::size_t>(place.weight < 0.5 ? place.index : place.next);
    if (job_.valid()) return shown_;
    if (frame_ != nearest) {
        job_ = std::async(std::launch::async, [wanted, nearest, &backend] { return Answer{wanted, nearest, backend.field(wanted.field, *wanted.body, *wanted.run, wanted.trial, nearest), {}}; });
    } else if (!range_) {
        job_ = std::async(std::launch::async, [wanted, count = trial->frames.size(), &backend] {
            std::array<double, 2> range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
            const std::size_t samples = std::min(count, range_frames);
            for (std::size_t k = 0; k < samples; ++k) {
                const std::size_t frame = samples > 1 ? k * (count - 1) / (samples - 1) : 0;
                const auto here = range_of(backend.field(wanted.field, *wanted.body, *wanted.run, wanted.trial, frame));
                range = {std::min(range[0], here[0]), std::max(range[1], here[1])};
            }
            return Answer{wanted, 0, {}, range};
        });
    }
    // What is quick is there at once.
    if (job_.valid() && job_.wait_for(std::chrono::milliseconds(4)) == std::future_status::ready) take(job_.get());
    return shown_;
}

}  // namespace myo
