#pragma once

#include <string>

#include "support/swung_beam.hpp"

namespace myo::test {

/// The swung beam before anything was recorded: one trial of 0.6 s that is only simulated.
inline std::string planned_beam_toml() {
    const std::string recorded = swung_beam_toml();
    return recorded.substr(0, recorded.find("[[trial]]")) + R"([[trial]]
name = "swing"
role = "simulate"
duration_s = 0.6
start = "straight"
)";
}

/// Prepares the planned beam in a folder.
inline setup::Setup planned_beam(const Folder& folder) {
    folder.write("experiment.toml", planned_beam_toml());
    return setup_in(folder);
}

}  // namespace myo::test
