#include "model/point_energy.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

#include "base/parallel.hpp"
#include "model/cell_kernel.hpp"
#include "model/node_sums.hpp"
#include "model/pack_model.hpp"

namespace myo::model {
namespace {

struct PointEnergyPolicy {
    int packs_per_thread = 24;
};
constexpr PointEnergyPolicy point_energy_policy;

/// See isochoric_energy_densities(). Without bulk modulus a law has its isochoric energy alone.
template <class Geometry>
Eigen::VectorXd densities_of(const PackedCells<Geometry>& cells, const Model& model, const Eigen::Matrix3Xd& x) {
    constexpr int Q = Geometry::points;
    Eigen::VectorXd result(cells.pack_count() * Q * pack_width);
    parallel_ranges(cells.pack_count(), point_energy_policy.packs_per_thread, [&](int first, int end) {
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

/// See isochoric_energy_gradient().
template <class Geometry>
Eigen::Matrix3Xd density_gradient_of(const PackedCells<Geometry>& cells, const Model& model, const Eigen::Matrix3Xd& x,
                                     const Eigen::VectorXd& weights) {
    constexpr int N = Geometry::nodes, Q = Geometry::points;
    std::vector<Pack> nodal(static_cast<std::size_t>(cells.pack_count()) * 3 * N);
    parallel_ranges(cells.pack_count(), point_energy_policy.packs_per_thread, [&](int first, int end) {
        for (int pack = first; pack < end; ++pack) {
            const auto xe = nodes_of_pack(cells, pack, x);
            const PointKinematics<Geometry> points = points_of(cells, pack, model, xe);
            PackElasticity elasticity = elasticity_of(cells, pack, model);
            elasticity.kappa = 0.0;
            StressSum<Geometry> stress(points);
            ElasticPoints<Geometry>(cells, pack, elasticity).visit(points, [&](const PointState& point) {
                stress.add(point.q,
                           point.law.distortion.gradient * entry(weights.data() + pack * Q * pack_width, point.q));
            });
            PackNodes<N> gradient = PackNodes<N>::Constant(Pack(0.0));
            stress.add_to(gradient);
            std::copy(gradient.data(), gradient.data() + 3 * N, nodal.begin() + pack * 3 * N);
        }
    });
    Eigen::Matrix3Xd result = Eigen::Matrix3Xd::Zero(3, x.cols());
    add_at_nodes(model.body->incidence, reinterpret_cast<const double*>(nodal.data()), result);
    return result;
}

/// Work of one pack per unit of the factor at each point.
template <class Geometry>
void factor_work_of(const PackedCells<Geometry>& cells, int pack, const Model& model, const Eigen::Matrix3Xd& x,
                    const Eigen::Matrix3Xd& p, double* result) {
    constexpr int Q = Geometry::points;
    const auto xe = nodes_of_pack(cells, pack, x), pe = nodes_of_pack(cells, pack, p);
    const PointKinematics<Geometry> points = points_of(cells, pack, model, xe);
    const auto motion = points.along(pe);
    const PackElasticity elasticity = elasticity_of(cells, pack, model);
    ElasticPoints<Geometry> elastic(cells, pack, elasticity);
    std::array<Pack, Q> work, mean_factors;
    Pack mean_change = 0.0;  // of the mean volume measure, times the volume
    elastic.visit(points, [&](const PointState& point) {
        const auto q = static_cast<std::size_t>(point.q);
        const material::Matrix3<Pack> dF = points.tangent(point.q, motion);
        work[q] = point.weight * material::double_dot(elastic.stress_at(point), dF);
        if (!elastic.mean()) return;
        mean_factors[q] = point.factor * point.share;
        mean_change += point.weight * material::double_dot(point.law.volume.gradient, dF);
    });
    for (std::size_t q = 0; q < Q; ++q) {
        // The bulk modulus of the mean volume has the mean of the factors.
        if (elastic.mean()) work[q] += mean_change * elastic.bulk_of_mean(mean_factors[q]).first;
        work[q].copy_to(result + q * pack_width, std::experimental::element_aligned);
    }
}

}  // namespace

Eigen::VectorXd isochoric_energy_densities(const Model& model, const Eigen::Matrix3Xd& x) {
    assert(x.cols() == model.body->node_count());
    return std::visit([&](const auto& cells) { return densities_of(cells, model, x); }, model.body->cells);
}

Eigen::Matrix3Xd isochoric_energy_gradient(const Model& model, const Eigen::Matrix3Xd& x,
                                           const Eigen::VectorXd& weights) {
    assert(x.cols() == model.body->node_count() && weights.size() == model.body->point_count());
    return std::visit([&](const auto& cells) { return density_gradient_of(cells, model, x, weights); },
                      model.body->cells);
}

Eigen::VectorXd point_factor_work(const Model& model, const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& p) {
    assert(x.cols() == model.body->node_count() && p.cols() == x.cols());
    Eigen::VectorXd result(model.body->point_count());
    std::visit(
        [&](const auto& cells) {
            const int per_pack = static_cast<int>(result.size()) / cells.pack_count();
            parallel_ranges(cells.pack_count(), point_energy_policy.packs_per_thread, [&](int first, int end) {
                for (int pack = first; pack < end; ++pack)
                    factor_work_of(cells, pack, model, x, p, result.data() + pack * per_pack);
            });
        },
        model.body->cells);
    return result;
}

}  // namespace myo::model
