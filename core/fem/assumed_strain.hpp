#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

#include "fem/cell_sides.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::fem {

/// Geometry of a hexahedron whose strain varies inside the cell as in a plate in bending, in three planes at once.
///
/// Positions are x(xi) = F0 X + q h(xi) with the mean deformation gradient F0 = x G and the amplitudes q = x gamma of
/// the hourglass shapes h = (eta zeta, zeta xi, xi eta, xi eta zeta). The deformation gradient is assumed as F = F0
/// exp(H), to second order in H, with a symmetric strain H(xi) linear in F0^-1 q:
///
///   H = xi A_1 + eta A_2 + zeta A_3 + eta zeta B_1 + zeta xi B_2 + xi eta B_3.
///
/// A_k holds the strains in the plane of the two other edges that vary along xi_k: two normal strains and one torsion.
/// Normal to that plane the strain follows from plane stress, sigma n = 0: A_k n n = -nu/(1 - nu) tr(in-plane), without
/// shear. B_k is the strain along edge k with -nu times it in the transverse directions.
///
/// Consequences: bending has the stiffness E, in plates E/(1 - nu^2), and torsion mu. There is no parasitic shear. tr H
/// vanishes as nu goes to 1/2, and det F = det F0 exp(tr H), so there is no volumetric locking. Mean strains are exact,
/// so the patch test holds for any cell shape. At rest the stresses are those of Pian & Tong's hybrid element. Here
/// they are expressed as strains, independent of the law: any law, field or memory is integrated at points, without
/// condensation or iteration.
///
/// Source: Pian & Tong 1986, "Relations between incompatible displacement model and hybrid stress model"; Belytschko &
/// Bindeman 1993, "Assumed strain stabilization of the eight node hexahedral element" (ASQBI); Puso 2000.
struct AssumedStrainGeometry {
    /// Strains that vary along one edge: (E_ii, E_jj, 2 E_ij), covariant in the plane of the edges i and j, as
    /// symmetric tensors (xx, yy, zz, xy, yz, zx).
    struct Plane {
        Eigen::Matrix<double, 6, 3> in_plane;  // one tensor per measure [1/m2]
        Eigen::Vector3d trace;                 // traces of in_plane [1/m2]
        Eigen::Matrix<double, 6, 1> normal;    // n n' with unit normal n
    };

    Eigen::Matrix<double, 8, 3> gradient;              // G: cell average of the shape gradients [1/m]
    Eigen::Matrix<double, 8, 4> gamma;                 // h at the corners / 8, orthogonal to all linear fields
    Eigen::Matrix3d edges;                             // half edges at the cell centre as columns [m]
    std::array<Plane, 3> planes;                       // plane k spans the edges other than k
    std::array<Eigen::Matrix<double, 6, 1>, 3> along;  // t t' / |edge|^2 per edge [1/m2]
    std::array<double, 3> relaxed{0.0, 0.0, 0.0};      // per plane, see AssumedStrainPolicy
    double volume = 0.0;                               // [m3]
};

/// All hexahedra of a mesh in this formulation.
struct AssumedStrainBlock {
    static constexpr int nodes = 8;

    Eigen::MatrixXi cells;                        // 8 x m node numbers
    std::vector<AssumedStrainGeometry> geometry;  // per cell

    int cell_count() const { return static_cast<int>(cells.cols()); }
};

/// Share of the equibiaxial strain E_ii = E_jj of a plane that varies across the plane. Its stiffness E/(1 - nu)
/// exceeds the E/(1 + nu) of the other strains, and straight edges exaggerate it.
///
/// If the body ends within the reach of a cell, as in one or two layers, this strain carries the bending and is fully
/// counted. Between neighbours it vanishes under refinement; next to a clamp the strains rise from zero within less
/// than a cell. There the share s = relaxed sqrt((1 - nu)/(1 + nu)) is counted, so that with `relaxed` = 1 its
/// stiffness equals that of the other strains.
///
/// Measured on the soft beam under gravity (`myoloop bench locking`), error of the deflection at nu = 0.499 with 3 / 6
/// / 7 / 14 layers: fully counted everywhere -6.1 / -2.7 / -2.2 / -0.9 %; relaxed between neighbours -3.7 / -2.0 / -1.7
/// / -0.7 %; additionally a third of it at the clamp -1.5 / -0.8 / -0.7 / -0.4 %. A single layer is not affected.
struct AssumedStrainPolicy {
    double inner = 1.0;     // between neighbours
    double clamped = 0.35;  // next to a clamp

    /// Value for a cell; 0 means fully counted.
    double relaxed(CellSides sides) const {
        return sides == CellSides::free ? 0.0 : sides == CellSides::inner ? inner : clamped;
    }
};

/// Geometry of all hexahedra of a mesh.
/// @param surroundings  per cell; empty: all cells as if isolated
AssumedStrainBlock assumed_strain_block(const mesh::VolumeMesh& mesh, const CellSurroundings& surroundings,
                                        const AssumedStrainPolicy& policy = {});

/// Quadrature of the assumed-strain hexahedron: the centre and eight points near the corners, at xi = (+-1, +-1, +-1)
/// sqrt(3/5).
///
/// Along each edge these are the three Gauss points, exact to degree 5. A strain that varies linearly is integrated
/// exactly up to its fourth power, so that one layer bends correctly with laws of that order.
struct AssumedStrainRule {
    static constexpr int points = 9;
    static constexpr double middle_weight = 4.0 / 9.0, corner_weight = 5.0 / 72.0;  // relative to the volume
    static constexpr double corner = 0.774596669241483377;                          // sqrt(3/5)
    /// Scale of the strains B at the corner points. B varies with products of coordinates, whose mean square the rule
    /// gives as 1/5 instead of 1/9.
    static constexpr double bilinear_share = 0.745355992499929899;  // sqrt(5)/3
};

/// Reference coordinates of point q: 0 is the centre, the bits of q - 1 give the signs of corner q.
inline Eigen::Vector3d assumed_strain_point(int q) {
    if (q == 0) return Eigen::Vector3d::Zero();
    const int bits = q - 1;
    return AssumedStrainRule::corner *
           Eigen::Vector3d(bits & 1 ? 1.0 : -1.0, bits & 2 ? 1.0 : -1.0, bits & 4 ? 1.0 : -1.0);
}

}  // namespace myo::fem
