#pragma once

#include "material/moduli.hpp"
#include "model/elastic_points.hpp"
#include "model/model.hpp"
#include "model/packed_cells.hpp"
#include "model/point_kinematics.hpp"

namespace myo::model {

/// Poisson's ratio of the cells of a pack for bending; see Model::poissons_ratio.
template <class Geometry>
Pack poissons_ratio_of(const PackedCells<Geometry>& cells, int pack, const Model& model) {
    if (!model.poissons_ratio.empty())
        return pack_of(cells, pack, [&](std::size_t c) { return model.poissons_ratio[c]; });
    const Pack mu = pack_of(cells, pack, [&](std::size_t c) { return model.moduli[c].mu; });
    const Pack kappa = pack_of(cells, pack, [&](std::size_t c) { return model.moduli[c].kappa; });
    return (3.0 * kappa - 2.0 * mu) / (2.0 * (3.0 * kappa + mu));  // as young_from_moduli()
}

/// Data of a pack in a field over the body's points; null for an empty field.
template <class Geometry>
const double* factors_of(const PackedCells<Geometry>&, int pack, const Eigen::VectorXd& factors) {
    return factors.size() > 0 ? factors.data() + pack * Geometry::points * pack_width : nullptr;
}

/// Law, moduli and factors of the model itself for the cells of a pack; refers to the model.
template <class Geometry>
PackElasticity elasticity_of(const PackedCells<Geometry>& cells, int pack, const Model& model) {
    return {model.material.get(), pack_of(cells, pack, [&](std::size_t c) { return model.moduli[c].mu; }),
            pack_of(cells, pack, [&](std::size_t c) { return model.moduli[c].kappa; }),
            point_bulk(cells, pack, model.moduli), factors_of(cells, pack, model.point_factors)};
}

/// Kinematics of the points of a pack at nodal positions x [m].
template <class Geometry>
PointKinematics<Geometry> points_of(const PackedCells<Geometry>& cells, int pack, const Model& model,
                                    const PackNodes<Geometry::nodes>& x) {
    return {cells.geometry(pack), cells.surroundings_of(pack), x, poissons_ratio_of(cells, pack, model)};
}

}  // namespace myo::model
