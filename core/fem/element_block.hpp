#pragma once

#include <Eigen/Core>

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "fem/assumed_strain.hpp"
#include "mesh/volume_mesh.hpp"

namespace myo::fem {

/// Element formulations. The first of each cell type is the default.
enum class ElementKind {
    hex8,                  // assumed strains, nine points: no volumetric and no shear locking
    hex8_mean_dilatation,  // eight points, one volume per cell: no volumetric locking
    hex8_full,             // eight points: locks; as published, for comparison
    tet10,                 // four points, one volume per cell: no locking
    tet10_fine,            // the same at ten points: for what varies within cells, see fine_element()
    tet10_full,            // four points
    tet4,                  // one point: locks
};

std::string to_string(ElementKind kind);
std::vector<std::string> element_ids();
/// False when there is no element of this name.
bool parse_element(const std::string& id, ElementKind& kind);
mesh::CellType cell_type(ElementKind kind);
ElementKind default_element(mesh::CellType type);

/// The element with the same nodes for what varies within its cells: fields of moduli, stiffening, softening. The
/// kind itself unless it is tet10.
///
/// With uniform moduli and an energy quadratic in the strain, the four points of tet10 are exact in straight-sided
/// cells and more of them change nothing. Stiffening and softening need the fourth power of the strain: one layer in
/// bending at nu 0 (no influence of the clamp) shows 26 % too little of the stiffening with four points, 1.6 % with
/// ten and 1.9 % with fourteen (test OneLayer). Ten take 1.3 times the time of four in a step of `myoloop bench
/// elements`.
ElementKind fine_element(ElementKind kind);

/// Gradients of the shape functions with respect to rest coordinates at each quadrature point, [1/m], and volumes [m3].
template <int N, int Q>
struct CellGeometry {
    std::array<Eigen::Matrix<double, N, 3>, Q> gradient;
    std::array<double, Q> weight;
    double volume = 0.0;
};

/// Bound of the bulk modulus at the points of cells with a mean volume, in units of mu; the rest acts on the mean
/// volume. What varies within a cell answers as if Poisson's ratio were that of the part at the points.
///
/// The mean alone is stable (quadratic displacements with one pressure per cell fulfil the inf-sup condition: test
/// InfSup), what stays at the points is bounded as nu goes to 1/2, so that nothing locks, and no pressure is an
/// unknown. How much is best depends on how free the nodes are. Measured with 1.5 / 3 / 5 / 8 everywhere at nu 0.49:
/// one layer of a plate bends +10 / +5 / +1 / -1.6 % off; the thick beam of `myoloop bench locking` in three layers
/// -0.9 / -1.8 / -2.4 / -2.9 %, and -0.2 % with 1.5 but for 2/3 next to the clamp.
struct PointBulkPolicy {
    double free = 4.0;           // nu 0.38
    double inner = 1.5;          // nu 0.23
    double clamped = 2.0 / 3.0;  // nu 0

    double over_mu(CellSides sides) const {
        return sides == CellSides::free ? free : sides == CellSides::inner ? inner : clamped;
    }
};

/// All cells of one formulation. cells: N x m node numbers.
template <int N, int Q>
struct ElementBlock {
    static constexpr int nodes = N;
    static constexpr int points = Q;

    bool mean_volume = false;
    std::vector<double> point_bulk_over_mu;  // per cell, see PointBulkPolicy; empty: 0
    Eigen::MatrixXi cells;
    std::vector<CellGeometry<N, Q>> geometry;

    int cell_count() const { return static_cast<int>(cells.cols()); }
};

using Elements = std::variant<AssumedStrainBlock, ElementBlock<8, 8>, ElementBlock<4, 1>, ElementBlock<10, 4>,
                              ElementBlock<10, 10>>;

/// Asserts that the mesh has the kind's cell type. surroundings: empty for cells each by itself.
Elements make_elements(const mesh::VolumeMesh& mesh, ElementKind kind, const CellSurroundings& surroundings = {});

/// Consistent mass per unit density [m3] as triplets (node, node, value) of the scalar n x n matrix, both triangles.
struct MassEntry {
    int row = 0;
    int column = 0;
    double value = 0.0;
};
std::vector<MassEntry> consistent_mass(const mesh::VolumeMesh& mesh);

}  // namespace myo::fem
