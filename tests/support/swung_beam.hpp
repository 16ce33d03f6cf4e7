#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "support/folder.hpp"
#include "support/setup_of_folder.hpp"

namespace myo::test {

/// TOML of a beam of 10 x 3 x 3 cm released under gravity: one trial to fit and one to predict. Their traces are
/// created by the test.
inline std::string swung_beam_toml() {
    return R"(schema = "experiment/1"
name = "swung beam"
[geometry]
kind = "box"
size_m = [0.1, 0.03, 0.03]
[clamp]
box_m = [[-0.0005, -0.001, -0.001], [0.0005, 0.031, 0.031]]
[material]
model = "neo_hookean"
youngs_modulus_Pa = 2.6e5
poissons_ratio = 0.49
density_kg_m3 = 1070
damping_s = 0.004
calibrate = ["youngs_modulus"]
[markers]
noise_m = 1e-4
[markers.rest_m]
tip_left = [0.1, 0.0, 0.03]
tip_right = [0.1, 0.03, 0.03]
tip_low = [0.1, 0.015, 0.0]
middle = [0.05, 0.015, 0.03]
[[trial]]
name = "swing"
role = "fit"
trace = "swing.csv"
format = "csv"
start = "straight"
[[trial]]
name = "swing again"
role = "validate"
trace = "swing.csv"
format = "csv"
start = "straight"
)";
}

/// Prepares the experiment of a folder on coarse elements, so that tests run fast.
inline setup::Setup setup_in(const Folder& folder) {
    setup::SetupSettings settings;
    // Half the thickness of the beam.
    settings.mesh.resolution_m = 0.015;
    return setup_of_folder(folder, settings);
}

/// Writes the swung beam into a folder and prepares it. Its traces hold the markers at rest, every 10 ms from 0 to
/// end_s; a test replaces them.
inline setup::Setup swung_beam(const Folder& folder, double end_s = 0.6) {
    std::string text = "time_s";
    const char* const names[] = {"tip_left", "tip_right", "tip_low", "middle"};
    for (const char* name : names)
        for (const char axis : {'x', 'y', 'z'}) text += std::string(",") + name + "_" + axis + "_m";
    for (int k = 0; k <= static_cast<int>(std::lround(100.0 * end_s)); ++k) {
        char time[32];
        std::snprintf(time, sizeof time, "\n%.2f", 0.01 * k);
        text += time;
        text += ",0.1,0,0.03,0.1,0.03,0.03,0.1,0.015,0,0.05,0.015,0.03";
    }
    folder.write("experiment.toml", swung_beam_toml());
    folder.write("swing.csv", text + "\n");
    return setup_in(folder);
}

}  // namespace myo::test
