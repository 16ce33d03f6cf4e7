#include "model/internal_forces.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "base/parallel.hpp"
#include "model/cell_blocks.hpp"
#include "model/cell_kernel.hpp"
#include "model/fibre_forces.hpp"
#include "model/node_sums.hpp"
#include "model/pack_model.hpp"
#include "model/positive_part.hpp"

namespace myo::model {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

struct InternalForcesPolicy {
    /// Smallest number of packs worth a separate task; starting a task takes a few microseconds.
    int packs_per_task = 24;
    /// Packs whose forces and Hessians are kept before they are added up: the workspace stays in the cache.
    int packs_at_once = 32;
};
constexpr InternalForcesPolicy internal_forces_policy;

/// Calls visit(pack) for all packs, in parallel.
template <class Cells, class Visit>
void for_each_pack(const Cells& cells, const Visit& visit) {
    parallel_ranges(cells.pack_count(), internal_forces_policy.packs_per_task, [&](int first, int end) {
        for (int pack = first; pack < end; ++pack) visit(pack);
    });
}

/// Input of one pack from the fields of the body.
template <class Cells>
PackInput pack_input(const Model& model, const Cells& cells, const InternalInput& input, int pack) {
    const Stiffness& stiffness = *input.stiffness;
    PackInput in;
    in.elastic = !stiffness.elastic.empty();
    in.viscous = !stiffness.viscous.empty() && input.rate.history != nullptr;
    in.poissons_ratio = poissons_ratio_of(cells, pack, model);
    if (in.elastic) {
        // The split of the bulk modulus is that of the model's own moduli: otherwise a derivative by a modulus would
        // change it.
        in.elasticity = {stiffness.law ? stiffness.law.get() : model.material.get(),
                         pack_of(cells, pack, [&](std::size_t c) { return stiffness.elastic[c].mu; }),
                         pack_of(cells, pack, [&](std::size_t c) { return stiffness.elastic[c].kappa; }),
                         point_bulk(cells, pack, model.moduli), factors_of(cells, pack, stiffness.elastic_factors)};
    }
    if (in.viscous) {
        in.viscous_mu = pack_of(cells, pack, [&](std::size_t c) { return stiffness.viscous[c].mu; });
        in.viscous_factors = factors_of(cells, pack, stiffness.viscous_factors);
        in.rate_factor = input.rate.factor;
        in.rate_history = input.rate.history->data() + pack * cells.strains_per_cell() * pack_width;
    }
    if (input.pressure) in.pressure = input.pressure->data() + pack * cells.volumes_per_cell() * pack_width;
    return in;
}

/// Adds the blocks of a pack that belong to the own columns, cell by cell.
template <int N>
void assemble_pack(const BlockPattern& pattern, const Eigen::MatrixXi& cells, int pack, int lanes,
                   const PackOutput<N>& out, const OwnColumns& own, solver::SymmetricSparse& matrix) {
    for (int lane = 0; lane < lanes; ++lane) {
        const CellBlocks<N> blocks(pattern, cells, pack * pack_width + lane, own, matrix);
        for (int b = 0; b < N; ++b)
            for (int a = b; a < N; ++a) {
                const auto* values = reinterpret_cast<const double*>(
                                         out.hessian[static_cast<std::size_t>(lower_block<N>(a, b))].data()) +
                                     lane;
                blocks.add(a, b, [&](int r, int s) { return values[(r + 3 * s) * pack_width]; });
            }
    }
}

/// Projects the stiffness of each cell on the positive semidefinite matrices. Non-finite cells are left for the solver
/// to reject.
template <int N>
void project_cells_positive(int lanes, PackOutput<N>& out) {
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(lanes); ++lane) {
        Eigen::MatrixXd K(3 * N, 3 * N);
        const auto for_each_entry = [&](const auto& visit) {
            for (int b = 0; b < N; ++b)
                for (int a = b; a < N; ++a)
                    for (int s = 0; s < 3; ++s)
                        for (int r = 0; r < 3; ++r)
                            visit(3 * a + r, 3 * b + s,
                                  out.hessian[static_cast<std::size_t>(lower_block<N>(a, b))](r, s));
        };
        for_each_entry([&](int row, int column, Pack& value) { K(row, column) = K(column, row) = value[lane]; });
        if (!K.allFinite()) continue;
        project_positive(K);
        for_each_entry([&](int row, int column, Pack& value) { value[lane] = K(row, column); });
    }
}

