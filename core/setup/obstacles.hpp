#pragma once

#include "experiment/experiment.hpp"
#include "model/contact.hpp"

namespace myo::setup {

/// How stiff obstacles are, relative to the body that meets them. A body that rests on one sinks in by about the onset;
/// a cube of 30 mm with E = 0.1 MPa that meets a plane at 3 m/s by 8 % of a cell of 15 mm.
struct ContactPolicy {
    double stiffness = 10.0;     // of E / cell edge: ten times as stiff as the layer of cells that touches
    double onset = 0.01;         // of a cell's edge
    double static_slip = 0.01;   // of a cell's edge: displacement at which friction in statics is 70 % developed
    double v0_m_s = 4e-3;        // as the effect dry_friction has it
    double static_bed = 1e-7;    // of the stiffness, where no clamp holds the body: fixes sliding without friction
    double rounding = 0.5;       // of a cell's edge, at the edges of a box
    double max_rounding = 0.25;  // of the shortest side of a box
};
inline constexpr ContactPolicy contact_policy;

/// Declared obstacles as force elements on all free faces of the body, one each, in the order of declaration.
std::vector<model::ForceElementPointer> obstacle_contacts(const experiment::Experiment& experiment,
                                                          const model::Body& body);

}  // namespace myo::setup
