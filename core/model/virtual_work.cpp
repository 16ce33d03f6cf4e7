#include "model/virtual_work.hpp"

#include <cassert>

#include "base/parallel.hpp"
#include "model/cell_kernel.hpp"
#include "model/fibre_cells.hpp"

namespace myo {
namespace {

using Eigen::Matrix3Xd;

/// Work of one pack per unit of mu, of kappa and of damping times mu.
struct PackWork {
    Pack mu = 0.0, kappa = 0.0, viscous = 0.0;
};

/// dev(rate) : dE.
Pack deviatoric_product(const PackStrain& rate, const PackStrain& e) {
    const Matrix3<Pack> D = deviator(rate);
    return D(0, 0) * e[0] + D(1, 1) * e[1] + D(2, 2) * e[2] + 2.0 * (D(0, 1) * e[3] + D(1, 2) * e[4] + D(2, 0) * e[5]);
}

void add_hourglass_work(const Eigen::Matrix<Pack, 3, 8>& x, const Eigen::Matrix<Pack, 3, 8>& p, const Eigen::Matrix<Pack, 8, 3>& G,
                        const PackHourglass& geometry, const Pack& volume, double rate_factor, const double* rate_history, PackWork& work) {
    using Shapes = Eigen::Matrix<Pack, 3, 4>;
    const HourglassStrain h = hourglass_strain(x, G, geometry);
    const auto in_frame = [&](const Shapes& at) {
        Shapes result;
        for (int s = 0; s < 4; ++s)
            for (int i = 0; i < 3; ++i) result(i, s) = geometry.frame(0, i) * at(0, s) + geometry.frame(1, i) * at(1, s) + geometry.frame(2, i) * at(2, s);
        return result;
    };
    const Shapes response = HourglassStiffness(geometry, volume).apply(in_frame(hourglass_tangent(h, p)));
    const auto product_with = [&](const Shapes& strain) {
        const Shapes local = in_frame(strain);
        Pack sum = 0.0;
        for (int k = 0; k < 12; ++k) sum += local(k % 3, k / 3) * response(k % 3, k / 3);
        return sum;
    };
    work.mu += product_with(h.strain);
    if (!rate_history) return;
    Shapes rate;
    for (int s = 0; s < 4; ++s)
        for (int i = 0; i < 3; ++i) rate(i, s) = rate_factor * h.strain(i, s) + load_pack(entry(rate_history, 6 + i + 3 * s));
    work.viscous += product_with(rate);
}

template <int N, int Q>
PackWork pack_work(const PackedCells<N, Q>& cells, int pack, const Material& material, const PointBulk& bulk, const Matrix3Xd& x, const Matrix3Xd& p,
                   const StrainRate& rate) {
    const PackGeometry<N, Q>& geometry = cells.geometry[static_cast<std::size_t>(pack)];
    const auto& nodes = cells.lane_nodes[static_cast<std::size_t>(pack)];
    const auto xe = gather_lanes<N>(nodes, x), pe = gather_lanes<N>(nodes, p);
    const double* history = rate.history ? rate.history->data() + pack * cells.strains_per_cell() * pack_width : nullptr;
    const Pack one = 1.0, zero = 0.0;   // the work is linear in the moduli
    const bool split = material.has_split();
    PackWork work;
    Pack theta = 0.0, d_theta = 0.0;   // means over the cell
    LawResponse<Pack> law;
    for (int q = 0; q < Q; ++q) {
        const auto& G = geometry.gradient[static_cast<std::size_t>(q)];
        const Pack weight = geometry.weight[static_cast<std::size_t>(q)];
        const Matrix3<Pack> F = deformation_gradient<N>(xe, G), dF = deformation_gradient<N>(pe, G);
        material.respond(F, one, zero, false, law);
        work.mu += weight * double_dot(law.distortion.gradient, dF);
        if (split) {
            const Pack change = double_dot(law.volume.gradient, dF);
            if (cells.mean_volume) {
                const Pack share = weight / geometry.volume;
                theta += share * law.volume.value;
                d_theta += share * change;
                if (cells.most_point_bulk_over_mu != 0.0) {
                    const Pack at_point = weight * material.bulk(law.volume.value, one).first * change;
                    work.mu += bulk.of_mu * at_point;
                    work.kappa += bulk.of_kappa * at_point;
                }
            } else {
                work.kappa += weight * material.bulk(law.volume.value, one).first * change;
            }
        } else {
            work.kappa += weight * double_dot(law.volume.gradient, dF);
        }
        if (history) {
            PackStrain e = green_strain(F);
            for (int i = 0; i < 6; ++i) {
                Pack& r = e[static_cast<std::size_t>(i)];
                r = rate.factor * r + load_pack(entry(history, 6 * q + i));
            }
            work.viscous += 2.0 * weight * deviatoric_product(e, green_strain_tangent(F, dF));
        }
    }
    if (split && cells.mean_volume) {
        const Pack mean = geometry.volume * material.bulk(theta, one).first * d_theta;
        work.kappa += (1.0 - bulk.of_kappa) * mean;
        work.mu -= bulk.of_mu * mean;
    }
    if constexpr (N == 8 && Q == 1)
        if (!cells.hourglass.empty())
            add_hourglass_work(xe, pe, geometry.gradient[0], cells.hourglass[static_cast<std::size_t>(pack)], geometry.volume, rate.factor, history, work);
    return work;
}

}  // namespace

ModuliWork no_moduli_work(const Model& model) {
    const auto cells = static_cast<std::size_t>(model.body->cell_count());
    return {std::vector<Moduli>(cells), std::vector<double>(cells, 0.0)};
}

void add_moduli_work(const Model& model, const Matrix3Xd& x, const Matrix3Xd& p, const StrainRate& rate, ModuliWork& work) {
    assert(x.cols() == model.body->node_count() && p.cols() == x.cols());
    std::visit(
        [&](const auto& cells) {
            parallel_ranges(cells.pack_count(), 16, [&](int first, int end) {
                for (int pack = first; pack < end; ++pack) {
                    const PackWork of_pack = pack_work(cells, pack, *model.material, point_bulk(cells, pack, model.moduli), x, p, rate);
                    for (int lane = 0; lane < cells.lanes_used(pack); ++lane) {
                        const auto l = static_cast<std::size_t>(lane), c = static_cast<std::size_t>(pack * pack_width + lane);
                        work.elastic[c].mu += of_pack.mu[l];
                        work.elastic[c].kappa += of_pack.kappa[l];
                        work.viscous[c] += of_pack.viscous[l];
                    }
                }
            });
        },
        model.body->cells);
}

FibreWork no_fibre_work(const Model& model, bool with_shapes) {
    FibreWork work;
    work.by_activation.assign(model.fibres->size(), 0.0);
    work.by_stiffness.assign(model.fibres->size(), 0.0);
    if (!with_shapes) return work;
    for (const FibreGroup& group : *model.fibres) {
        work.by_shape.emplace_back();
        for (const FibrePoint& point : group.points) work.by_shape.back().push_back(Eigen::VectorXd::Zero(point.shape.size()));
    }
    return work;
}

void add_fibre_work(const Model& model, const Matrix3Xd& x, const Matrix3Xd& p, const std::vector<double>& activation, FibreWork& work) {
    const Eigen::MatrixXi& cells = model.body->mesh.cells;
    for_each_fibre_cell(model, [&](auto nodes, std::size_t g, std::size_t first, std::size_t last) {
        constexpr int N = decltype(nodes)::value;
        const FibreGroup& group = (*model.fibres)[g];
        const int cell = group.points[first].cell;
        const CellVectors<N> xe = cell_vectors<N>(cells, cell, x), pe = cell_vectors<N>(cells, cell, p);
        for (std::size_t k = first; k < last; ++k) {
            const FibrePoint& point = group.points[k];
            const auto shape = shape_of<N>(point);
            const Eigen::Vector3d s = xe.transpose() * shape, ds = pe.transpose() * shape;
            const double length = s.norm(), along = s.dot(ds) / length * point.volume;
            work.by_activation[g] -= group.stiffness_Pa * along;
            work.by_stiffness[g] += (length - activation[g]) * along;
            if (work.by_shape.empty()) continue;
            const FibreResponse response = fibre_response(s, activation[g], group.stiffness_Pa);
            work.by_shape[g][k] += point.volume * (xe * (response.hessian * ds) + pe * response.gradient);
        }
    });
}

}  // namespace myo
