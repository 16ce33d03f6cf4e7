#pragma once

#include <Eigen/Dense>

#include <cmath>
#include <vector>

#include "material/catalogue.hpp"
#include "mesh/region.hpp"
#include "model/model.hpp"
#include "support/meshes.hpp"

namespace myo::test {

/// A test beam with rectangular cross section along x, from the clamp at x = 0 to the tip at x = length.
struct BeamSpec {
    fem::ElementKind kind = fem::ElementKind::hex8;
    Eigen::Vector3i cells{4, 1, 1};         // elements along x, y, z
    Eigen::Vector3d size{0.1, 0.03, 0.03};  // [m]
    double youngs_modulus_Pa = 263824.0;
    double poissons_ratio = 0.499;
    double density_kg_m3 = 1070.0;
    double gravity_m_s2 = 0.0;             // acts downwards along z
    double damping_s = 0.0;                // Kelvin-Voigt time
    const char* material = "neo_hookean";  // id in the catalogue of materials
    bool clamped = true;                   // otherwise the beam is free
};

/// The beam at rest [m].
Box beam_box(const BeamSpec& spec);

/// The model of the beam: mesh, material and support; no loads except gravity.
model::Model make_beam(const BeamSpec& spec);

/// Weights of the nodes in the mean over the end face, sum 1. They are also the distribution of a uniform traction
/// there.
Eigen::VectorXd tip_share(const model::Model& model, const BeamSpec& spec);

/// Mean displacement of the end face [m] for node positions x [m].
Eigen::Vector3d tip_displacement(const model::Model& model, const BeamSpec& spec, const Eigen::Matrix3Xd& x);

/// Second moment of area for bending along z [m^4], and area of the cross section [m^2].
double second_moment(const BeamSpec& spec);
double section_area(const BeamSpec& spec);

/// Adds a dead force [N] on the end face, without end in time unless the caller limits it.
void push_tip(model::Model& model, const BeamSpec& spec, const Eigen::Vector3d& force_N);

}  // namespace myo::test