/// Evaluates the packs first ... end - 1.
/// @param forces, energies  per pack, see NodeIncidence
/// @param output            output(pack): workspace of a pack
template <bool WithHessian, class Geometry, class Output>
void evaluate_packs(const PackedCells<Geometry>& cells, const Model& model, const Matrix3Xd& x,
                    const InternalInput& input, int first, int end, std::vector<Pack>& forces,
                    std::vector<Pack>& energies, const Output& output) {
    constexpr int N = Geometry::nodes;
    for (int pack = first; pack < end; ++pack) {
        PackOutput<N>& result = output(pack);
        evaluate_pack<WithHessian>(cells, pack, nodes_of_pack(cells, pack, x), pack_input(model, cells, input, pack),
                                   result);
        energies[static_cast<std::size_t>(pack)] = result.energy;
        std::copy(result.gradient.data(), result.gradient.data() + 3 * N, forces.begin() + pack * 3 * N);
    }
}

/// Assembles the Hessian. Cell matrices are computed in parallel for a group of packs that fits in the cache; then each
/// thread adds the blocks of its own columns in cell order. The order of summation is independent of the number of
/// threads.
template <class Geometry>
void assemble_packs(const PackedCells<Geometry>& cells, const Model& model, const Matrix3Xd& x,
                    const InternalInput& input, bool positive, std::vector<Pack>& forces, std::vector<Pack>& energies,
                    solver::SymmetricSparse& hessian) {
    constexpr int N = Geometry::nodes;
    constexpr int packs_at_once = internal_forces_policy.packs_at_once;
    const BlockPattern& pattern = model.body->pattern;
    // Workspace for one group of packs, reused for all groups.
    std::vector<PackOutput<N>> outputs(static_cast<std::size_t>(std::min(packs_at_once, cells.pack_count())));
    for (int start = 0; start < cells.pack_count(); start += packs_at_once) {
        const int count = std::min(packs_at_once, cells.pack_count() - start);
        // An eighth of the usual grain: with Hessian a pack costs several times more.
        parallel_ranges(count, internal_forces_policy.packs_per_task / 8, [&](int first, int end) {
            evaluate_packs<true>(
                cells, model, x, input, start + first, start + end, forces, energies,
                [&](int pack) -> PackOutput<N>& { return outputs[static_cast<std::size_t>(pack - start)]; });
            if (positive)
                for (int k = first; k < end; ++k)
                    project_cells_positive(cells.lanes_used(start + k), outputs[static_cast<std::size_t>(k)]);
        });
        parallel_ranges(pattern.free_count, 125, [&](int first, int end) {
            for (int pack = start; pack < start + count; ++pack)
                assemble_pack<N>(pattern, model.body->mesh.cells, pack, cells.lanes_used(pack),
                                 outputs[static_cast<std::size_t>(pack - start)], {first, end}, hessian);
        });
    }
}

