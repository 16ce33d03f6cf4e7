#include "model/internal_forces.hpp"

#include <array>
#include <cassert>

#include "base/parallel.hpp"
#include "model/cell_blocks.hpp"
#include "model/cell_kernel.hpp"
#include "model/fibre_forces.hpp"
#include "model/node_sums.hpp"
#include "model/positive_part.hpp"

namespace myo {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

/// Least work that pays for handing it to another thread, which takes a few microseconds.
constexpr int packs_per_task = 24;

template <class Cells, class Visit>
void for_each_pack(const Cells& cells, const Visit& visit) {
    parallel_ranges(cells.pack_count(), packs_per_task, [&](int first, int end) {
        for (int pack = first; pack < end; ++pack) visit(pack);
    });
}

/// f(cell) of the pack's cells; past the last cell, of the last.
template <class Cells, class Value>
Pack pack_of(const Cells& cells, int pack, const Value& value) {
    return Pack([&](auto lane) { return value(static_cast<std::size_t>(std::min(pack * pack_width + static_cast<int>(lane), cells.cell_count - 1))); });
}

template <class Cells>
PackInput pack_input(const Model& model, const Cells& cells, const InternalInput& input, int pack) {
    const Stiffness& stiffness = *input.stiffness;
    PackInput in;
    in.material = model.material.get();
    in.elastic = !stiffness.elastic.empty();
    in.viscous = !stiffness.viscous.empty() && input.rate.history != nullptr;
    if (in.elastic) {
        in.mu = pack_of(cells, pack, [&](std::size_t c) { return stiffness.elastic[c].mu; });
        in.kappa = pack_of(cells, pack, [&](std::size_t c) { return stiffness.elastic[c].kappa; });
        if (cells.mean_volume) in.point_bulk = point_bulk(cells, pack, model.moduli);
    }
    if (in.viscous) {
        in.viscous_mu = pack_of(cells, pack, [&](std::size_t c) { return stiffness.viscous[c].mu; });
        in.rate_factor = input.rate.factor;
        in.rate_history = input.rate.history->data() + pack * cells.strains_per_cell() * pack_width;
    }
    if (input.pressure) in.pressure = input.pressure->data() + pack * cells.volumes_per_cell() * pack_width;
    return in;
}

/// Adds those of a pack's blocks to the assembled matrix that lie in the columns, cell by cell.
template <int N>
void assemble_pack(const BlockPattern& pattern, const Eigen::MatrixXi& cells, int pack, int lanes, const PackOutput<N>& out, const OwnColumns& own,
                   SymmetricSparse& matrix) {
    for (int lane = 0; lane < lanes; ++lane) {
        const CellBlocks<N> blocks(pattern, cells, pack * pack_width + lane, own, matrix);
        for (int b = 0; b < N; ++b)
            for (int a = b; a < N; ++a) {
                const auto* values = reinterpret_cast<const double*>(out.hessian[static_cast<std::size_t>(lower_block<N>(a, b))].data()) + lane;
                blocks.add(a, b, [&](int r, int s) { return values[(r + 3 * s) * pack_width]; });
            }
    }
}

template <int N>
void project_cells_positive(int lanes, PackOutput<N>& out) {
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(lanes); ++lane) {
        Eigen::MatrixXd K(3 * N, 3 * N);
        const auto for_each_entry = [&](const auto& visit) {
            for (int b = 0; b < N; ++b)
                for (int a = b; a < N; ++a)
                    for (int s = 0; s < 3; ++s)
                        for (int r = 0; r < 3; ++r) visit(3 * a + r, 3 * b + s, out.hessian[static_cast<std::size_t>(lower_block<N>(a, b))](r, s));
        };
        for_each_entry([&](int row, int column, Pack& value) { K(row, column) = K(column, row) = value[lane]; });
        if (!K.allFinite()) continue;
        project_positive(K);
        for_each_entry([&](int row, int column, Pack& value) { value[lane] = K(row, column); });
    }
}

/// Forces (per cell node, see NodeIncidence) and energies of the packs first ... end - 1. output(pack): where a pack is evaluated.
template <bool WithHessian, int N, int Q, class Output>
void evaluate_packs(const PackedCells<N, Q>& cells, const Model& model, const Matrix3Xd& x, const InternalInput& input, int first, int end,
                    std::vector<Pack>& forces, std::vector<Pack>& energies, const Output& output) {
    for (int pack = first; pack < end; ++pack) {
        PackOutput<N>& result = output(pack);
        const PackInput in = pack_input(model, cells, input, pack);
        evaluate_pack<WithHessian>(cells, pack, gather_lanes<N>(cells.lane_nodes[static_cast<std::size_t>(pack)], x), in, result);
        energies[static_cast<std::size_t>(pack)] = result.energy;
        std::copy(result.gradient.data(), result.gradient.data() + 3 * N, forces.begin() + pack * 3 * N);
    }
}

