#pragma once

#include <vector>

#include "fibre/signal.hpp"
#include "model/force_element.hpp"

namespace myo::model {

/// Gauge pressure p(t) on the walls of a cavity, normal to them wherever they move: potential -p V with V the cavity's
/// volume.
///
/// `faces` of the body's boundary are the walls. They close the cavity, or leave it open at clamped nodes only; then
/// the force on the free nodes has a potential and its tangent is symmetric. Parameters: the pressures at the signal's
/// knots [Pa]. Source: Bonet & Wood 2008, sec. 8.5 (pressure on an enclosed boundary).
ForceElementPointer cavity_pressure(const Body& body, const std::vector<int>& faces, fibre::Signal pressure_Pa);

/// Volume between the walls at x (3 x n) [m3], up to a constant where they are open.
double cavity_volume(const Body& body, const std::vector<int>& faces, const Eigen::Matrix3Xd& x);

/// Edges of the walls that no other wall shares and that are not clamped at both ends: none where a pressure has a
/// potential.
int open_edges(const Body& body, const std::vector<int>& faces);

/// Parts of the boundary that hang together by edges, as lists of faces; those that enclose no material but a hole in
/// it are cavities.
std::vector<std::vector<int>> closed_cavities(const Body& body);

}  // namespace myo::model
