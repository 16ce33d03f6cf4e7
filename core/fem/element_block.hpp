#pragma once

#include <Eigen/Core>

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "mesh/volume_mesh.hpp"

namespace myo {

/// Element formulations. The first of each cell type is the default.
enum class ElementKind {
    hex8,                   // one point, physically stabilised: no volumetric and no shear locking
    hex8_mean_dilatation,   // eight points, one volume per cell: no volumetric locking
    hex8_full,              // eight points: locks; as published, for comparison
    tet10,                  // four points, one volume per cell: no locking
    tet10_full,             // four points
    tet4,                   // one point: locks
};

std::string to_string(ElementKind kind);
std::vector<std::string> element_ids();
/// False when there is no element of this name.
bool parse_element(const std::string& id, ElementKind& kind);
CellType cell_type(ElementKind kind);
ElementKind default_element(CellType type);

/// Gradients of the shape functions with respect to rest coordinates at each quadrature point, [1/m], and volumes [m3].
template <int N, int Q>
struct CellGeometry {
    std::array<Eigen::Matrix<double, N, 3>, Q> gradient;
    std::array<double, Q> weight;
    double volume = 0.0;
};

/// What the one-point hexahedron needs to resist its hourglass motions x_i = q_i h_a.
///
/// gamma: 8 x 4, the hourglass shapes made orthogonal to every linear field (Flanagan & Belytschko 1981).
/// frame: columns are the cell's axes; half_length: half its edges along them [m].
struct HourglassGeometry {
    Eigen::Matrix<double, 8, 4> gamma;
    Eigen::Matrix3d frame;
    Eigen::Vector3d half_length;
};

/// All cells of one formulation. cells: N x m node numbers.
template <int N, int Q>
struct ElementBlock {
    static constexpr int nodes = N;
    static constexpr int points = Q;

    bool mean_volume = false;
    /// Of the bulk modulus, so many times mu at most stay at the points; the rest acts on the cell's mean volume. What varies within a cell
    /// answers as if Poisson's ratio were that of the part at the points: with 0 (2/3 of mu) one layer of quadratic cells bends 10 to 15 %
    /// too easily, with 1/2 it locks. 1.5 (nu 0.23) bends one layer 1 to 7 % off and two within 1 % (test SmallLoad.LayersOfQuadraticCells).
    double most_point_bulk_over_mu = 0.0;
    Eigen::MatrixXi cells;
    std::vector<CellGeometry<N, Q>> geometry;
    std::vector<HourglassGeometry> hourglass;   // empty, or one per cell

    int cell_count() const { return static_cast<int>(cells.cols()); }
    /// Strain measures per cell: six Green strains per point, then twelve hourglass strains.
    int strains_per_cell() const { return 6 * Q + (hourglass.empty() ? 0 : 12); }
};

using Elements = std::variant<ElementBlock<8, 1>, ElementBlock<8, 8>, ElementBlock<4, 1>, ElementBlock<10, 4>>;

/// Asserts that the mesh has the kind's cell type.
Elements make_elements(const VolumeMesh& mesh, ElementKind kind);

/// Consistent mass per unit density [m3] as triplets (node, node, value) of the scalar n x n matrix, both triangles.
struct MassEntry {
    int row = 0;
    int column = 0;
    double value = 0.0;
};
std::vector<MassEntry> consistent_mass(const VolumeMesh& mesh);

}  // namespace myo