/// Cells' matrices are made side by side for as many packs as fit in a cache, then every thread adds those that fall in its
/// columns, one after the other, so that sums do not depend on the number of threads.
template <int N, int Q>
void assemble_packs(const PackedCells<N, Q>& cells, const Model& model, const Matrix3Xd& x, const InternalInput& input, bool positive,
                    std::vector<Pack>& forces, std::vector<Pack>& energies, SymmetricSparse& hessian) {
    constexpr int packs_at_once = 32;
    const BlockPattern& pattern = model.body->pattern;
    std::vector<PackOutput<N>> outputs(static_cast<std::size_t>(std::min(packs_at_once, cells.pack_count())));
    for (int start = 0; start < cells.pack_count(); start += packs_at_once) {
        const int count = std::min(packs_at_once, cells.pack_count() - start);
        parallel_ranges(count, packs_per_task / 8, [&](int first, int end) {
            evaluate_packs<true>(cells, model, x, input, start + first, start + end, forces, energies,
                                 [&](int pack) -> PackOutput<N>& { return outputs[static_cast<std::size_t>(pack - start)]; });
            if (positive)
                for (int k = first; k < end; ++k) project_cells_positive(cells.lanes_used(start + k), outputs[static_cast<std::size_t>(k)]);
        });
        parallel_ranges(pattern.free_count, 125, [&](int first, int end) {
            for (int pack = start; pack < start + count; ++pack)
                assemble_pack<N>(pattern, model.body->mesh.cells, pack, cells.lanes_used(pack), outputs[static_cast<std::size_t>(pack - start)], {first, end}, hessian);
        });
    }
}

template <int N, int Q>
void add_cells(const PackedCells<N, Q>& cells, const Model& model, const Matrix3Xd& x, const InternalInput& input, HessianKind kind, InternalEnergy& out) {
    static thread_local std::vector<Pack> forces, energies;   // kept, because this runs thousands of times a second
    std::vector<Pack>&force_field = forces, &energy_field = energies;   // of this thread, for all that help it
    force_field.resize(static_cast<std::size_t>(cells.pack_count()) * 3 * N);
    energy_field.resize(static_cast<std::size_t>(cells.pack_count()));
    if (kind == HessianKind::none)
        parallel_ranges(cells.pack_count(), packs_per_task, [&](int first, int end) {
            PackOutput<N> result;
            evaluate_packs<false>(cells, model, x, input, first, end, force_field, energy_field, [&](int) -> PackOutput<N>& { return result; });
        });
    else assemble_packs(cells, model, x, input, kind == HessianKind::positive, force_field, energy_field, out.hessian);
    for (int pack = 0; pack < cells.pack_count(); ++pack)
        for (int lane = 0; lane < cells.lanes_used(pack); ++lane) out.energy += energy_field[static_cast<std::size_t>(pack)][static_cast<std::size_t>(lane)];
    add_at_nodes(model.body->incidence, reinterpret_cast<const double*>(force_field.data()), out.gradient);
}

/// theta of each volume point and its derivative along dx (zero when dx is null), then the pressures they make.
template <int N, int Q>
VectorXd pack_pressures(const PackedCells<N, Q>& cells, const Model& model, const std::vector<Moduli>& moduli, const Matrix3Xd& x, const Matrix3Xd* dx) {
    const int per_cell = cells.volumes_per_cell();
    VectorXd pressure = VectorXd::Zero(cells.pack_count() * per_cell * pack_width);
    if (!model.material->has_split()) return pressure;
    for_each_pack(cells, [&](int pack) {
        LawResponse<Pack> law;
        const PackGeometry<N, Q>& geometry = cells.geometry[static_cast<std::size_t>(pack)];
        const auto& nodes = cells.lane_nodes[static_cast<std::size_t>(pack)];
        const Pack mu = pack_of(cells, pack, [&](std::size_t c) { return moduli[c].mu; });
        const Pack kappa = pack_of(cells, pack, [&](std::size_t c) { return moduli[c].kappa; });
        const auto xe = gather_lanes<N>(nodes, x), de = dx ? gather_lanes<N>(nodes, *dx) : xe;
        Pack theta = 0.0, d_theta = 0.0;
        for (int q = 0; q < Q; ++q) {
            const auto& G = geometry.gradient[static_cast<std::size_t>(q)];
            model.material->respond(deformation_gradient<N>(xe, G), mu, kappa, false, law);
            const Pack share = cells.mean_volume ? geometry.weight[static_cast<std::size_t>(q)] / geometry.volume : Pack(1.0);
            if (!cells.mean_volume) theta = d_theta = 0.0;
            theta += share * law.volume.value;
            if (dx) d_theta += share * double_dot(law.volume.gradient, deformation_gradient<N>(de, G));
            if (cells.mean_volume && q + 1 < Q) continue;
            const ScalarFunctionOf<Pack> U = model.material->bulk(theta, cells.mean_volume ? kappa - point_bulk(cells, pack, model.moduli).of(mu, kappa) : kappa);
            const Pack p = U.first + U.second * d_theta;
            p.copy_to(pressure.data() + (pack * per_cell + (cells.mean_volume ? 0 : q)) * pack_width, std::experimental::element_aligned);
        }
    });
    return pressure;
}

