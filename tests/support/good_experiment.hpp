#pragma once

#include <string>

#include "support/experiment_folder.hpp"

namespace myo::testing_support {

/// An experiment that contains every table of the schema. Tests change single lines of it and expect an error.
inline const std::string good_toml = R"(schema = "experiment/1"
name = "tail"
description = "words"

[geometry]
kind = "box"
size_m = [0.1, 0.03, 0.03]
origin_m = [0.0, 0.0, 0.0]

[clamp]
box_m = [[-5e-4, -1e-3, -1e-3], [5e-4, 0.031, 0.031]]

[material]
model = "neo_hookean"
youngs_modulus_Pa = 2.6e5
youngs_modulus_tolerance = 0.25
poissons_ratio = 0.49
density_kg_m3 = 1070
damping_s = 0.003
calibrate = ["youngs_modulus", "actuation_level"]

[environment]
gravity_m_s2 = [0, 0, -9.8]

[[muscle]]
name = "left"
box_m = [[0.01, 0.0, 0.0], [0.09, 0.015, 0.03]]
fibre = [0.999, 0.0, 0.0]
stiffness_Pa = 8e4

[[muscle]]
name = "right"
box_m = [[0.01, 0.015, 0.0], [0.09, 0.03, 0.03]]
fibre = [1.0, 0.0, 0.0]
stiffness_Pa = 8.0e4
follows = { muscle = "left", ratio = -0.5 }

[registration]
known = false
max_translation_m = 0.001
max_rotation_deg = 0.5

[markers]
noise_m = 1e-4
max_standoff_m = 0.007
compare = "displacement"
[markers.rest_m]
tip = [0.1, 0.0, 0.024]
side = [0.05, 0.036, 0.006]
[markers.fixed_m]
base = [-0.09, -0.01, 0.0]
[markers.labels]
tip = "Tip - 1"

[[trial]]
name = "release"
role = "fit"
trace = "release.csv"
format = "csv"
start = "straight"
session_time_s = 60.0
actuation = "signal.csv"
start_s = 0.5
end_s = 2.0
[[trial.load]]
kind = "mass"
box_m = [[0.0995, -0.001, -0.001], [0.1005, 0.031, 0.031]]
mass_kg = 0.05
[[trial.load]]
kind = "force"
box_m = [[0.099, -0.001, -0.001], [0.101, 0.031, 0.031]]
force_N = [0.0, 0.7, 0.25]
from_s = -inf
until_s = 0.0

[[trial]]
name = "step"
role = "fit"
trace = "step.txt"
format = "columns"
columns = { markers = ["side", "base", "tip"], unit = "mm", separator = ";", rate_Hz = 50 }
start = "equilibrium"
condition = { pressure_mbar = 75 }
actuation_step = { left = "free" }

[[trial]]
name = "check"
role = "validate"
trace = "check.tsv"
format = "qtm_tsv"
start = "equilibrium"
condition = { pressure_mbar = 125 }
actuation_step = { left = "free" }

[[effect]]
id = "clamp_compliance"
stiffness_Pa_per_m = 1.2e7
calibrate = true

[[effect]]
id = "marker_swap"
markers = ["tip", "side"]
time_s = 1.0
trial = "step"
)";

/// Writes the TOML, and a placeholder for each file that it refers to.
inline void write_files(const Folder& folder, const std::string& toml) {
    // Placeholders: these files only have to exist.
    folder.write("experiment.toml", toml);
    for (const char* file : {"release.csv", "step.txt", "check.tsv", "signal.csv", "body.stl"}) folder.write(file, "-");
}

}  // namespace myo::testing_support
