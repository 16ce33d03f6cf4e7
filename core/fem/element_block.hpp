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
    hex8_full,             // eight points: locks; published formulation, for comparison
    tet10,                 // four points, one volume per cell: no locking
    tet10_fine,            // as tet10 with ten points: for fields that vary inside cells, see fine_element()
    tet10_full,            // four points, full integration of the volume
    tet4,                  // one point: locks
};

/// Name in project files.
std::string to_string(ElementKind kind);
/// All names.
std::vector<std::string> element_ids();
/// Looks up an element by name. Returns false if unknown; `kind` is then unchanged.
bool parse_element(const std::string& id, ElementKind& kind);
/// Cell type of the mesh that an element needs.
mesh::CellType cell_type(ElementKind kind);
/// Default element of a cell type.
ElementKind default_element(mesh::CellType type);

/// Element with the same nodes and enough points for fields that vary inside cells: moduli, stiffening, softening.
/// Returns `kind` itself unless it is tet10.
///
/// For uniform moduli and an energy quadratic in the strain, four points integrate straight-sided tet10 exactly.
/// Stiffening and softening involve the fourth power of the strain: for one layer in bending at nu 0 (no influence of
/// the clamp) the stiffening is underestimated by 26 % with four points, 1.6 % with ten and 1.9 % with fourteen (test
/// OneLayer). Ten points take 1.3 times the time of four in a step of `myoloop bench elements`.
ElementKind fine_element(ElementKind kind);

/// Precomputed geometry of one cell with N nodes and Q quadrature points.
template <int N, int Q>
struct CellGeometry {
    std::array<Eigen::Matrix<double, N, 3>, Q> gradient;  // shape gradients in rest coordinates [1/m]
    std::array<double, Q> weight;                         // quadrature weight times Jacobian [m3]
    double volume = 0.0;                                  // sum of the weights [m3]
};

/// Bulk modulus at the points of cells with a mean volume, relative to mu; the remainder acts on the mean volume.
/// Variations inside a cell see the Poisson's ratio of the part at the points.
///
/// The mean alone is stable: quadratic displacements with one pressure per cell satisfy the inf-sup condition (test
/// InfSup). The part at the points is bounded as nu goes to 1/2, so there is no locking and pressures are not unknowns.
/// The best value depends on the freedom of the nodes. Measured with 1.5 / 3 / 5 / 8 everywhere at nu 0.49: bending
/// error of a plate of one layer +10 / +5 / +1 / -1.6 %; the thick beam of `myoloop bench locking` in three layers -0.9
/// / -1.8 / -2.4 / -2.9 %, and -0.2 % with 1.5 and 2/3 next to the clamp.
struct PointBulkPolicy {
    double free = 4.0;           // corresponds to nu 0.38
    double inner = 1.5;          // nu 0.23
    double clamped = 2.0 / 3.0;  // nu 0

    /// Bound for a cell, kappa at the points over mu.
    double over_mu(CellSides sides) const {
        return sides == CellSides::free ? free : sides == CellSides::inner ? inner : clamped;
    }
};

/// All cells of one formulation with N nodes and Q points.
template <int N, int Q>
struct ElementBlock {
    static constexpr int nodes = N;
    static constexpr int points = Q;

    bool mean_volume = false;                  // the volume measure is averaged over the cell
    std::vector<double> point_bulk_over_mu;    // per cell, see PointBulkPolicy; empty: 0
    Eigen::MatrixXi cells;                     // N x m node numbers
    std::vector<CellGeometry<N, Q>> geometry;  // per cell

    int cell_count() const { return static_cast<int>(cells.cols()); }
};

/// All supported formulations. The variant is visited once per block of cells, not per cell.
using Elements = std::variant<AssumedStrainBlock, ElementBlock<8, 8>, ElementBlock<4, 1>, ElementBlock<10, 4>,
                              ElementBlock<10, 10>>;

/// Elements of a mesh. Asserts that the mesh has the kind's cell type.
/// @param surroundings  per cell; empty: all cells as if isolated
Elements make_elements(const mesh::VolumeMesh& mesh, ElementKind kind, const CellSurroundings& surroundings = {});

/// Entry of the scalar n x n mass matrix for unit density.
struct MassEntry {
    int row = 0;
    int column = 0;
    double value = 0.0;  // [m3]
    int cell = 0;
};
/// Consistent mass for unit density as triplets, both triangles; entries of shared nodes occur several times and add
/// up. Integrated exactly for straight-sided cells.
std::vector<MassEntry> consistent_mass(const mesh::VolumeMesh& mesh);

}  // namespace myo::fem
