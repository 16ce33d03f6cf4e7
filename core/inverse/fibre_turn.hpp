#pragma once

#include "fibre/fibre_group.hpp"
#include "inverse/design.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::inverse {

struct FibreTurnPolicy {
    /// Total degree of the Legendre polynomials of the rest position, over the bounding box of the muscle, that a
    /// field of turns is made of: enough for a helix that changes its pitch once along the muscle.
    int degree = 3;
    double most_rad = 1.6;  // per coefficient: a direction and its opposite are the same, so that a right angle is all
};
inline constexpr FibreTurnPolicy fibre_turn_policy;

/// How the fibres of a muscle may turn: all by the same rotation, or by a smooth field of rotations.
enum class TurnField { uniform, smooth };

/// Fibre direction of a muscle. The declared direction m of each fibre becomes exp([theta]) m, where the rotation
/// vector theta [rad] is a polynomial of the rest position; its coefficients are the values, 3 per polynomial.
/// Rotations about the fibres themselves change nothing, so that their coefficients stay at zero.
///
/// Roughness: mean of |grad theta|^2 over the fibres, times the squared diagonal of the muscle's bounding box.
/// @param group   number of the muscle's fibre group in the model
/// @param fibres  as declared, with its gradients (asserted)
DesignVariablePointer fibre_turn(const mesh::VolumeMesh& mesh, std::size_t group, const fibre::FibreGroup& fibres,
                                 TurnField field);

}  // namespace myo::inverse
