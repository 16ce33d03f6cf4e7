#pragma once

#include <vector>

#include "material/moduli.hpp"
#include "model/packed_cells.hpp"

namespace myo::model {

/// Bulk modulus at the points of cells with a mean volume, of_mu mu + of_kappa kappa; see PointBulkPolicy. Linear in
/// the moduli as long as kappa / mu stays on one side of the element's bound.
struct PointBulk {
    Pack of_mu = 0.0, of_kappa = 0.0;  // dimensionless coefficients

    Pack of(const Pack& mu, const Pack& kappa) const { return of_mu * mu + of_kappa * kappa; }
};

/// Coefficients for the cells of a pack.
/// @param moduli  [Pa] per cell
template <class Geometry>
PointBulk point_bulk(const PackedCells<Geometry>& cells, int pack, const std::vector<material::Moduli>& moduli) {
    PointBulk result;
    if (cells.point_bulk_over_mu.empty()) return result;
    const Pack bound = cells.point_bulk_over_mu[static_cast<std::size_t>(pack)];
    const Pack mu = pack_of(cells, pack, [&](std::size_t c) { return moduli[c].mu; }),
               kappa = pack_of(cells, pack, [&](std::size_t c) { return moduli[c].kappa; });
    // Below the bound the complete bulk modulus acts at the points, above it the bound itself.
    const auto below = kappa < bound * mu;
    result.of_mu = bound;
    set_where(below, result.of_mu, 0.0);
    set_where(below, result.of_kappa, 1.0);
    return result;
}

}  // namespace myo::model
