#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

#include "fem/cell_sides.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::fem {

/// A hexahedron whose strain varies within it as in a plate that bends, in three planes at once.
///
/// Positions are x(xi) = F0 X + q h(xi) with the mean deformation gradient F0 = x G and the amplitudes q = x gamma of
/// the shapes h = (eta zeta, zeta xi, xi eta, xi eta zeta). The deformation gradient within the cell is assumed as F =
/// F0 exp(H), to second order in H, where the symmetric strain H(xi) is linear in F0^-1 q:
///
///   H = xi A_1 + eta A_2 + zeta A_3 + eta zeta B_1 + zeta xi B_2 + xi eta B_3.
///
/// A_k holds the strains in the plane of the two other edges as they vary along xi_k (two normal ones, one of torsion).
/// Across that plane the cell thins as a plate does, so that sigma n = 0: A_k n n = -nu/(1 - nu) tr(in-plane), without
/// shear. B_k is the strain of edge k with -nu of it across. So bending answers with E, in plates with E/(1 - nu^2),
/// torsion with mu; there is no parasitic shear, and tr H, which det F = det F0 exp(tr H) turns into volume, vanishes
/// as nu goes to 1/2: neither kind of locking. Strains of the mean are exact: the patch test holds for any shape of
/// cell. These are the stresses of Pian & Tong's hybrid element, at rest; here they are strains, known before the law
/// is, so that any law, field or memory is integrated at points, and nothing is condensed or iterated.
///
/// Source: Pian & Tong 1986, "Relations between incompatible displacement model and hybrid stress model"; Belytschko &
/// Bindeman 1993, "Assumed strain stabilization of the eight node hexahedral element" (ASQBI); Puso 2000.
struct AssumedStrainGeometry {
    /// What varies along an edge: strains (E_ii, E_jj, 2 E_ij), covariant in the plane of the edges i and j, as a
    /// symmetric tensor (xx, yy, zz, xy, yz, zx).
    struct Plane {
        Eigen::Matrix<double, 6, 3> in_plane;  // [1/m2]
        Eigen::Vector3d trace;                 // of it [1/m2]
        Eigen::Matrix<double, 6, 1> normal;    // n n'
    };

    Eigen::Matrix<double, 8, 3> gradient;  // G: mean over the cell of the shape functions' gradients [1/m]
    Eigen::Matrix<double, 8, 4> gamma;     // the shapes h at the corners / 8, made orthogonal to every linear field
    Eigen::Matrix3d edges;                 // half edges of the cell's middle as columns [m]
    std::array<Plane, 3> planes;
    std::array<Eigen::Matrix<double, 6, 1>, 3> along;  // t t' / |edge|^2 of each edge [1/m2]
    std::array<double, 3> relaxed{0.0, 0.0, 0.0};      // of each plane: see AssumedStrainPolicy
    double volume = 0.0;                               // [m3]
};

/// All hexahedra of a mesh. cells: 8 x m node numbers.
struct AssumedStrainBlock {
    static constexpr int nodes = 8;

    Eigen::MatrixXi cells;
    std::vector<AssumedStrainGeometry> geometry;

    int cell_count() const { return static_cast<int>(cells.cols()); }
};

/// How much of the equibiaxial strain of a plane, E_ii = E_jj, varies across it: the one that costs most, E/(1 - nu)
/// for E/(1 + nu) of the others, and that straight edges exaggerate. Where a body ends within a cell's reach, as in one
/// or two layers, it is what bends the body, and all of it counts. Between neighbours it vanishes as cells become
/// small, and next to a clamp strains rise from zero within less than a cell: there the part s = relaxed sqrt((1 -
/// nu)/(1 + nu)) counts, so that with `relaxed` = 1 it costs as much as the others do.
///
/// Measured on the soft beam under gravity (`myoloop bench locking`), error of the deflection at nu = 0.499 with 3 / 6
/// / 7 / 14 layers: all of it everywhere -6.1 / -2.7 / -2.2 / -0.9 %; relaxed between neighbours -3.7 / -2.0 / -1.7 /
/// -0.7 %; and a third of that at the clamp -1.5 / -0.8 / -0.7 / -0.4 %. None of it concerns a single layer.
struct AssumedStrainPolicy {
    double inner = 1.0;
    double clamped = 0.35;

    /// 0: all of it counts.
    double relaxed(CellSides sides) const {
        return sides == CellSides::free ? 0.0 : sides == CellSides::inner ? inner : clamped;
    }
};

/// surroundings: empty for cells each by itself.
AssumedStrainBlock assumed_strain_block(const mesh::VolumeMesh& mesh, const CellSurroundings& surroundings,
                                        const AssumedStrainPolicy& policy = {});

/// Points at which a cell's law is evaluated: the middle and eight near the corners, at xi = (+-1, +-1, +-1) sqrt(3/5).
/// Along every edge they are Gauss' three points, exact to degree 5: a strain that varies linearly is integrated
/// exactly to its fourth power, so that one layer bends right with laws whose energy goes with it.
namespace assumed_strain_rule {
inline constexpr int points = 9;
inline constexpr double middle_weight = 4.0 / 9.0, corner_weight = 5.0 / 72.0;  // of the volume
inline constexpr double corner = 0.774596669241483377;                          // sqrt(3/5)
/// The strains B vary with products, whose mean square the rule makes 1/5 instead of 1/9: so much of them stands at the
/// points.
inline constexpr double bilinear_share = 0.745355992499929899;  // sqrt(5)/3
}  // namespace assumed_strain_rule

/// Reference coordinates of the point.
inline Eigen::Vector3d assumed_strain_point(int q) {
    if (q == 0) return Eigen::Vector3d::Zero();
    const int bits = q - 1;
    return assumed_strain_rule::corner *
           Eigen::Vector3d(bits & 1 ? 1.0 : -1.0, bits & 2 ? 1.0 : -1.0, bits & 4 ? 1.0 : -1.0);
}

}  // namespace myo::fem
