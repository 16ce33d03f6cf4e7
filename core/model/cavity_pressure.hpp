#pragma once

#include <string>
#include <vector>

#include "fibre/signal.hpp"
#include "model/force_element.hpp"

namespace myo::model {

/// Gauge pressure p(t) on the walls of a cavity, following their normals. Potential -p V with cavity volume V.
///
/// @param faces        boundary faces of the walls. They must close the cavity, or leave it open at clamped nodes only:
///                     then the force on the free nodes has a potential and a symmetric tangent
/// @param pressure_Pa  p(t); its knots [Pa] are the parameters
/// @param words        what it is, for messages: "chamber upper"
/// @param factor       the pressure on the walls is this factor times p(t): corrects walls that enclose another volume
///                     than the true cavity does
/// Source: Bonet & Wood 2008, sec. 8.5 (pressure on an enclosed boundary).
ForceElementPointer cavity_pressure(const Body& body, const std::vector<int>& faces, fibre::Signal pressure_Pa,
                                    std::string words = "the cavity", double factor = 1.0);

/// Volume enclosed by the walls at positions x (3 x n [m]) [m3]; up to a constant if the walls are open.
double cavity_volume(const Body& body, const std::vector<int>& faces, const Eigen::Matrix3Xd& x);

/// Area of the walls at positions x (3 x n [m]) [m2].
double wall_area(const Body& body, const std::vector<int>& faces, const Eigen::Matrix3Xd& x);

/// Number of open edges of the walls.
///
/// @return  edges that no other wall shares and that are not clamped at both ends; 0 is required for a pressure with
///          potential
int open_edges(const Body& body, const std::vector<int>& faces);

/// Edge-connected components of the boundary that enclose a hole in the material, as lists of faces. The outer surface
/// is excluded.
std::vector<std::vector<int>> closed_cavities(const Body& body);

}  // namespace myo::model
