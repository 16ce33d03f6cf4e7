#include "panels/command_field.hpp"

#include <cstring>

namespace myo::ui::panels {
namespace {

/// Gauge pressure of a chamber. Dragging changes it by at least 0.1 kPa per pixel.
const CommandField pressure{commands::Dimension::pressure, "kPa", "Pressure", {-1e6, 1e7}, 0.1, 1e4};
/// A thread only pulls.
const CommandField tension{commands::Dimension::force, "N", "Tension", {0.0, 1e4}, 0.01, 1.0};
/// A motor may also give thread out.
const CommandField shortening{commands::Dimension::length, "mm", "Shortening", {-1.0, 1.0}, 0.01, 1e-3};

}  // namespace

const CommandField& command_field(const DeclaredActuator& actuator) {
    if (std::strcmp(actuator.command, "pressure_Pa") == 0) return pressure;
    return std::strcmp(actuator.command, "tension_N") == 0 ? tension : shortening;
}

}  // namespace myo::ui::panels
