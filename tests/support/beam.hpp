#pragma once

#include <Eigen/Dense>

#include <cmath>
#include <vector>

#include "material/catalogue.hpp"
#include "mesh/region.hpp"
#include "model/model.hpp"
#include "support/meshes.hpp"

namespace myo::test {

/// A beam along x from the clamp at x = 0 to the tip at x = length, rectangular cross section.
struct BeamSpec {
    fem::ElementKind kind = fem::ElementKind::hex8;
    Eigen::Vector3i cells{4, 1, 1};
    Eigen::Vector3d size{0.1, 0.03, 0.03};  // [m]
    double youngs_modulus_Pa = 263824.0;
    double poissons_ratio = 0.499;
    double density_kg_m3 = 1070.0;
    double gravity_m_s2 = 0.0;  // downwards along z
    double damping_s = 0.0;
    const char* material = "neo_hookean";
    bool clamped = true;
};

Box beam_box(const BeamSpec& spec);

model::Model make_beam(const BeamSpec& spec);

/// Shares of the nodes in the mean over the end face; also of an even traction there.
Eigen::VectorXd tip_share(const model::Model& model, const BeamSpec& spec);

/// Mean displacement of the end face [m].
Eigen::Vector3d tip_displacement(const model::Model& model, const BeamSpec& spec, const Eigen::Matrix3Xd& x);

double second_moment(const BeamSpec& spec);
double section_area(const BeamSpec& spec);

/// A dead force over the end face, for ever unless told otherwise.
void push_tip(model::Model& model, const BeamSpec& spec, const Eigen::Vector3d& force_N);

}  // namespace myo::test