/// Adds elastic and viscous energy of all cells with its derivatives.
template <class Geometry>
void add_cells(const PackedCells<Geometry>& cells, const Model& model, const Matrix3Xd& x, const InternalInput& input,
               HessianKind kind, InternalEnergy& out) {
    constexpr int N = Geometry::nodes;
    static thread_local std::vector<Pack> forces,
        energies;  // kept between calls: this runs thousands of times a second
    std::vector<Pack>&force_field = forces,
    &energy_field = energies;  // references, so that helper threads use this thread's storage
    force_field.resize(static_cast<std::size_t>(cells.pack_count()) * 3 * N);
    energy_field.resize(static_cast<std::size_t>(cells.pack_count()));
    if (kind == HessianKind::none)
        parallel_ranges(cells.pack_count(), internal_forces_policy.packs_per_task, [&](int first, int end) {
            PackOutput<N> result;
            evaluate_packs<false>(cells, model, x, input, first, end, force_field, energy_field,
                                  [&](int) -> PackOutput<N>& { return result; });
        });
    else
        assemble_packs(cells, model, x, input, kind == HessianKind::positive, force_field, energy_field, out.hessian);
    // Sequential sum: the energy must not depend on the number of threads.
    for (int pack = 0; pack < cells.pack_count(); ++pack)
        for (int lane = 0; lane < cells.lanes_used(pack); ++lane)
            out.energy += energy_field[static_cast<std::size_t>(pack)][static_cast<std::size_t>(lane)];
    add_at_nodes(model.body->incidence, reinterpret_cast<const double*>(force_field.data()), out.gradient);
}

/// Pressures of all volume points: U'(theta) + U''(theta) d theta. Without dx the linear term is zero.
template <class Geometry>
VectorXd pack_pressures(const PackedCells<Geometry>& cells, const Model& model, const Stiffness& stiffness,
                        const Matrix3Xd& x, const Matrix3Xd* dx) {
    const int per_cell = cells.volumes_per_cell();
    VectorXd pressure = VectorXd::Zero(cells.pack_count() * per_cell * pack_width);
    if (!model.material->has_split()) return pressure;
    InternalInput input;
    input.stiffness = &stiffness;
    for_each_pack(cells, [&](int pack) {
        // Pressures depend on elastic moduli only; viscous parts of the input stay empty.
        const PackInput in = pack_input(model, cells, input, pack);
        const auto xe = nodes_of_pack(cells, pack, x), de = dx ? nodes_of_pack(cells, pack, *dx) : xe;
        const PointKinematics<Geometry> points(cells.geometry(pack), cells.surroundings_of(pack), xe,
                                               in.poissons_ratio);
        const auto motion = points.along(de);
        const auto write = [&](int entry_of_cell, const material::ScalarFunctionOf<Pack>& U, const Pack& d_theta) {
            const Pack p = U.first + U.second * d_theta;
            p.copy_to(pressure.data() + (pack * per_cell + entry_of_cell) * pack_width,
                      std::experimental::element_aligned);
        };
        ElasticPoints<Geometry> elastic(cells, pack, in.elasticity);
        Pack mean_d_theta = 0.0;
        elastic.visit(points, [&](const PointState& point) {
            const Pack d_theta = dx ? material::double_dot(point.law.volume.gradient, points.tangent(point.q, motion))
                                    : Pack(0.0);
            if (elastic.mean())
                mean_d_theta += point.share * d_theta;
            else
                write(point.q, elastic.bulk_at(point), d_theta);
        });
        if (elastic.mean()) write(0, elastic.bulk_of_mean(), mean_d_theta);
    });
    return pressure;
}

/// Green strains of all points at x; with dx their derivative along dx.
template <class Geometry>
VectorXd pack_strains(const PackedCells<Geometry>& cells, const Model& model, const Matrix3Xd& x, const Matrix3Xd* dx) {
    const int per_cell = cells.strains_per_cell();
    VectorXd result(cells.pack_count() * per_cell * pack_width);
    for_each_pack(cells, [&](int pack) {
        const auto xe = nodes_of_pack(cells, pack, x);
        const PointKinematics<Geometry> points = points_of(cells, pack, model, xe);
        const auto write = [&](int q, const PackSymmetric& e) {
            for (int i = 0; i < 6; ++i)
                e[static_cast<std::size_t>(i)].copy_to(result.data() + (pack * per_cell + 6 * q + i) * pack_width,
                                                       std::experimental::element_aligned);
        };
        if (!dx) {
            for (int q = 0; q < Geometry::points; ++q) write(q, green_strain(points.gradient(q)));
            return;
        }
        const auto de = nodes_of_pack(cells, pack, *dx);
        const auto motion = points.along(de);
        for (int q = 0; q < Geometry::points; ++q)
            write(q, green_strain_tangent(points.gradient(q), points.tangent(q, motion)));
    });
    return result;
}

}  // namespace

