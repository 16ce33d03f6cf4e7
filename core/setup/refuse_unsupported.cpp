#include "setup/refuse_unsupported.hpp"

#include <algorithm>
#include <string>

#include "experiment/read_experiment.hpp"

namespace myo::setup {

Result<void> refuse_unsupported(const experiment::Experiment& experiment) {
    struct Kind {
        bool declared;
        std::string key;
        std::string what;
    };
    const auto hold = std::find_if(experiment.trials.begin(), experiment.trials.end(),
                                   [](const experiment::TrialDeclaration& trial) { return trial.hold; });
    const std::string hold_key = "trial[" + std::to_string(hold - experiment.trials.begin()) + "].hold";
    const bool volume = std::holds_alternative<experiment::VolumeGeometry>(experiment.geometry);
    // One line per kind: what becomes supported loses its line.
    for (const Kind& kind : {
             Kind{volume, "geometry.kind", "a volume mesh"},
             Kind{!experiment.tendons.empty(), "tendon[0]", "a tendon"},
             Kind{!experiment.parts.empty(), "part[0]", "a part"},
             Kind{experiment.mount != experiment::MountMotion::fixed, "mount.motion", "the motion of the mount"},
             Kind{!experiment.obstacles.empty(), "obstacle[0]", "an obstacle"},
             Kind{!experiment.sensors.empty(), "sensor[0]", "a sensor"},
             Kind{hold != experiment.trials.end(), hold_key, "a hold"},
         })
        if (kind.declared)
            return experiment::declaration_error(experiment, kind.key,
                                                 kind.what + " is read, but cannot be simulated yet");
    return {};
}

}  // namespace myo::setup
