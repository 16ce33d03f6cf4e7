#pragma once

#include <Eigen/Core>

#include "material/material.hpp"

namespace myo::material {

/// Singular value decomposition F = U diag(sigma) V' with rotations U and V. The smallest sigma has the sign of det F.
struct SignedSvd {
    Eigen::Matrix3d U;
    Eigen::Vector3d sigma;
    Eigen::Matrix3d V;
};

/// Signed decomposition; continuous through det F = 0.
SignedSvd signed_svd(const Eigen::Matrix3d& F);

/// Rotation R of the polar decomposition F = R S, the rotation nearest to F.
/// Source: Higham 1986, "Computing the polar decomposition".
Eigen::Matrix3d polar_rotation(const Eigen::Matrix3d& F);
/// polar_rotation() per lane: Newton's iteration if all lanes are far from singular, otherwise the singular values of
/// each lane.
Matrix3<Pack> polar_rotation(const Matrix3<Pack>& F);

/// dR/dF as a 9 x 9 matrix on vec(F): dR = R [w]x with (tr(S) I - S) w = axial(R'dF - dF'R).
///
/// @param R  polar_rotation(F)
/// Source: Barbič 2012, "Exact corotational linear FEM stiffness matrix".
Matrix9<double> polar_rotation_derivative(const Matrix3<double>& F, const Matrix3<double>& R);
Matrix9<Pack> polar_rotation_derivative(const Matrix3<Pack>& F, const Matrix3<Pack>& R);

}  // namespace myo::material
