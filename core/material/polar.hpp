#pragma once

#include <Eigen/Core>

#include "material/material.hpp"

namespace myo::material {

/// F = U diag(sigma) V', U and V rotations; the smallest sigma carries the sign of det F.
struct SignedSvd {
    Eigen::Matrix3d U;
    Eigen::Vector3d sigma;
    Eigen::Matrix3d V;
};

SignedSvd signed_svd(const Eigen::Matrix3d& F);

/// The rotation nearest to F (polar decomposition F = R S). Of packs: Newton's iteration where F is far from singular,
/// and the singular values of the lanes where it is not. Source: Higham 1986, "Computing the polar decomposition".
Eigen::Matrix3d polar_rotation(const Eigen::Matrix3d& F);
Matrix3<Pack> polar_rotation(const Matrix3<Pack>& F);

/// dR/dF as a 9 x 9 matrix on vec(F): dR = R [w]x with (tr(S) I - S) w = axial(R'dF - dF'R).
/// Source: Barbič 2012, "Exact corotational linear FEM stiffness matrix".
Matrix9<double> polar_rotation_derivative(const Matrix3<double>& F, const Matrix3<double>& R);
Matrix9<Pack> polar_rotation_derivative(const Matrix3<Pack>& F, const Matrix3<Pack>& R);

}  // namespace myo::material
