#pragma once

#include <vector>

#include "base/result.hpp"
#include "experiment/body_queries.hpp"
#include "experiment/experiment.hpp"

namespace myo::experiment {

/// Cavity of a chamber in the declared surface of the body.
/// Volume and area are those at rest.
struct Cavity {
    mesh::SurfaceMesh wall;  // the closed inner part that bounds it, with the vertices of the whole surface
    double volume_m3 = 0.0;  // enclosed by the wall, > 0
    double area_m2 = 0.0;    // of the wall
};

/// Cavities of the declared chambers, in their order: of each the smallest inner part of the surface around its point.
///
/// Errors, with key and line: a point in the material, outside the body or in a cavity that is not closed; two chambers
/// with one cavity.
Result<std::vector<Cavity>> chamber_cavities(const Experiment& experiment, const BodyQueries& body);

/// Closed cavity of a surface, declared as a chamber or not.
struct SurfaceCavity {
    Cavity cavity;
    Eigen::Vector3d inside_m = Eigen::Vector3d::Zero();  // a point in it [m], for chamber.inside_m
};

/// All closed cavities of a surface: its parts that face inward and hold a point at which no material is. In the order
/// of their parts.
///
/// @param body  of the closed, outward surface
std::vector<SurfaceCavity> surface_cavities(const BodyQueries& body);

}  // namespace myo::experiment
