#pragma once

#include <string>
#include <vector>

#include "validation/synthetic_case.hpp"

namespace myo::validation {

/// A mistake that a person makes in declaring an experiment.
struct Slip {
    std::string id;
    std::vector<std::string> checks;  // that name its cause
    std::string refusal;              // words of the message with which it may be refused; empty: it is not
    /// Whether it is a mistake in this experiment.
    bool (*fits)(const SyntheticCase& truth);
    /// Makes it, in what is declared or in how files are written.
    void (*make)(SyntheticCase& declared, RandomStream& random);
};

/// All slips; a new one is a line in slip.cpp.
const std::vector<Slip>& slips();
/// Null where there is none of this id.
const Slip* find_slip(const std::string& id);

}  // namespace myo::validation
