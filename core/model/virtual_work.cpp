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

/// Work of the forces of a pack along nodal motions p, per unit of its moduli.
template <class Geometry>
PackWork pack_work(const PackedCells<Geometry>& cells, int pack, const Model& model, const Matrix3Xd& x,
                   const Matrix3Xd& p, const StrainRate& rate) {
    const auto xe = nodes_of_pack(cells, pack, x), pe = nodes_of_pack(cells, pack, p);
    const PointKinematics<Geometry> points = points_of(cells, pack, model, xe);
    const auto motion = points.along(pe);
    const double* history = rate.history ? rate.history->data() + pack * cells.strains_per_cell() * pack_width
                                         : nullptr;
    // The work is linear in the moduli: the response for unit mu and zero kappa is its derivative by mu.
    const PointBulk bulk = point_bulk(cells, pack, model.moduli);
    const PackElasticity unit{model.material.get(), 1.0, 0.0, bulk, factors_of(cells, pack, model.point_factors)};
    ElasticPoints<Geometry> elastic(cells, pack, unit);
    PackWork work;
    Pack mean_change = 0.0;
    elastic.visit(points, [&](const PointState& point) {
        const material::Matrix3<Pack> dF = points.tangent(point.q, motion);
        work.mu += point.weight * material::double_dot(point.law.distortion.gradient, dF);
        // Laws without a split have no bulk function: their derivative by kappa is the volume gradient itself.
        const Pack change = material::double_dot(point.law.volume.gradient, dF);
        // Change of the mean volume measure of the cell, as its points are passed.
        if (elastic.mean()) mean_change += point.share * change;
        if (!elastic.split()) {
            work.kappa += point.weight * point.factor * change;
        } else if (elastic.at_points()) {
            const Pack at_point = point.weight * unit.law->bulk(point.law.volume.value, point.factor).first * change;
            work.mu += (elastic.mean() ? bulk.of_mu : Pack(0.0)) * at_point;
            work.kappa += (elastic.mean() ? bulk.of_kappa : Pack(1.0)) * at_point;
        }
        if (history)
            work.viscous += 2.0 * point.weight * point.factor *
                            double_dot(deviator(strain_rate(point.F, rate.factor, history, point.q)),
                                       green_strain_tangent(point.F, dF));
    });
    // The mean volume carries kappa minus the part that acts at the points.
    if (elastic.mean()) {
        const Pack mean = cells.geometry(pack).volume * elastic.unit_bulk_of_mean().first * mean_change;
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

FibreWork no_fibre_work(const Model& model, bool at_points) {
    FibreWork work;
    work.by_activation.assign(model.fibres->size(), 0.0);
    work.by_stiffness.assign(model.fibres->size(), 0.0);
    if (!at_points) return work;
    for (const fibre::FibreGroup& group : *model.fibres) {
        work.by_volume.emplace_back(group.points.size(), 0.0);
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
            const double length = s.norm(), elongation = s.dot(ds) / length, along = elongation * point.volume;
            work.by_activation[g] -= group.stiffness_Pa * along;
            work.by_stiffness[g] += (length - activation[g]) * along;
            if (work.by_shape.empty()) continue;
            const fibre::FibreResponse response = fibre::fibre_response(s, activation[g], group.stiffness_Pa);
            // Derivative of (psi'(s) . ds) with respect to the shape: s = x shape and ds = p shape.
            work.by_volume[g][k] += group.stiffness_Pa * (length - activation[g]) * elongation;
            work.by_shape[g][k] += point.volume * (xe * (response.hessian * ds) + pe * response.gradient);
        }
    });
}

}  // namespace myo::model