Stiffness stiffness(const Model& model) {
    Stiffness s;
    s.elastic = model.moduli;
    s.elastic_factors = model.point_factors;
    if (model.creep || is_viscous(model)) {
        s.viscous = model.moduli;
        for (std::size_t c = 0; c < s.viscous.size(); ++c) {
            const double scale = viscous_scale(model, c);
            s.viscous[c] = {s.viscous[c].mu * scale, s.viscous[c].kappa * scale};
        }
        s.viscous_factors = model.point_factors;
    }
    return s;
}

double viscous_scale(const Model& model, std::size_t cell) {
    if (model.creep) return 1.0;
    return model.damping_excess_s.empty() ? model.damping_s : model.damping_s + model.damping_excess_s[cell];
}

bool is_viscous(const Model& model) {
    return model.damping_s > 0.0 || std::any_of(model.damping_excess_s.begin(), model.damping_excess_s.end(),
                                                [](double excess) { return excess > 0.0; });
}

VectorXd times_factors(const VectorXd& a, const VectorXd& b) {
    return a.size() == 0 ? b : b.size() == 0 ? a : VectorXd(a.cwiseProduct(b));
}

InternalEnergy internal_energy(const Model& model, const Matrix3Xd& x, const InternalInput& input, HessianKind kind) {
    assert(x.cols() == model.body->node_count() && input.stiffness != nullptr);
    InternalEnergy out;
    out.gradient = Matrix3Xd::Zero(3, x.cols());
    if (kind != HessianKind::none) out.hessian = model.body->pattern.zero;
    std::visit([&](const auto& cells) { add_cells(cells, model, x, input, kind, out); }, model.body->cells);
    if (input.stiffness->fibres && !model.fibres->empty()) {
        assert(input.activation != nullptr && input.activation->size() == model.fibres->size());
        add_fibres(model, x, *input.activation, kind, out);
    }
    return out;
}

VectorXd pressures(const Model& model, const Stiffness& stiffness, const Matrix3Xd& x) {
    return std::visit([&](const auto& cells) { return pack_pressures(cells, model, stiffness, x, nullptr); },
                      model.body->cells);
}

VectorXd predicted_pressures(const Model& model, const Stiffness& stiffness, const Matrix3Xd& x, const Matrix3Xd& dx) {
    return std::visit([&](const auto& cells) { return pack_pressures(cells, model, stiffness, x, &dx); },
                      model.body->cells);
}

VectorXd strains(const Model& model, const Matrix3Xd& x) {
    return std::visit([&](const auto& cells) { return pack_strains(cells, model, x, nullptr); }, model.body->cells);
}

VectorXd strain_tangent(const Model& model, const Matrix3Xd& x, const Matrix3Xd& dx) {
    return std::visit([&](const auto& cells) { return pack_strains(cells, model, x, &dx); }, model.body->cells);
}

Matrix3Xd viscous_gradient(const Model& model, const Matrix3Xd& x, const VectorXd& rate) {
    // A rate factor of 0 makes the rate constant: the gradient then contains the viscous force alone.
    Stiffness viscous_only = stiffness(model);
    viscous_only.elastic.clear();
    viscous_only.fibres = false;
    InternalInput input;
    input.stiffness = &viscous_only;
    input.rate = {0.0, &rate};
    return internal_energy(model, x, input, HessianKind::none).gradient;
}

}  // namespace myo::model
