#pragma once

#include <cmath>
#include <cstdio>
#include <string>

#include "support/folder.hpp"

namespace myo::test {

/// A 4 x 2 x 2 cm block held at x = 0 and let go under gravity; the trace is made up: a sag that settles.
inline std::string small_toml() {
    return R"(schema = "experiment/1"
name = "small block"
[geometry]
kind = "box"
size_m = [0.04, 0.02, 0.02]
[clamp]
box_m = [[-0.0005, -0.001, -0.001], [0.0005, 0.021, 0.021]]
[material]
model = "neo_hookean"
youngs_modulus_Pa = 2.0e4
poissons_ratio = 0.45
density_kg_m3 = 1000
[markers]
noise_m = 1e-4
[markers.rest_m]
tip = [0.04, 0.01, 0.02]
middle = [0.02, 0.01, 0.02]
[[trial]]
name = "drop"
role = "fit"
trace = "drop.csv"
format = "csv"
start = "straight"
[[trial]]
name = "drop again"
role = "validate"
trace = "drop.csv"
format = "csv"
start = "straight"
)";
}

/// The block with two antagonists instead, and one trial that starts at rest.
inline std::string muscled_toml() {
    return R"(schema = "experiment/1"
name = "muscled block"
[geometry]
kind = "box"
size_m = [0.04, 0.02, 0.02]
[clamp]
box_m = [[-0.0005, -0.001, -0.001], [0.0005, 0.021, 0.021]]
[material]
model = "neo_hookean"
youngs_modulus_Pa = 2.0e5
poissons_ratio = 0.45
density_kg_m3 = 1000
damping_s = 0.003
[[muscle]]
name = "upper"
box_m = [[0.0, -0.001, 0.014], [0.04, 0.021, 0.021]]
fibre = [1.0, 0.0, 0.0]
stiffness_Pa = 1.0e5
[[muscle]]
name = "lower"
box_m = [[0.0, -0.001, -0.001], [0.04, 0.021, 0.006]]
fibre = [1.0, 0.0, 0.0]
stiffness_Pa = 1.0e5
follows = { muscle = "upper", ratio = -0.5 }
[markers]
noise_m = 1e-6
[markers.rest_m]
tip = [0.04, 0.01, 0.02]
middle = [0.02, 0.01, 0.02]
[[trial]]
name = "wave"
role = "fit"
trace = "wave.csv"
format = "csv"
start = "equilibrium"
actuation = "signals.csv"
)";
}

inline std::string small_trace(double end_s = 0.1) {
    std::string text = "time_s,tip_x_m,tip_y_m,tip_z_m,middle_x_m,middle_y_m,middle_z_m\n";
    char line[256];
    const int samples = static_cast<int>(std::lround(end_s / 0.01)) + 1;
    for (int k = 0; k < samples; ++k) {
        const double t = 0.01 * k, sag = 2.5e-3 * (1.0 - std::exp(-20.0 * t) * std::cos(60.0 * t));
        std::snprintf(line, sizeof line, "%.2f,0.04,0.01,%.6f,0.02,0.01,%.6f\n", t, 0.02 - sag, 0.02 - 0.35 * sag);
        text += line;
    }
    return text;
}

inline void write_small_experiment(const Folder& folder, double end_s = 0.1) {
    folder.write("exp/experiment.toml", small_toml());
    folder.write("exp/drop.csv", small_trace(end_s));
}

/// A box as ASCII STL in millimetres, outward.
inline std::string box_stl(double lx, double ly, double lz) {
    const double corner[8][3] = {{0, 0, 0},  {lx, 0, 0},  {lx, ly, 0},  {0, ly, 0},
                                 {0, 0, lz}, {lx, 0, lz}, {lx, ly, lz}, {0, ly, lz}};
    const int face[12][3] = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                             {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
    std::string text = "solid box\n";
    char line[128];
    for (const auto& triangle : face) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const int i : triangle) {
            std::snprintf(line, sizeof line, "vertex %g %g %g\n", corner[i][0], corner[i][1], corner[i][2]);
            text += line;
        }
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid box\n";
}

}  // namespace myo::test
