#pragma once

#include "fibre/cell_paint.hpp"
#include "inverse/design.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::inverse {

/// Painted weights of a muscle: the values are the volume fractions of muscle, 0 ... 1, in the cells that the muscle's
/// fibre group has points in.
///
/// Roughness: mean over the pairs of neighbouring cells of the squared difference of their changes, times the squared
/// number of cells across the muscle, so that it is that of a field and not of its cells. Edges as painted cost
/// nothing.
/// @param group   number of the muscle's fibre group in the model
/// @param fibres  with points of weight 1 in every cell that may hold muscle: its paint and a rim around it
/// @param paint   weights as declared
DesignVariablePointer fibre_amount(const mesh::VolumeMesh& mesh, std::size_t group, const fibre::FibreGroup& fibres,
                                   const fibre::CellPaint& paint);

/// The paint with these values of fibre_amount() as weights.
fibre::CellPaint with_amounts(const fibre::FibreGroup& fibres, const Eigen::VectorXd& values, fibre::CellPaint paint);

}  // namespace myo::inverse
