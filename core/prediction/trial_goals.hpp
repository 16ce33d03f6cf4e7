#pragma once

#include "base/result.hpp"
#include "setup/setup.hpp"

namespace myo::prediction {

/// The setup of a single trial with its goals in place of its recording, as the target of a search for signals; the
/// same setup if the trial has no goals.
///
/// A goal over a span is sampled at the sample times of the trial and at its own times. Each sample of a goal has the
/// weight of the goal over the number of its samples, so that a goal counts the same however it is sampled. Goals are
/// places in the mesh frame: compared are positions, and no registration is sought.
/// Errors: a goal after the end of a recorded trial, or for single coordinates where the mount moves (place: line of
/// the goal).
Result<setup::Setup> with_goals(setup::Setup setup);

/// Whether the setup of a single trial has goals in place of its recording.
bool follows_goals(const setup::Setup& setup);

/// The setup of a single trial with goals, whose runs end with its last goal: what a search for signals needs of them.
/// A setup that follows a recording is returned as it is.
setup::Setup until_last_goal(setup::Setup setup);

/// The setup of a single trial whose goals are no longer compared: its trial is only simulated, as for checks of what
/// was measured. A setup that follows a recording is returned as it is.
setup::Setup without_goals(setup::Setup setup);

}  // namespace myo::prediction
