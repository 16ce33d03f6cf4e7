#pragma once

#include <gtest/gtest.h>

#include <string>

#include "mesh/surface_mesh.hpp"
#include "mesh/vtk_writer.hpp"
#include "support/folder.hpp"

namespace myo::test {

/// A robot with every table of the last section of the schema, on a hollow block of 100 x 30 x 30 mm.
inline const std::string robot_toml = R"(schema = "experiment/1"
name = "robot"
[geometry]
kind = "stl"
file = "body.stl"
unit = "cm"
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
[[muscle]]
name = "belly"
box_m = [[0.01, 0.0, 0.0], [0.09, 0.015, 0.004]]
fibre = [1.0, 0.0, 0.0]
stiffness_Pa = 8e4
[[muscle]]
name = "back"
box_m = [[0.01, 0.0, 0.026], [0.09, 0.015, 0.03]]
fibre = [1.0, 0.0, 0.0]
stiffness_Pa = 8e4
follows = { muscle = "belly", ratio = -0.5 }
[[chamber]]
name = "upper"
inside_m = [0.03, 0.015, 0.015]
[[tendon]]
name = "left"
path_m = [[0.0, 0.0, 0.01], [0.05, 0.0, 0.01], [0.1, 0.0, 0.01]]
drive = "tension"
friction = 0.2
[[tendon]]
name = "right"
path_m = [[0.0, 0.03, 0.01], [0.1, 0.03, 0.01]]
drive = "shortening"
stiffness_N_m = 4000.0
[[part]]
name = "spine"
box_m = [[0.0, 0.0, 0.0], [0.1, 0.03, 0.002]]
youngs_modulus_Pa = 2.0e6
calibrate = ["youngs_modulus"]
[[part]]
name = "core"
file = "core.stl"
damping_s = 0.01
[mount]
motion = "markers"
[[obstacle]]
kind = "plane"
point_m = [0.0, 0.0, -0.01]
normal = [0.0, 0.0, 2.0]
friction = 0.4
[[obstacle]]
kind = "sphere"
centre_m = [0.0, 0.0, 0.1]
radius_m = 0.05
[[obstacle]]
kind = "box"
box_m = [[0.2, 0.0, 0.0], [0.3, 0.1, 0.1]]
[markers.rest_m]
tip = [0.1, 0.0, 0.024]
[markers.fixed_m]
base_1 = [-0.09, -0.01, 0.0]
base_2 = [-0.09, 0.01, 0.0]
base_3 = [-0.09, 0.01, 0.03]
[[sensor]]
name = "cell"
kind = "reaction"
noise = 0.005
[[sensor]]
name = "volume"
kind = "chamber_volume"
of = "upper"
noise = 1e-8
[[sensor]]
name = "pull"
kind = "tendon_tension"
of = "right"
noise = 0.1
[[sensor]]
name = "reel"
kind = "tendon_shortening"
of = "left"
noise = 1e-4
[[trial]]
name = "held"
role = "fit"
trace = "held.csv"
format = "csv"
hold = true
activation = { belly = 0.8 }
pressure_Pa = { upper = -500 }
tension_N = { left = 3.08 }
shortening_m = { right = 0.002 }
sensor = { cell_x_N = 0.2, volume = 2e-6 }
[[trial]]
name = "driven"
role = "fit"
trace = "driven.csv"
format = "csv"
start = "equilibrium"
actuation = "driven_actuation.csv"
tension_N = { left = 1.0 }
sensors = "driven_sensors.csv"
[[trial]]
name = "stepped"
role = "fit"
trace = "driven.csv"
format = "csv"
start = "straight"
actuation_step = { upper = 20000.0, left = "free", right = 0.01, belly = 0.9 }
[limits]
pressure_Pa = 3e4
tension_N = 12
shortening_m = 0.02
activation = 0.7
force_N = 2
mass_kg = 0.1
duration_s = 5
)";

/// The block with two closed cavities, in centimetres.
inline mesh::SurfaceMesh hollow_block() {
    mesh::SurfaceMesh body = mesh::box_surface(Box{{0, 0, 0}, {0.1, 0.03, 0.03}});
    for (const Box& cavity :
         {Box{{0.02, 0.01, 0.01}, {0.04, 0.02, 0.02}}, Box{{0.06, 0.01, 0.01}, {0.08, 0.02, 0.02}}}) {
        const mesh::SurfaceMesh inner = mesh::box_surface(cavity);
        const auto vertices = body.vertices.cols(), triangles = body.triangles.cols();
        body.vertices.conservativeResize(3, vertices + inner.vertices.cols());
        body.vertices.rightCols(inner.vertices.cols()) = inner.vertices;
        body.triangles.conservativeResize(3, triangles + inner.triangles.cols());
        // The boundary of a cavity faces away from the material, into the cavity.
        body.triangles.rightCols(inner.triangles.cols()) = inner.triangles.colwise().reverse().array() +
                                                           static_cast<int>(vertices);
    }
    return body;
}

/// Writes the declaration and the files that it names; recordings and the part are not opened when it is read.
inline void write_robot(const Folder& folder, const std::string& toml) {
    folder.write("experiment.toml", toml);
    for (const char* file : {"held.csv", "driven.csv", "driven_sensors.csv", "core.stl"}) folder.write(file, "-");
    folder.write("driven_actuation.csv", "time_s,upper_Pa,belly,right_m\n0,0,1,0\n1,2e4,0.8,0.01\n");
    EXPECT_TRUE(mesh::write_stl(folder.path() / "body.stl", hollow_block(), 1e-2));
}

}  // namespace myo::test
