#include "setup/refuse_unsupported.hpp"

#include <string>

#include "experiment/read_experiment.hpp"

namespace myo::setup {

Result<void> refuse_unsupported(const experiment::Experiment& experiment) {
    struct Kind {
        bool declared;
        std::string key;
        std::string what;
    };
    // One line per kind: what becomes supported loses its line.
    for (const Kind& kind : {
             Kind{experiment.mount != experiment::MountMotion::fixed, "mount.motion", "the motion of the mount"},
         })
        if (kind.declared)
            return experiment::declaration_error(experiment, kind.key,
                                                 kind.what + " is read, but cannot be simulated yet");
    return {};
}

}  // namespace myo::setup
