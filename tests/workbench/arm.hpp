#pragma once

#include <string>

namespace myo::test {

/// A silicone arm of 80 x 20 x 20 mm with a muscle above and one planned trial, in which nothing moves it yet.
inline const std::string arm_toml = R"(schema = "experiment/1"
name = "arm"
[geometry]
kind = "box"
size_m = [0.08, 0.02, 0.02]
[clamp]
box_m = [[-0.0005, -0.001, -0.001], [0.0005, 0.021, 0.021]]
[material]
model = "neo_hookean"
youngs_modulus_Pa = 2.0e5
poissons_ratio = 0.45
density_kg_m3 = 1000
damping_s = 0.005
calibrate = []
[[muscle]]
name = "upper"
box_m = [[0.0, -0.001, 0.0133], [0.08, 0.021, 0.021]]
fibre = [1.0, 0.0, 0.0]
stiffness_Pa = 1.0e5
[markers]
[markers.rest_m]
tip = [0.08, 0.01, 0.02]
[[trial]]
name = "reach"
role = "simulate"
duration_s = 0.4
start = "equilibrium"
)";
;

}  // namespace myo::test
