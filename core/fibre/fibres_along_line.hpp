#pragma once

#include <string>

#include "fibre/fibre_group.hpp"
#include "fibre/polyline.hpp"

namespace myo::fibre {

/// Fibres along a polyline: material within `radius_m` of the line, with the tangent as direction. The tube has flat
/// ends and is round at corners.
///
/// Cells crossed by the wall of the tube are subdivided until the parts are small compared with the radius: volume
/// error of some tenths of a per cent on any mesh, even for a tube of a twentieth of a cell.
/// @return  empty group if the tube contains no material
FibreGroup fibres_along_line(const mesh::VolumeMesh& mesh, const Polyline& line, double radius_m, double stiffness_Pa,
                             std::string name);

/// Fibres along an axis through a point, in all cells that the axis intersects. In a hexahedral grid aligned with the
/// axis this is one column of cells, as published; an axis in a face between two columns selects one of them.
///
/// @param axis  unit
/// Source: Dubied et al. 2022.
FibreGroup fibres_in_column(const mesh::VolumeMesh& mesh, const Eigen::Vector3d& point_m, const Eigen::Vector3d& axis,
                            double stiffness_Pa, std::string name);

}  // namespace myo::fibre
