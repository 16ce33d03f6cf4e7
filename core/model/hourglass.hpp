#pragma once

#include <Eigen/Core>

#include "fem/element_block.hpp"
#include "model/model.hpp"

namespace myo {

using Matrix34d = Eigen::Matrix<double, 3, 4>;
using Matrix12d = Eigen::Matrix<double, 12, 12>;

/// Stiffness of the twelve hourglass strains h (3 x 4, as a vector of columns), energy = h'Kh / 2 [J].
///
/// It is the enhanced-strain hexahedron condensed for a box with half edges a, b, c: the bending strains, linear in one
/// coordinate, answer with plane stress (no parasitic shear, no Poisson locking), torsion with mu, the last, bilinear shape with
/// its deviatoric part. h = F^-1 x gamma is the strain variation relative to the deformed cell, so the energy
/// does not see rotations.
/// Source: Simo & Rifai 1990; Puso 2000, "A highly efficient enhanced assumed strain physically stabilized hexahedral element".
inline Matrix12d hourglass_stiffness(const HourglassGeometry& geometry, double volume, const CellModuli& moduli) {
    const double a = geometry.half_length(0), b = geometry.half_length(1), c = geometry.half_length(2);
    const double linear = volume / 3.0, bilinear = volume / 9.0;   // integrals of zeta^2 and of xi^2 eta^2
    const double mu = moduli.bulk.mu;
    const auto at = [](int coordinate, int shape) { return coordinate + 3 * shape; };   // shapes: eta zeta, xi zeta, xi eta, all
    Matrix12d K = Matrix12d::Zero();
    // Bending: two normal strains p / lp and q / lq that vary along the same axis.
    const auto bending = [&](int p, double lp, int q, double lq) {
        K(p, p) += linear * moduli.plane.plane / (lp * lp);
        K(q, q) += linear * moduli.plane.plane / (lq * lq);
        K(p, q) += linear * moduli.plane.coupling / (lp * lq);
        K(q, p) += linear * moduli.plane.coupling / (lp * lq);
    };
    bending(at(0, 1), a, at(1, 0), b);   // along zeta: strains xx and yy
    bending(at(0, 2), a, at(2, 0), c);   // along eta: xx and zz
    bending(at(1, 2), b, at(2, 1), c);   // along xi: yy and zz
    // Torsion: one shear p / lp + q / lq.
    const auto torsion = [&](int p, double lp, int q, double lq) {
        K(p, p) += linear * mu / (lp * lp);
        K(q, q) += linear * mu / (lq * lq);
        K(p, q) += linear * mu / (lp * lq);
        K(q, p) += linear * mu / (lp * lq);
    };
    torsion(at(0, 0), b, at(1, 1), a);   // along zeta: xy
    torsion(at(0, 0), c, at(2, 2), a);   // along eta: xz
    torsion(at(1, 1), c, at(2, 2), b);   // along xi: yz
    const double aa = 1.0 / (a * a), bb = 1.0 / (b * b), cc = 1.0 / (c * c);
    K(at(0, 3), at(0, 3)) += bilinear * mu * (4.0 / 3.0 * aa + bb + cc);
    K(at(1, 3), at(1, 3)) += bilinear * mu * (aa + 4.0 / 3.0 * bb + cc);
    K(at(2, 3), at(2, 3)) += bilinear * mu * (aa + bb + 4.0 / 3.0 * cc);

    if (geometry.frame.isIdentity(1e-12)) return K;
    Matrix12d Q = Matrix12d::Zero();
    for (int shape = 0; shape < 4; ++shape) Q.block<3, 3>(3 * shape, 3 * shape) = geometry.frame;
    return Q * K * Q.transpose();
}

}  // namespace myo
