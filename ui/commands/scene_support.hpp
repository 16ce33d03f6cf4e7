#pragma once

#include <array>
#include <vector>

#include "base/box.hpp"

namespace myo::ui::commands {

/// A declared place besides the clamp where the body is held. Mesh frame, SI units.
struct SceneSupport {
    Box box_m;
    std::array<bool, 3> held{};  // per axis
};
using SceneSupports = std::vector<SceneSupport>;

}  // namespace myo::ui::commands
