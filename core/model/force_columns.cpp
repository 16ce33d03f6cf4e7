#include "model/force_columns.hpp"

#include <algorithm>
#include <cassert>
#include <optional>

#include "base/parallel.hpp"
#include "model/cell_kernel.hpp"
#include "model/node_sums.hpp"
#include "model/pack_model.hpp"

namespace myo::model {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

struct ForceColumnsPolicy {
    int packs_per_thread = 16;
    Index at_once = 8;  // columns per sweep; more would evict the forces from the cache
};
constexpr ForceColumnsPolicy force_columns_policy;

/// Lanes value(cell) of a pack; 0 for lanes past the last cell.
template <class Cells, class Value>
Pack lanes_of(const Cells& cells, int pack, const Value& value) {
    return Pack([&](auto lane) {
        const int cell = pack * pack_width + static_cast<int>(lane);
        return cell < cells.cell_count ? value(static_cast<std::size_t>(cell)) : 0.0;
    });
}

/// Viscous forces of given strain rates.
/// @param rates  [1/s] strain_count entries
template <class Geometry>
PackInput viscous_input(const PackedCells<Geometry>& cells, int pack, const Model& model, const Pack& viscous_mu,
                        const double* rates) {
    PackInput in;
    in.viscous = true;
    in.viscous_mu = viscous_mu;
    in.viscous_factors = factors_of(cells, pack, model.point_factors);
    in.rate_history = rates + pack * cells.strains_per_cell() * pack_width;
    return in;
}

/// Forces for unit mu, unit kappa and unit viscous modulus, at the nodes of each pack.
template <class Geometry>
UnitForces unit_forces_of(const PackedCells<Geometry>& cells, const Model& model, const Matrix3Xd& x,
                          const VectorXd& softening, const VectorXd& rate) {
    constexpr int N = Geometry::nodes;
    const auto size = static_cast<std::size_t>(cells.pack_count()) * 3 * N;
    UnitForces forces{std::vector<Pack>(size), std::vector<Pack>(size), std::vector<Pack>(rate.size() > 0 ? size : 0)};
    // Softening multiplies the elastic moduli only; viscous moduli keep the model's factors.
    const VectorXd elastic_factors = times_factors(model.point_factors, softening);
    parallel_ranges(cells.pack_count(), force_columns_policy.packs_per_thread, [&](int first, int end) {
        PackOutput<N> out;
        for (int pack = first; pack < end; ++pack) {
            const auto xe = nodes_of_pack(cells, pack, x);
            const PointKinematics<Geometry> points = points_of(cells, pack, model, xe);
            const auto keep = [&](std::vector<Pack>& field, const PackInput& in) {
                out.gradient.setConstant(Pack(0.0));
                add_response<false>(cells, pack, points, in, out);
                std::copy(out.gradient.data(), out.gradient.data() + 3 * N, field.begin() + pack * 3 * N);
            };
            PackInput elastic;
            elastic.elastic = true;
            // Unit shear modulus with zero bulk modulus; at the points of a mean volume the bulk modulus follows mu,
            // see PointBulk.
            elastic.elasticity = {model.material.get(), 1.0, 0.0, point_bulk(cells, pack, model.moduli),
                                  factors_of(cells, pack, elastic_factors)};
            keep(forces.mu, elastic);
            // Unit bulk modulus with zero shear modulus.
            std::swap(elastic.elasticity.mu, elastic.elasticity.kappa);
            keep(forces.kappa, elastic);
            if (rate.size() == 0) continue;
            keep(forces.viscous, viscous_input(cells, pack, model, 1.0, rate.data()));
        }
    });
    return forces;
}

/// Elastic forces of each point of a pack, for the moduli of the model. A change of the factor at a point multiplies
/// its forces.
template <class Geometry>
std::array<PackNodes<Geometry::nodes>, Geometry::points> point_forces_of(const PackedCells<Geometry>& cells, int pack,
                                                                         const Model& model, const Matrix3Xd& x) {
    constexpr int N = Geometry::nodes, Q = Geometry::points;
    const auto xe = nodes_of_pack(cells, pack, x);
    const PointKinematics<Geometry> points = points_of(cells, pack, model, xe);
    const PackElasticity elasticity = elasticity_of(cells, pack, model);
    ElasticPoints<Geometry> elastic(cells, pack, elasticity);
    std::array<PackNodes<N>, Q> forces;
    std::array<Pack, Q> mean_factors;  // shares of the points in the bulk modulus of the mean volume
    PackNodes<N> mean_gradient = PackNodes<N>::Constant(Pack(0.0));
    elastic.visit(points, [&](const PointState& point) {
        const auto q = static_cast<std::size_t>(point.q);
        StressSum<Geometry> stress(points);
        stress.add(point.q, elastic.stress_at(point) * point.weight);
        forces[q].setConstant(Pack(0.0));
        stress.add_to(forces[q]);
        if (!elastic.mean()) return;
        mean_factors[q] = point.factor * point.share;
        // Gradient of the mean volume, needed for the part of the pressure that acts on all points.
        StressSum<Geometry> of_theta(points);
        of_theta.add(point.q, point.law.volume.gradient * point.weight);
        of_theta.add_to(mean_gradient);
    });
    if (elastic.mean())
        for (std::size_t q = 0; q < Q; ++q) forces[q] += mean_gradient * elastic.bulk_of_mean(mean_factors[q]).first;
    return forces;
}

/// out.gradient += weight * unit for one pack; skipped if the weight is zero in all lanes.
template <int N>
void add_weighted(const std::vector<Pack>& unit, int pack, const Pack& weight, PackOutput<N>& out) {
    if (unit.empty() || all_of(weight == 0.0)) return;
    for (int k = 0; k < 3 * N; ++k)
        out.gradient(k % 3, k / 3) += weight * unit[static_cast<std::size_t>(pack * 3 * N + k)];
}

/// What the columns of a pack share.
template <class Geometry>
struct PackColumns {
    Pack viscous_mu = 0.0;                            // [Pa s]
    std::optional<PointKinematics<Geometry>> points;  // for changes of the strain rates
    std::optional<std::array<PackNodes<Geometry::nodes>, Geometry::points>> of_points;  // for changes of the softening
};

/// Gradient of one column at the nodes of a pack, in out.gradient.
template <class Geometry>
void column_gradient(const PackedCells<Geometry>& cells, int pack, const Model& model, const UnitForces& forces,
                     const GradientChanges& changes, Index column, const PackColumns<Geometry>& shared,
                     PackOutput<Geometry::nodes>& out) {
    const auto add = [&](const std::vector<Pack>& unit, const auto& modulus) {
        add_weighted<Geometry::nodes>(unit, pack, lanes_of(cells, pack, modulus), out);
    };
    const Stiffness& own = changes.stiffness[static_cast<std::size_t>(column)];
    out.gradient.setConstant(Pack(0.0));
    if (!own.elastic.empty()) {
        add(forces.mu, [&](std::size_t c) { return own.elastic[c].mu; });
        add(forces.kappa, [&](std::size_t c) { return own.elastic[c].kappa; });
    }
    if (!own.viscous.empty()) add(forces.viscous, [&](std::size_t c) { return own.viscous[c].mu; });
    if (shared.points)
        add_response<false>(cells, pack, *shared.points,
                            viscous_input(cells, pack, model, shared.viscous_mu, changes.rates.col(column).data()),
                            out);
    if (!shared.of_points) return;
    // The elastic forces of a point are proportional to its factor.
    const double* const d = changes.softening.col(column).data() + pack * Geometry::points * pack_width;
    for (std::size_t q = 0; q < Geometry::points; ++q)
        out.gradient += (*shared.of_points)[q] * entry(d, static_cast<int>(q));
}

/// See gradient_columns().
template <class Geometry>
NodalColumns gradients_of(const PackedCells<Geometry>& cells, const Model& model, const Matrix3Xd& x,
                          const UnitForces& forces, const GradientChanges& changes) {
    constexpr int N = Geometry::nodes;
    const auto columns = static_cast<Index>(changes.stiffness.size());
    const auto field = static_cast<std::size_t>(cells.pack_count()) * 3 * N;
    // Forces at the nodes of the cells, for one group of columns.
    std::vector<Pack> nodal(field * static_cast<std::size_t>(std::min(force_columns_policy.at_once, columns)));
    NodalColumns result = NodalColumns::Zero(3 * columns, x.cols());
    // Groups of columns: each pack's kinematics serve all columns of a group.
    for (Index start = 0; start < columns; start += force_columns_policy.at_once) {
        const Index count = std::min(force_columns_policy.at_once, columns - start);
        parallel_ranges(cells.pack_count(), force_columns_policy.packs_per_thread, [&](int first, int end) {
            PackOutput<N> out;
            for (int pack = first; pack < end; ++pack) {
                const auto xe = nodes_of_pack(cells, pack, x);
                PackColumns<Geometry> shared;
                if (changes.rates.size() > 0) {
                    shared.points.emplace(points_of(cells, pack, model, xe));
                    shared.viscous_mu = lanes_of(
                        cells, pack, [&](std::size_t c) { return viscous_scale(model, c) * model.moduli[c].mu; });
                }
                if (changes.softening.size() > 0) shared.of_points.emplace(point_forces_of(cells, pack, model, x));
                for (Index k = 0; k < count; ++k) {
                    column_gradient(cells, pack, model, forces, changes, start + k, shared, out);
                    std::copy(out.gradient.data(), out.gradient.data() + 3 * N,
                              nodal.begin() + static_cast<std::ptrdiff_t>(field) * k + pack * 3 * N);
                }
            }
        });
        // Fixed order of summation at the nodes: independent of threads.
        for (Index k = 0; k < count; ++k)
            add_at_nodes(model.body->incidence,
                         reinterpret_cast<const double*>(nodal.data() + static_cast<std::ptrdiff_t>(field) * k),
                         nodal_column(result, start + k));
    }
    return result;
}

/// See strain_tangents().
template <class Geometry>
MatrixXd strain_tangents_of(const PackedCells<Geometry>& cells, const Model& model, const Matrix3Xd& x,
                            const NodalColumns& dx) {
    constexpr int N = Geometry::nodes;
    const int per_cell = cells.strains_per_cell();
    MatrixXd result(cells.pack_count() * per_cell * pack_width, dx.rows() / 3);
    parallel_ranges(cells.pack_count(), force_columns_policy.packs_per_thread, [&](int first, int end) {
        std::array<material::Matrix3<Pack>, Geometry::points> F;
        for (int pack = first; pack < end; ++pack) {
            const auto xe = nodes_of_pack(cells, pack, x);
            const PointKinematics<Geometry> points = points_of(cells, pack, model, xe);
            // F does not depend on the motion: computed once for all columns.
            for (int q = 0; q < Geometry::points; ++q) F[static_cast<std::size_t>(q)] = points.gradient(q);
            const auto& nodes = cells.lane_nodes[static_cast<std::size_t>(pack)];
            for (Index p = 0; p < result.cols(); ++p) {
                PackNodes<N> de;
                for (int a = 0; a < N; ++a)
                    for (int r = 0; r < 3; ++r)
                        de(r, a) = Pack(
                            [&](auto lane) { return dx(3 * p + r, nodes[static_cast<std::size_t>(a)][lane]); });
                const auto motion = points.along(de);
                double* to = result.col(p).data() + pack * per_cell * pack_width;
                for (int q = 0; q < Geometry::points; ++q) {
                    const PackSymmetric e = green_strain_tangent(F[static_cast<std::size_t>(q)],
                                                                 points.tangent(q, motion));
                    for (int i = 0; i < 6; ++i)
                        e[static_cast<std::size_t>(i)].copy_to(to + (6 * q + i) * pack_width,
                                                               std::experimental::element_aligned);
                }
            }
        }
    });
    return result;
}

}  // namespace

UnitForces unit_forces(const Model& model, const Matrix3Xd& x, const VectorXd& softening, const VectorXd& rate) {
    assert(x.cols() == model.body->node_count());
    return std::visit([&](const auto& cells) { return unit_forces_of(cells, model, x, softening, rate); },
                      model.body->cells);
}

NodalColumns gradient_columns(const Model& model, const Matrix3Xd& x, const UnitForces& forces,
                              const GradientChanges& changes) {
    assert(x.cols() == model.body->node_count() &&
           (changes.rates.size() == 0 || changes.rates.cols() == static_cast<Index>(changes.stiffness.size())));
    assert(changes.softening.size() == 0 || changes.softening.rows() == model.body->point_count());
    return std::visit([&](const auto& cells) { return gradients_of(cells, model, x, forces, changes); },
                      model.body->cells);
}

MatrixXd strain_tangents(const Model& model, const Matrix3Xd& x, const NodalColumns& dx) {
    assert(dx.rows() % 3 == 0 && dx.cols() == model.body->node_count());
    return std::visit([&](const auto& cells) { return strain_tangents_of(cells, model, x, dx); }, model.body->cells);
}

}  // namespace myo::model
