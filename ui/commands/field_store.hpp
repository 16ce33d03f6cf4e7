#pragma once

#include <array>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "commands/workbench_state.hpp"

namespace myo::ui::commands {

/// What can colour the body: the backend's fields of a run, then the force of the diagnosis' chosen row.
std::vector<FieldKind> field_kinds(const Backend& backend);

/// That which the state's view shows; empty: none, or one that is not there.
std::optional<FieldKind> shown_field(const WorkbenchState& state, const Backend& backend);

/// Whether it needs a diagnosis, not a run alone.
bool of_diagnosis(const FieldKind& kind);

/// What must be done before a field has values; empty: it has some.
std::string needed_for(const FieldKind& kind, const WorkbenchState& state);

/// Values of a field in one frame.
struct FieldFrame {
    Eigen::VectorXd values;                            // per node [SI]
    std::optional<std::array<double, 2>> trial_range;  // over the trial, once that is known
};

/// The chosen field at the shown time. Large bodies take longer than a frame: values come from a thread beside the
/// drawing, the last ones are shown meanwhile.
class FieldStore {
public:
    /// Takes what has come and asks for what is missing. Null: nothing to show, or nothing yet. Another pointer
    /// whenever the content is another.
    std::shared_ptr<const FieldFrame> update(const WorkbenchState& state, const Backend& backend);
    /// Whether another update will bring more.
    bool waits() const { return job_.valid() || (frame_ && !range_); }

private:
    /// What values belong to.
    struct Source {
        std::shared_ptr<const RunResult> run;
        std::shared_ptr<const MeshedBody> body;
        std::string field;
        std::size_t trial = 0;
        bool operator==(const Source&) const = default;
    };
    struct ForceKey {
        std::shared_ptr<const DiagnosisView> diagnosis;
        std::shared_ptr<const MeshedBody> body;
        std::string row;
        int trial = 0;
        double time_s = 0.0;
        bool operator==(const ForceKey&) const = default;
    };
    struct Answer {
        Source source;
        std::size_t frame = 0;
        Eigen::VectorXd values;
        std::optional<std::array<double, 2>> range;  // of the trial, where that was asked for
    };
    void take(Answer answer);

    Source source_;
    std::optional<ForceKey> force_key_;  // of what is shown, where that is a force
    std::optional<std::size_t> frame_;   // of what is shown
    std::optional<std::array<double, 2>> range_;
    std::shared_ptr<const FieldFrame> shown_;
    std::future<Answer> job_;  // its end waits for it
};

}  // namespace myo::ui::commands
