#pragma once

#include <memory>
#include <optional>
#include <string>

#include "fibre/painted_mask.hpp"
#include "fibre/signal.hpp"

namespace myo::ui::commands {

/// A group of fibres with one signal. What is left open is as the experiment declares it.
struct Muscle {
    std::string name;
    std::string declared;       // its name in the experiment; empty: made in the workbench
    int color = 0;              // of Theme::muscles
    double stiffness_Pa = 8e4;  // w of the energy w/2 (|F m| - a)^2 per rest volume
    bool extends = false;       // when active it lengthens: a > 1; else it contracts: a < 1
    std::string follows;        // a muscle with a signal of its own; empty: this one has its own
    double ratio = -1.0;        // a - 1 is so many times that of the one it follows; negative: antagonists
    std::shared_ptr<const fibre::PaintedMask> paint;  // rest frame; null: where the experiment has it, or nowhere
    std::optional<fibre::Signal> signal;              // a(t); none: as the trials recorded it, else passive

    bool operator==(const Muscle&) const = default;  // of paint: the very same
};

}  // namespace myo::ui::commands
