#include "model/force_columns.hpp"

#include <algorithm>
#include <cassert>
#include <optional>

#include "base/parallel.hpp"
#include "model/cell_kernel.hpp"
#include "model/node_sums.hpp"

namespace myo {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int packs_per_thread = 16;

/// What the columns share of a pack: all that depends on the positions alone.
template <int N, int Q>
struct PackAt {
    const PackGeometry<N, Q>& geometry;
    std::array<Matrix3<Pack>, Q> F;
    const PackHourglass* shape = nullptr;
    std::optional<HourglassStrain> hourglass;

    PackAt(const PackedCells<N, Q>& cells, int pack, const Matrix3Xd& x) : geometry(cells.geometry[static_cast<std::size_t>(pack)]) {
        const auto xe = gather_lanes<N>(cells.lane_nodes[static_cast<std::size_t>(pack)], x);
        for (std::size_t q = 0; q < Q; ++q) F[q] = deformation_gradient<N>(xe, geometry.gradient[q]);
        if constexpr (N == 8 && Q == 1)
            if (!cells.hourglass.empty()) {
                shape = &cells.hourglass[static_cast<std::size_t>(pack)];
                hourglass = hourglass_strain(xe, geometry.gradient[0], *shape);
            }
    }

    /// The viscous forces of a strain rate are added to out.gradient.
    void add_viscous(const Pack& viscous_mu, const double* rate, PackOutput<N>& out) const {
        PackInput in;
        in.viscous = true;
        in.viscous_mu = viscous_mu;
        in.rate_history = rate;
        Pack unused = 0.0;
        Matrix9<Pack> no_tangent;
        for (std::size_t q = 0; q < Q; ++q) {
            Matrix3<Pack> P = Matrix3<Pack>::Constant(Pack(0.0));
            add_viscous_response<false>(F[q], in, rate + 6 * static_cast<int>(q) * pack_width, unused, P, no_tangent);
            add_nodal_forces<N>(P * geometry.weight[q], geometry.gradient[q], out.gradient);
        }
        if constexpr (N == 8 && Q == 1)
            if (hourglass) add_hourglass<false>(*hourglass, geometry.gradient[0], *shape, geometry.volume, in, out);
    }
};

/// value(cell) in the lanes of a pack; 0 past the last cell.
template <class Cells, class Value>
Pack lanes_of(const Cells& cells, int pack, const Value& value) {
    return Pack([&](auto lane) {
        const int cell = pack * pack_width + static_cast<int>(lane);
        return cell < cells.cell_count ? value(static_cast<std::size_t>(cell)) : 0.0;
    });
}

template <int N, int Q>
UnitForces unit_forces_of(const PackedCells<N, Q>& cells, const Model& model, const Matrix3Xd& x, const VectorXd& rate) {
    const auto size = static_cast<std::size_t>(cells.pack_count()) * 3 * N;
    UnitForces forces{std::vector<Pack>(size), std::vector<Pack>(size), std::vector<Pack>(rate.size() > 0 ? size : 0)};
    parallel_ranges(cells.pack_count(), packs_per_thread, [&](int first, int end) {
        PackOutput<N> out;
        for (int pack = first; pack < end; ++pack) {
            const auto xe = gather_lanes<N>(cells.lane_nodes[static_cast<std::size_t>(pack)], x);
            const auto keep = [&](std::vector<Pack>& field, const PackInput& in) {
                evaluate_pack<false>(cells, pack, xe, in, out);
                std::copy(out.gradient.data(), out.gradient.data() + 3 * N, field.begin() + pack * 3 * N);
            };
            PackInput elastic;
            elastic.material = model.material.get();
            elastic.elastic = true;
            elastic.point_bulk = point_bulk(cells, pack, model.moduli);
            elastic.mu = 1.0;
            keep(forces.mu, elastic);
            std::swap(elastic.mu, elastic.kappa);
            keep(forces.kappa, elastic);
            if (rate.size() == 0) continue;
            PackInput viscous;
            viscous.viscous = true;
            viscous.viscous_mu = 1.0;
            viscous.rate_history = rate.data() + pack * cells.strains_per_cell() * pack_width;
            keep(forces.viscous, viscous);
        }
    });
    return forces;
}

/// field += weight * unit for one pack, where the weight is not zero in all lanes.
template <int N>
void add_weighted(const std::vector<Pack>& unit, int pack, const Pack& weight, PackOutput<N>& out) {
    if (unit.empty() || all_of(weight == 0.0)) return;
    for (int k = 0; k < 3 * N; ++k) out.gradient(k % 3, k / 3) += weight * unit[static_cast<std::size_t>(pack * 3 * N + k)];
}

template <int N, int Q>
NodalColumns gradients_of(const PackedCells<N, Q>& cells, const Model& model, const Matrix3Xd& x, const UnitForces& forces,
                          const std::vector<Stiffness>& stiffness, const MatrixXd& rates) {
    const auto columns = static_cast<Index>(stiffness.size());
    constexpr Index at_once = 8;   // columns for which a pack is looked at once; more would fill the cache with forces
    const auto field = static_cast<std::size_t>(cells.pack_count()) * 3 * N;
    std::vector<Pack> nodal(field * static_cast<std::size_t>(std::min(at_once, columns)));
    NodalColumns result = NodalColumns::Zero(3 * columns, x.cols());
    for (Index start = 0; start < columns; start += at_once) {
        const Index count = std::min(at_once, columns - start);
        parallel_ranges(cells.pack_count(), packs_per_thread, [&](int first, int end) {
            PackOutput<N> out;
            for (int pack = first; pack < end; ++pack) {
                std::optional<PackAt<N, Q>> at;
                Pack viscous_mu = 0.0;
                if (rates.size() > 0) {
                    at.emplace(cells, pack, x);
                    viscous_mu = lanes_of(cells, pack, [&](std::size_t c) { return viscous_scale(model) * model.moduli[c].mu; });
                }
                for (Index k = 0; k < count; ++k) {
                    const Stiffness& own = stiffness[static_cast<std::size_t>(start + k)];
                    out.gradient.setConstant(Pack(0.0));
                    if (!own.elastic.empty()) {
                        add_weighted<N>(forces.mu, pack, lanes_of(cells, pack, [&](std::size_t c) { return own.elastic[c].mu; }), out);
                        add_weighted<N>(forces.kappa, pack, lanes_of(cells, pack, [&](std::size_t c) { return own.elastic[c].kappa; }), out);
                    }
                    if (!own.viscous.empty()) add_weighted<N>(forces.viscous, pack, lanes_of(cells, pack, [&](std::size_t c) { return own.viscous[c].mu; }), out);
                    if (at) at->add_viscous(viscous_mu, rates.col(start + k).data() + pack * cells.strains_per_cell() * pack_width, out);
                    std::copy(out.gradient.data(), out.gradient.data() + 3 * N, nodal.begin() + static_cast<std::ptrdiff_t>(field) * k + pack * 3 * N);
                }
            }
        });
        for (Index k = 0; k < count; ++k)
            add_at_nodes(model.body->incidence, reinterpret_cast<const double*>(nodal.data() + static_cast<std::ptrdiff_t>(field) * k), nodal_column(result, start + k));
    }
    return result;
}

template <int N, int Q>
MatrixXd strain_tangents_of(const PackedCells<N, Q>& cells, const Matrix3Xd& x, const NodalColumns& dx) {
    const int per_cell = cells.strains_per_cell();
    MatrixXd result(cells.pack_count() * per_cell * pack_width, dx.rows() / 3);
    parallel_ranges(cells.pack_count(), packs_per_thread, [&](int first, int end) {
        for (int pack = first; pack < end; ++pack) {
            const PackAt<N, Q> at(cells, pack, x);
            const auto& nodes = cells.lane_nodes[static_cast<std::size_t>(pack)];
            for (Index p = 0; p < result.cols(); ++p) {
                Eigen::Matrix<Pack, 3, N> de;
                for (int a = 0; a < N; ++a)
                    for (int r = 0; r < 3; ++r) de(r, a) = Pack([&](auto lane) { return dx(3 * p + r, nodes[static_cast<std::size_t>(a)][lane]); });
                double* to = result.col(p).data() + pack * per_cell * pack_width;
                const auto store = [&](int i, const Pack& value) { value.copy_to(to + i * pack_width, std::experimental::element_aligned); };
                for (std::size_t q = 0; q < Q; ++q) {
                    const PackStrain e = green_strain_tangent(at.F[q], deformation_gradient<N>(de, at.geometry.gradient[q]));
                    for (int i = 0; i < 6; ++i) store(6 * static_cast<int>(q) + i, e[static_cast<std::size_t>(i)]);
                }
                if constexpr (N == 8 && Q == 1)
                    if (at.hourglass) {
                        const Eigen::Matrix<Pack, 3, 4> h = hourglass_tangent(*at.hourglass, de);
                        for (int k = 0; k < 12; ++k) store(6 + k, h(k % 3, k / 3));
                    }
            }
        }
    });
    return result;
}

}  // namespace

UnitForces unit_forces(const Model& model, const Matrix3Xd& x, const VectorXd& rate) {
    assert(x.cols() == model.body->node_count());
    return std::visit([&](const auto& cells) { return unit_forces_of(cells, model, x, rate); }, model.body->cells);
}

NodalColumns gradient_columns(const Model& model, const Matrix3Xd& x, const UnitForces& forces, const std::vector<Stiffness>& stiffness,
                              const MatrixXd& rates) {
    assert(x.cols() == model.body->node_count() && (rates.size() == 0 || rates.cols() == static_cast<Index>(stiffness.size())));
    return std::visit([&](const auto& cells) { return gradients_of(cells, model, x, forces, stiffness, rates); }, model.body->cells);
}

MatrixXd strain_tangents(const Body& body, const Matrix3Xd& x, const NodalColumns& dx) {
    assert(dx.rows() % 3 == 0 && dx.cols() == body.node_count());
    return std::visit([&](const auto& cells) { return strain_tangents_of(cells, x, dx); }, body.cells);
}

}  // namespace myo