/// Strains of every cell at x, or their derivative along dx when dx is given.
template <int N, int Q>
VectorXd pack_strains(const PackedCells<N, Q>& cells, const Matrix3Xd& x, const Matrix3Xd* dx) {
    const int per_cell = cells.strains_per_cell();
    VectorXd result(cells.pack_count() * per_cell * pack_width);
    for_each_pack(cells, [&](int pack) {
        const PackGeometry<N, Q>& geometry = cells.geometry[static_cast<std::size_t>(pack)];
        const auto& nodes = cells.lane_nodes[static_cast<std::size_t>(pack)];
        const auto xe = gather_lanes<N>(nodes, x), de = dx ? gather_lanes<N>(nodes, *dx) : xe;
        const auto store = [&](int i, const Pack& value) {
            value.copy_to(result.data() + (pack * per_cell + i) * pack_width, std::experimental::element_aligned);
        };
        for (int q = 0; q < Q; ++q) {
            const auto& G = geometry.gradient[static_cast<std::size_t>(q)];
            const Matrix3<Pack> F = deformation_gradient<N>(xe, G);
            const PackStrain e = dx ? green_strain_tangent(F, deformation_gradient<N>(de, G)) : green_strain(F);
            for (int i = 0; i < 6; ++i) store(6 * q + i, e[static_cast<std::size_t>(i)]);
        }
        if constexpr (N == 8 && Q == 1)
            if (!cells.hourglass.empty()) {
                const HourglassStrain h = hourglass_strain(xe, geometry.gradient[0], cells.hourglass[static_cast<std::size_t>(pack)]);
                const Eigen::Matrix<Pack, 3, 4> values = dx ? hourglass_tangent(h, de) : h.strain;
                for (int s = 0; s < 4; ++s)
                    for (int i = 0; i < 3; ++i) store(6 + i + 3 * s, values(i, s));
            }
    });
    return result;
}

}  // namespace

Stiffness stiffness(const Model& model) {
    Stiffness s;
    s.elastic = model.moduli;
    const double scale = viscous_scale(model);
    if (scale > 0.0) {
        s.viscous = model.moduli;
        for (Moduli& m : s.viscous) m = {m.mu * scale, m.kappa * scale};
    }
    return s;
}

double viscous_scale(const Model& model) { return model.creep ? 1.0 : model.damping_s; }

std::vector<Moduli> softened(std::vector<Moduli> moduli, const VectorXd& factors) {
    for (Eigen::Index c = 0; c < factors.size(); ++c) {
        Moduli& m = moduli[static_cast<std::size_t>(c)];
        m = {m.mu * factors(c), m.kappa * factors(c)};
    }
    return moduli;
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

VectorXd pressures(const Model& model, const std::vector<Moduli>& moduli, const Matrix3Xd& x) {
    return std::visit([&](const auto& cells) { return pack_pressures(cells, model, moduli, x, nullptr); }, model.body->cells);
}

VectorXd predicted_pressures(const Model& model, const std::vector<Moduli>& moduli, const Matrix3Xd& x, const Matrix3Xd& dx) {
    return std::visit([&](const auto& cells) { return pack_pressures(cells, model, moduli, x, &dx); }, model.body->cells);
}

VectorXd strains(const Body& body, const Matrix3Xd& x) {
    return std::visit([&](const auto& cells) { return pack_strains(cells, x, nullptr); }, body.cells);
}

VectorXd strain_tangent(const Body& body, const Matrix3Xd& x, const Matrix3Xd& dx) {
    return std::visit([&](const auto& cells) { return pack_strains(cells, x, &dx); }, body.cells);
}

Matrix3Xd viscous_gradient(const Model& model, const Matrix3Xd& x, const VectorXd& rate) {
    Stiffness viscous_only = stiffness(model);
    viscous_only.elastic.clear();
    viscous_only.fibres = false;
    InternalInput input;
    input.stiffness = &viscous_only;
    input.rate = {0.0, &rate};
    return internal_energy(model, x, input, HessianKind::none).gradient;
}

}  // namespace myo
