#pragma once

#include <array>
#include <vector>

#include "base/box.hpp"

namespace myo::ui::commands {

/// A declared place, in addition to the clamp, where the body is held. Mesh frame, SI units.
struct SceneSupport {
    Box box_m;                   // material inside it is held
    std::array<bool, 3> held{};  // along x, y and z; all three: as a clamp
};
using SceneSupports = std::vector<SceneSupport>;

}  // namespace myo::ui::commands
