#pragma once

#include <array>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "commands/workbench_state.hpp"

namespace myo::ui::commands {

/// Fields that can colour the body: the backend's fields of a run, then the force of the selected diagnosis row.
std::vector<FieldKind> field_kinds(const Backend& backend);

/// The field that the state's view shows. Empty if none is selected, or the id is unknown.
std::optional<FieldKind> shown_field(const WorkbenchState& state, const Backend& backend);

/// Whether a field needs a diagnosis and not only a run.
bool of_diagnosis(const FieldKind& kind);

/// What the user has to do before a field has values, as a sentence; empty if it has some.
std::string needed_for(const FieldKind& kind, const WorkbenchState& state);

/// Values of a field in one frame.
struct FieldFrame {
    Eigen::VectorXd values;                            // per node [SI unit of the field]
    std::optional<std::array<double, 2>> trial_range;  // least and greatest value over the trial; empty until known
};

/// Least and greatest value of a field over a trial, from some of its frames. {inf, -inf} if there is none.
///
/// @param count      of frames
/// @param values_at  values in a frame
std::array<double, 2> range_over_trial(std::size_t count, const std::function<Eigen::VectorXd(std::size_t)>& values_at);

/// Provides the values of the selected field at the shown time.
///
/// Computing the values of a large body takes longer than a frame, so they are computed on a background thread; the
/// last values stay visible meanwhile. Used on the UI thread; one store per view.
class FieldStore {
public:
    /// Takes finished values and requests missing ones. Never blocks for more than some milliseconds.
    ///
    /// @return the values to show; null if there are none, or none yet. The pointer changes whenever the content does.
    std::shared_ptr<const FieldFrame> update(const WorkbenchState& state, const Backend& backend);
    /// Whether a later update will bring more: the next frame has to be drawn.
    bool waits() const { return job_.valid() || (frame_ && !range_); }

private:
    /// What a set of values belongs to.
    struct Source {
        std::shared_ptr<const RunResult> run;
        std::shared_ptr<const MeshedBody> body;
        std::string field;
        std::size_t trial = 0;
        bool operator==(const Source&) const = default;
    };
    /// Inputs of the force field, which is computed at once and needs no thread.
    struct ForceKey {
        std::shared_ptr<const DiagnosisView> diagnosis;
        std::shared_ptr<const MeshedBody> body;
        std::string row;
        int trial = 0;
        double time_s = 0.0;
        bool operator==(const ForceKey&) const = default;
    };
    /// Result of the background thread.
    struct Answer {
        Source source;
        std::size_t frame = 0;
        Eigen::VectorXd values;
        std::optional<std::array<double, 2>> range;  // of the trial, if it was requested
    };
    /// Stores an answer, unless it belongs to an earlier request.
    void take(Answer answer);
    /// Force of the selected row of the diagnosis at the shown time.
    const std::shared_ptr<const FieldFrame>& update_force(const WorkbenchState& state);
    /// Drops what another source has given.
    void change_source(const Source& wanted);
    /// Requests the values of a frame.
    void request_frame(const Source& wanted, std::size_t frame, const Backend& backend);
    /// Requests the range of a trial of `count` frames, which takes up to range_frames times as long.
    void request_range(const Source& wanted, std::size_t count, const Backend& backend);

    Source source_;                               // what the values belong to, or will once they are there
    std::optional<ForceKey> force_key_;           // key of shown_ if that is a force
    std::optional<std::size_t> frame_;            // frame of shown_
    std::optional<std::array<double, 2>> range_;  // of the trial; empty: not known yet
    std::shared_ptr<const FieldFrame> shown_;     // values that update() returns
    std::future<Answer> job_;                     // its destructor waits for the thread
};

}  // namespace myo::ui::commands
