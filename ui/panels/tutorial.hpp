#pragma once

#include <array>
#include <cstddef>

#include "commands/workflow.hpp"

namespace myo::ui::panels {

/// A step of the tutorial: what to do, where, and how the program sees that it is done.
struct TutorialStep {
    const char* id;                                 // item name for tests: "open"
    const char* title;                              // "Open a body"
    const char* text;                               // what to do, with the names of the buttons
    commands::Task task;                            // where it is done
    bool (*done)(const commands::WorkbenchState&);  // whether the state shows that the step is done
};
inline constexpr std::size_t tutorial_length = 7;

/// All steps, from a body to a diagnosis.
const std::array<TutorialStep, tutorial_length>& tutorial_steps();

/// Which steps were done since the tutorial began. A step stays ticked when later work undoes its state.
class TutorialProgress {
public:
    /// Ticks the steps that are done now.
    void follow(const commands::WorkbenchState& state);
    /// Removes all ticks. Steps that the present state shows as done are ticked again by follow().
    void begin_again() { done_ = {}; }
    /// Whether a step was done since the tutorial began. `step`: below tutorial_length.
    bool done(std::size_t step) const { return done_[step]; }
    /// The first step that is not done; tutorial_length if all are.
    std::size_t next() const;

private:
    std::array<bool, tutorial_length> done_{};  // by step
};

}  // namespace myo::ui::panels
