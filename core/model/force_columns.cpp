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

/// Adds the viscous forces of a given strain rate.
template <class Geometry>
void add_viscous(const PointKinematics<Geometry>& points, const Pack& viscous_mu, const double* factors,
                 const double* rate, PackNodes<Geometry::nodes>& gradient) {
    StressSum<Geometry> stress(points);
    Pack unused = 0.0;
    material::Matrix9<Pack> no_tangent;
    for (int q = 0; q < Geometry::points; ++q) {
        material::Matrix3<Pack> P = zero_tensor();
        add_viscous_response<false>(points.gradient(q), factors ? viscous_mu * entry(factors, q) : viscous_mu, 0.0,
                                    rate, q, unused, P, no_tangent);
        stress.add(q, P * points.weight(q));
    }
    stress.add_to(gradient);
}

/// Lanes value(cell) of a pack; 0 for lanes past the last cell.
template <class Cells, class Value>
Pack lanes_of(const Cells& cells, int pack, const Value& value) {
    return Pack([&](auto lane) {
        const int cell = pack * pack_width + static_cast<int>(lane);
        return cell < cells.cell_count ? value(static_cast<std::size_t>(cell)) : 0.0;
    });
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
            const auto keep = [&](std::vector<Pack>& field, const PackInput& in) {
                evaluate_pack<false>(cells, pack, xe, in, out);
                std::copy(out.gradient.data(), out.gradient.data() + 3 * N, field.begin() + pack * 3 * N);
            };
            PackInput elastic;
            elastic.material = model.material.get();
            elastic.elastic = true;
            elastic.poissons_ratio = poissons_ratio_of(cells, pack, model);
            elastic.elastic_factors = factors_of(cells, pack, elastic_factors);
            elastic.point_bulk = point_bulk(cells, pack, model.moduli);
            elastic.mu = 1.0;
            keep(forces.mu, elastic);
            // Unit bulk modulus with zero shear modulus.
            std::swap(elastic.mu, elastic.kappa);
            keep(forces.kappa, elastic);
            if (rate.size() == 0) continue;
            PackInput viscous;
            viscous.viscous = true;
            viscous.poissons_ratio = elastic.poissons_ratio;
            viscous.viscous_mu = 1.0;
            viscous.viscous_factors = factors_of(cells, pack, model.point_factors);
            viscous.rate_history = rate.data() + pack * cells.strains_per_cell() * pack_width;
            keep(forces.viscous, viscous);
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
    const Pack mu = pack_of(cells, pack, [&](std::size_t c) { return model.moduli[c].mu; });
    const Pack kappa = pack_of(cells, pack, [&](std::size_t c) { return model.moduli[c].kappa; });
    const double* factors = factors_of(cells, pack, model.point_factors);
    const bool mean = cells.mean_volume && model.material->has_split();
    const Pack point_kappa = mean ? point_bulk(cells, pack, model.moduli).of(mu, kappa) : kappa;
    std::array<PackNodes<N>, Q> forces;
    std::array<material::LawResponse<Pack>, Q> laws;
    PackNodes<N> mean_gradient = PackNodes<N>::Constant(Pack(0.0));
    Pack theta = 0.0;
    for (std::size_t q = 0; q < Q; ++q) {
        const int point = static_cast<int>(q);
        const Pack factor = factors ? entry(factors, point) : Pack(1.0), weight = points.weight(point);
        material::LawResponse<Pack>& law = laws[q];
        model.material->respond(points.gradient(point), mu * factor, kappa * factor, false, law);
        material::Matrix3<Pack> P = law.distortion.gradient;
        if (model.material->has_split())
            P += law.volume.gradient * model.material->bulk(law.volume.value, point_kappa * factor).first;
        StressSum<Geometry> stress(points);
        stress.add(point, P * weight);
        forces[q].setConstant(Pack(0.0));
        stress.add_to(forces[q]);
        if (!mean) continue;
        theta += weight / cells.geometry(pack).volume * law.volume.value;
        // Gradient of the mean volume, needed for the part of the pressure that acts on all points.
        StressSum<Geometry> of_theta(points);
        of_theta.add(point, law.volume.gradient * weight);
        of_theta.add_to(mean_gradient);
    }
    if (mean)  // the cell's bulk modulus is the average over its points
        for (std::size_t q = 0; q < Q; ++q) {
            const int point = static_cast<int>(q);
            const Pack factor = factors ? entry(factors, point) : Pack(1.0),
                       share = points.weight(point) / cells.geometry(pack).volume;
            forces[q] += mean_gradient * model.material->bulk(theta, (kappa - point_kappa) * factor * share).first;
        }
    return forces;
}

