#pragma once

#include <string>
#include <vector>

#include "validation/synthetic_case.hpp"

namespace myo::validation {

/// A plausible mistake in the declaration of an experiment.
struct Slip {
    std::string id;
    std::vector<std::string> checks;  // that name its cause
    std::string refusal;              // words of the message if the experiment may be rejected; empty: it is accepted
    /// Whether it is a mistake in this experiment.
    bool (*fits)(const SyntheticCase& truth);
    /// Applies it to the declaration or to how files are written.
    void (*make)(SyntheticCase& declared, RandomStream& random);
};

/// All slips; a new one is a line in slip.cpp.
const std::vector<Slip>& slips();
/// The slip with this id, or null.
const Slip* find_slip(const std::string& id);

}  // namespace myo::validation
