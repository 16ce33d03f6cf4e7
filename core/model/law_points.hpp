#pragma once

#include <vector>

#include "model/loaded_face.hpp"

namespace myo::model {

/// Place where a law is evaluated.
struct LawPoint {
    Eigen::VectorXd shape;      // shape functions of the carrier's nodes
    Eigen::MatrixX2d gradient;  // their derivatives along the face; no rows: the normal is that at rest
    double weight = 1.0;        // rest area [m2] or volume [m3] of the point; 1 of a single point
    double rest_measure = 1.0;  // |X_u x X_v| of the face
    Eigen::Vector3d rest_m = Eigen::Vector3d::Zero();
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // outward, at rest; zero inside the body
};

/// Nodes of one cell that carry the force of a law at points between them.
struct LawCarrier : LoadedFace {
    std::vector<LawPoint> points;
};

/// Quadrature points of faces.
///
/// @param faces  columns of Body::boundary
std::vector<LawCarrier> law_points_of_faces(const Body& body, const std::vector<int>& faces);

/// Quadrature points of all cells.
std::vector<LawCarrier> law_points_of_cells(const Body& body);

/// One point as a sum over nodes of a cell.
///
/// @param shares  per node, sums to 1
/// @param normal  outward unit normal at rest
std::vector<LawCarrier> law_point(const Body& body, int cell, const std::vector<int>& nodes,
                                  const Eigen::VectorXd& shares, const Eigen::Vector3d& normal);

}  // namespace myo::model