/// out.gradient += weight * unit for one pack; skipped if the weight is zero in all lanes.
template <int N>
void add_weighted(const std::vector<Pack>& unit, int pack, const Pack& weight, PackOutput<N>& out) {
    if (unit.empty() || all_of(weight == 0.0)) return;
    for (int k = 0; k < 3 * N; ++k)
        out.gradient(k % 3, k / 3) += weight * unit[static_cast<std::size_t>(pack * 3 * N + k)];
}

template <class Geometry>
NodalColumns gradients_of(const PackedCells<Geometry>& cells, const Model& model, const Matrix3Xd& x,
                          const UnitForces& forces, const GradientChanges& changes) {
    constexpr int N = Geometry::nodes;
    const auto columns = static_cast<Index>(changes.stiffness.size());
    const auto field = static_cast<std::size_t>(cells.pack_count()) * 3 * N;
    std::vector<Pack> nodal(field * static_cast<std::size_t>(std::min(force_columns_policy.at_once, columns)));
    NodalColumns result = NodalColumns::Zero(3 * columns, x.cols());
    // Groups of columns: each pack's kinematics serve all columns of a group.
    for (Index start = 0; start < columns; start += force_columns_policy.at_once) {
        const Index count = std::min(force_columns_policy.at_once, columns - start);
        parallel_ranges(cells.pack_count(), force_columns_policy.packs_per_thread, [&](int first, int end) {
            PackOutput<N> out;
            for (int pack = first; pack < end; ++pack) {
                const auto xe = nodes_of_pack(cells, pack, x);
                // Kinematics are needed for viscous forces only.
                std::optional<PointKinematics<Geometry>> points;
                Pack viscous_mu = 0.0;
                if (changes.rates.size() > 0) {
                    points.emplace(points_of(cells, pack, model, xe));
                    viscous_mu = lanes_of(cells, pack,
                                          [&](std::size_t c) { return viscous_scale(model) * model.moduli[c].mu; });
                }
                std::optional<std::array<PackNodes<N>, Geometry::points>> of_points;
                if (changes.softening.size() > 0) of_points.emplace(point_forces_of(cells, pack, model, x));
                for (Index k = 0; k < count; ++k) {
                    const Stiffness& own = changes.stiffness[static_cast<std::size_t>(start + k)];
                    out.gradient.setConstant(Pack(0.0));
                    if (!own.elastic.empty()) {
                        add_weighted<N>(forces.mu, pack,
                                        lanes_of(cells, pack, [&](std::size_t c) { return own.elastic[c].mu; }), out);
                        add_weighted<N>(forces.kappa, pack,
                                        lanes_of(cells, pack, [&](std::size_t c) { return own.elastic[c].kappa; }),
                                        out);
                    }
                    if (!own.viscous.empty())
                        add_weighted<N>(forces.viscous, pack,
                                        lanes_of(cells, pack, [&](std::size_t c) { return own.viscous[c].mu; }), out);
                    if (points)
                        add_viscous(*points, viscous_mu, factors_of(cells, pack, model.point_factors),
                                    changes.rates.col(start + k).data() + pack * cells.strains_per_cell() * pack_width,
                                    out.gradient);
                    if (of_points) {
                        const double* const d = changes.softening.col(start + k).data() +
                                                pack * Geometry::points * pack_width;
                        for (std::size_t q = 0; q < Geometry::points; ++q)
                            out.gradient += (*of_points)[q] * entry(d, static_cast<int>(q));
                    }
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
