#pragma once

#include <string>

#include "fibre/fibre_group.hpp"
#include "fibre/polyline.hpp"

namespace myo::fibre {

/// Fibres along a line: all material within `radius_m` of it pulls along its tangent. The tube ends flat and is round
/// at corners.
///
/// Cells that the tube's wall crosses are cut in eight until the parts are small against the radius: the volume is
/// right to some tenths of a per cent on any mesh, also where the tube is a twentieth of a cell. Empty where the tube
/// holds no material.
FibreGroup fibres_along_line(const mesh::VolumeMesh& mesh, const Polyline& line, double radius_m, double stiffness_Pa,
                             std::string name);

/// Fibres along an axis through a point: whole cells, those that the axis pierces, pull along it. On a grid of
/// hexahedra that lies along the axis it is one column of cells, as published; on a face between two columns it is one
/// of them. Source: Dubied et al. 2022.
///
/// @param axis  unit
FibreGroup fibres_in_column(const mesh::VolumeMesh& mesh, const Eigen::Vector3d& point_m, const Eigen::Vector3d& axis,
                            double stiffness_Pa, std::string name);

}  // namespace myo::fibre
