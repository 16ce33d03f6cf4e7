#pragma once

#include <string>
#include <vector>

#include "base/result.hpp"
#include "experiment/experiment.hpp"

namespace myo::calibration {

/// Quantities that a search may change.
enum class SoughtKind {
    signals,    // of one actuator, or of all whose declaration does not say otherwise
    direction,  // fibre direction of a muscle
    weights,    // painted weights of a muscle
    modulus     // Young's modulus of a part, or of the body's material
};

/// One quantity that a search changes.
struct SoughtItem {
    SoughtKind kind = SoughtKind::signals;
    std::string of = {};  // name of the actuator, muscle or part; empty: all signals, the body's material

    bool operator==(const SoughtItem&) const = default;
};

/// "signals", "signals:NAME", "direction:NAME", "weights:NAME", "modulus" or "modulus:NAME".
std::string to_string(const SoughtItem& item);

/// For people: "signals", "signal of left", "fibre direction of left", "painted weights of left", "Young's modulus of
/// the body".
std::string readable(const SoughtItem& item);

/// All quantities of an experiment that a search can change.
std::vector<SoughtItem> seekable_items(const experiment::Experiment& experiment);

/// Quantities named by the words of to_string(), without repetitions.
///
/// Errors: an unknown word; a quantity that the experiment does not have, with the reason.
Result<std::vector<SoughtItem>> sought_items(const std::vector<std::string>& words,
                                             const experiment::Experiment& experiment);

}  // namespace myo::calibration
