#pragma once

#include <string>
#include <vector>

#include "validation/synthetic_case.hpp"

namespace myo::validation {

/// A plausible declaration error: what a user could write wrongly in experiment.toml or in a recording.
///
/// The truth stays as drawn; only the declaration or the written files change. A check of `myoloop calibrate` should
/// name the cause, or the experiment should be rejected with a message about it.
struct Slip {
    // In records and tables.
    std::string id;
    std::vector<std::string> checks;  // ids of the checks that name this cause
    std::string refusal;              // words of the message if the experiment may be rejected; empty: it is accepted
    /// Whether it is an error in this experiment; a wrong start, for example, needs a visible sag.
    bool (*fits)(const SyntheticCase& truth);
    /// Introduces the error into `declared`, which starts as a copy of the truth.
    void (*make)(SyntheticCase& declared, RandomStream& random);
};

/// All declaration errors; a new one is a line in slip.cpp.
const std::vector<Slip>& slips();
/// The declaration error with this id, or null.
const Slip* find_slip(const std::string& id);

}  // namespace myo::validation
