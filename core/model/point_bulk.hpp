#pragma once

#include <algorithm>
#include <vector>

#include "material/moduli.hpp"
#include "model/packed_cells.hpp"

namespace myo {

/// The bulk modulus that acts at the points of cells with a mean volume: of_mu mu + of_kappa kappa, see ElementBlock. Linear in the moduli
/// while their ratio stays on one side of the element's bound.
struct PointBulk {
    Pack of_mu = 0.0, of_kappa = 0.0;

    Pack of(const Pack& mu, const Pack& kappa) const { return of_mu * mu + of_kappa * kappa; }
};

/// That of a pack's cells, whose moduli in Pa are given per cell.
template <int N, int Q>
PointBulk point_bulk(const PackedCells<N, Q>& cells, int pack, const std::vector<Moduli>& moduli) {
    PointBulk result;
    for (int lane = 0; lane < pack_width; ++lane) {
        const auto l = static_cast<std::size_t>(lane);
        const Moduli& m = moduli[static_cast<std::size_t>(std::min(pack * pack_width + lane, cells.cell_count - 1))];
        if (m.kappa < cells.most_point_bulk_over_mu * m.mu) result.of_kappa[l] = 1.0;
        else result.of_mu[l] = cells.most_point_bulk_over_mu;
    }
    return result;
}

}  // namespace myo
