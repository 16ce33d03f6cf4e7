#pragma once

#include <string>

namespace myo::test {

// Effects of the catalogue as files of laws.

inline const std::string drag_law = R"law(schema = "law/1"
id = "own_drag"
sentence = "drag that grows with the square of the speed"
acts_on = "surface"
traction_Pa = "-coefficient_kg_m3 * norm(v) * v"
[[parameter]]
name = "coefficient_kg_m3"
range = [0.0, 1e6]
scale = 300.0
over_decades = true
start = 50.0
)law";

inline const std::string cable_law = R"law(schema = "law/1"
id = "own_cable"
sentence = "a cable that pulls like a spring from a point of the surface to a fixed anchor"
acts_on = "point"
let = ["stretch_m = norm(anchor_m - x) - norm(anchor_m - X)"]
force_N = "stiffness_N_m * stretch_m * (anchor_m - x) / norm(anchor_m - x)"
[[parameter]]
name = "stiffness_N_m"
range = [0.0, 1e4]
scale = 1.0
over_decades = true
start = 0.2
[[parameter]]
name = "anchor_m"
kind = "vector"
range = [-10.0, 10.0]
scale = 0.05
start = [0.05, 0.0, 0.2]
)law";

inline const std::string lag_law = R"law(schema = "law/1"
id = "own_lag"
sentence = "the actuator follows its signal with a first-order lag"
acts_on = "signal"
signal = "s"
[[state]]
name = "s"
initial = "a"
rate = "(a - s) / time_constant_s"
[[parameter]]
name = "time_constant_s"
range = [1e-4, 100.0]
scale = 0.02
over_decades = true
start = [0.005, 0.05, 0.3]
)law";

inline const std::string bed_law = R"law(schema = "law/1"
id = "own_bed"
sentence = "the clamped face sits on an elastic bed"
acts_on = "clamp"
traction_Pa = "-stiffness_Pa_per_m * u"
[[parameter]]
name = "stiffness_Pa_per_m"
range = [1e4, 1e12]
scale = 1e6
over_decades = true
absent = inf
start = 2e8
)law";

inline const std::string scale_law = R"law(schema = "law/1"
id = "own_scale"
sentence = "all coordinates are off by a factor about the origin"
acts_on = "camera"
seen_m = "(1 + relative_error) * x"
[[parameter]]
name = "relative_error"
range = [-0.5, 2.0]
scale = 0.01
start = 0.002
)law";

}  // namespace myo::test
