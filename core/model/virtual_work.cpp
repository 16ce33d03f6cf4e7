#include "model/virtual_work.hpp"

#include <cassert>

#include "base/parallel.hpp"
#include "model/cell_kernel.hpp"
#include "model/fibre_cells.hpp"
#include "model/pack_model.hpp"

namespace myo::model {
namespace {

using Eigen::Matrix3Xd;

/// Virtual work of one pack per unit of mu, of kappa and of damping times mu.
struct PackWork {
    Pack mu = 0.0, kappa = 0.0, viscous = 0.0;
};

template <class Geometry>
PackWork pack_work(const PackedCells<Geometry>& cells, int pack, const Model& model, const Matrix3Xd& x,
                   const Matrix3Xd& p, const StrainRate& rate) {
    const material::Material& material = *model.material;
    const PointBulk bulk = point_bulk(cells, pack, model.moduli);
    const auto xe = nodes_of_pack(cells, pack, x), pe = nodes_of_pack(cells, pack, p);
    const PointKinematics<Geometry> points = points_of(cells, pack, model, xe);
    const auto motion = points.along(pe);
    const double* history = rate.history ? rate.history->data() + pack * cells.strains_per_cell() * pack_width
                                         : nullptr;
    const double* factors = factors_of(cells, pack, model.point_factors);
    const Pack one = 1.0, zero = 0.0;  // the work is linear in the moduli
    const bool split = material.has_split();
    PackWork work;
    Pack theta = 0.0, d_theta = 0.0, mean_factor = 0.0;  // means over the cell
    material::LawResponse<Pack> law;
    for (int q = 0; q < Geometry::points; ++q) {
        const Pack factor = factors ? entry(factors, q) : one, weight = points.weight(q);
        const material::Matrix3<Pack> F = points.gradient(q), dF = points.tangent(q, motion);
        // Unit shear modulus and zero bulk modulus: the response is the derivative by mu.
        material.respond(F, factor, zero, false, law);
        work.mu += weight * material::double_dot(law.distortion.gradient, dF);
        // Laws without a split have no bulk function: their derivative by kappa is the volume gradient itself.
        const Pack change = material::double_dot(law.volume.gradient, dF);
        if (!split) {
            work.kappa += weight * factor * change;
        } else if (!cells.mean_volume) {
            work.kappa += weight * material.bulk(law.volume.value, factor).first * change;
        } else {
            const Pack share = weight / cells.geometry(pack).volume;
            theta += share * law.volume.value;
            d_theta += share * change;
            mean_factor += share * factor;
            if (!cells.point_bulk_over_mu.empty()) {
                const Pack at_point = weight * material.bulk(law.volume.value, factor).first * change;
                work.mu += bulk.of_mu * at_point;
                work.kappa += bulk.of_kappa * at_point;
            }
        }
        if (history)
            work.viscous += 2.0 * weight * factor *
                            double_dot(deviator(strain_rate(F, rate.factor, history, q)), green_strain_tangent(F, dF));
    }
    // The mean volume carries kappa minus the part that acts at the points.
    if (split && cells.mean_volume) {
        const Pack mean = cells.geometry(pack).volume * material.bulk(theta, mean_factor).first * d_theta;
        work.kappa += (1.0 - bulk.of_kappa) * mean;
        work.mu -= bulk.of_mu * mean;
    }
    return work;
}

}  // namespace

ModuliWork no_moduli_work(const Model& model) {
    const auto cells = static_cast<std::size_t>(model.body->cell_count());
    return {std::vector<material::Moduli>(cells), std::vector<double>(cells, 0.0)};
}

void add_moduli_work(const Model& model, const Matrix3Xd& x, const Matrix3Xd& p, const StrainRate& rate,
                     ModuliWork& work) {
    assert(x.cols() == model.body->node_count() && p.cols() == x.cols());
    std::visit(
        [&](const auto& cells) {
            parallel_ranges(cells.pack_count(), 16, [&](int first, int end) {
                for (int pack = first; pack < end; ++pack) {
                    // Each cell belongs to one pack, so threads write to different entries.
                    const PackWork of_pack = pack_work(cells, pack, model, x, p, rate);
                    for (int lane = 0; lane < cells.lanes_used(pack); ++lane) {
                        const auto l = static_cast<std::size_t>(lane),
                                   c = static_cast<std::size_t>(pack * pack_width + lane);
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
    for (const fibre::FibreGroup& group : *model.fibres) {
        work.by_shape.emplace_back();
        for (const fibre::FibrePoint& point : group.points)
            work.by_shape.back().push_back(Eigen::VectorXd::Zero(point.shape.size()));
    }
    return work;
}

void add_fibre_work(const Model& model, const Matrix3Xd& x, const Matrix3Xd& p, const std::vector<double>& activation,
                    FibreWork& work) {
    const Eigen::MatrixXi& cells = model.body->mesh.cells;
    for_each_fibre_cell(model, [&](auto nodes, std::size_t g, std::size_t first, std::size_t last) {
        constexpr int N = decltype(nodes)::value;
        const fibre::FibreGroup& group = (*model.fibres)[g];
        const int cell = group.points[first].cell;
        const CellVectors<N> xe = cell_vectors<N>(cells, cell, x), pe = cell_vectors<N>(cells, cell, p);
        for (std::size_t k = first; k < last; ++k) {
            const fibre::FibrePoint& point = group.points[k];
            const auto shape = shape_of<N>(point);
            const Eigen::Vector3d s = xe.transpose() * shape, ds = pe.transpose() * shape;
            // Virtual elongation of the fibre times its volume.
            const double length = s.norm(), along = s.dot(ds) / length * point.volume;
            work.by_activation[g] -= group.stiffness_Pa * along;
            work.by_stiffness[g] += (length - activation[g]) * along;
            if (work.by_shape.empty()) continue;
            const fibre::FibreResponse response = fibre::fibre_response(s, activation[g], group.stiffness_Pa);
            // Derivative of (psi'(s) . ds) with respect to the shape: s = x shape and ds = p shape.
            work.by_shape[g][k] += point.volume * (xe * (response.hessian * ds) + pe * response.gradient);
        }
    });
}

}  // namespace myo::model
