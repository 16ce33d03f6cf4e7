#pragma once

#include <memory>
#include <optional>
#include <string>

#include "fibre/painted_mask.hpp"
#include "fibre/signal.hpp"

namespace myo::ui::commands {

/// A group of fibres with one signal. Members that are not set are taken from the experiment.
struct Muscle {
    std::string name;
    std::string declared;       // its name in the experiment; empty: created in the workbench
    int color = 0;              // index in Theme::muscles
    double stiffness_Pa = 8e4;  // w of the energy w/2 (|F m| - a)^2 per rest volume
    bool extends = false;       // active fibres lengthen, a > 1; otherwise they contract, a < 1
    std::string follows;        // name of a muscle with its own signal that this one follows; empty: own signal
    double ratio = -1.0;        // (a - 1) relative to the followed muscle; negative: antagonists
    std::shared_ptr<const fibre::PaintedMask> paint;  // rest frame; null: as the experiment declares it, or nowhere
    bool sought = true;                               // by Optimise; of a declared muscle its declaration says so
    std::optional<fibre::Signal> signal;              // a(t); empty: as the trials recorded it, otherwise passive

    bool operator==(const Muscle&) const = default;  // compares the pointer of paint, not its values
};

}  // namespace myo::ui::commands
