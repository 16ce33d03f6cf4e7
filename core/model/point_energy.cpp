#include "model/point_energy.hpp"

#include <cassert>

#include "base/parallel.hpp"
#include "model/cell_kernel.hpp"
#include "model/pack_model.hpp"

namespace myo::model {
namespace {

template <class Geometry>
Eigen::VectorXd densities_of(const PackedCells<Geometry>& cells, const Model& model, const Eigen::Matrix3Xd& x) {
    constexpr int Q = Geometry::points;
    Eigen::VectorXd result(cells.pack_count() * Q * pack_width);
    parallel_ranges(cells.pack_count(), 24, [&](int first, int end) {
        for (int pack = first; pack < end; ++pack) {
            const auto xe = nodes_of_pack(cells, pack, x);
            const PointKinematics<Geometry> points = points_of(cells, pack, model, xe);
            PackElasticity elasticity = elasticity_of(cells, pack, model);
            elasticity.kappa = 0.0;
            ElasticPoints<Geometry>(cells, pack, elasticity).visit(points, [&](const PointState& point) {
                point.law.distortion.value.copy_to(result.data() + (pack * Q + point.q) * pack_width,
                                                   std::experimental::element_aligned);
            });
        }
    });
    return result;
}

}  // namespace

Eigen::VectorXd isochoric_energy_densities(const Model& model, const Eigen::Matrix3Xd& x) {
    assert(x.cols() == model.body->node_count());
    return std::visit([&](const auto& cells) { return densities_of(cells, model, x); }, model.body->cells);
}

}  // namespace myo::model
