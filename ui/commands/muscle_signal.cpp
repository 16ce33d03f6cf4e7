#include "commands/muscle_signal.hpp"

namespace myo::ui::commands {

fibre::Signal signal_of(const WorkbenchState& state, const Muscle& muscle) {
    if (!muscle.follows.empty()) {
        for (const Muscle& other : state.settings.muscles) {
            // A muscle that follows another one itself is no leader; this also ends the recursion after one level.
            if (other.name != muscle.follows || !other.follows.empty()) continue;
            fibre::Signal signal = signal_of(state, other);
            for (double& a : signal.values) a = 1.0 + muscle.ratio * (a - 1.0);
            return signal;
        }
        // The leader no longer exists.
        return fibre::Signal::constant(1.0);
    }
    // An own signal holds for all trials; otherwise the shown trial's recording is used.
    if (muscle.signal) return *muscle.signal;
    const SceneTrial* const trial = state.scene_trial();
    const auto recorded = trial ? trial->activation.find(muscle.declared) : decltype(trial->activation.end()){};
    return trial && recorded != trial->activation.end() ? recorded->second : fibre::Signal::constant(1.0);
}

}  // namespace myo::ui::commands
