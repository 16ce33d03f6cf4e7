#include "model/cell_means.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "material/lanes.hpp"
#include "model/cell_kernel.hpp"
#include "model/pack_model.hpp"

namespace myo::model {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::VectorXd;

namespace {

/// Integrals over the rest volume of one cell.
struct CellIntegrals {
    Matrix3d kirchhoff = Matrix3d::Zero();  // integral of P F' [J]
    double volume = 0.0;                    // integral of J [m3]
    double stretch = 0.0;                   // integral of the largest stretch [m3]
    double rest_volume = 0.0;               // [m3]
};

/// Largest principal stretch: square root of the largest eigenvalue of C = F'F.
double largest_stretch(const Matrix3d& F) {
    // Eigenvalues are ascending.
    const Eigen::SelfAdjointEigenSolver<Matrix3d> C(F.transpose() * F, Eigen::EigenvaluesOnly);
    return std::sqrt(std::max(0.0, C.eigenvalues()(2)));
}

/// Integrals of all cells of a pack.
template <class Geometry>
void add_integrals(const PackedCells<Geometry>& cells, int pack, const Model& model, const Matrix3Xd& x,
                   std::vector<CellIntegrals>& result) {
    const auto xe = nodes_of_pack(cells, pack, x);
    const PointKinematics<Geometry> points = points_of(cells, pack, model, xe);
    const PackElasticity elasticity = elasticity_of(cells, pack, model);
    ElasticPoints<Geometry> elastic(cells, pack, elasticity);
    material::Matrix3<Pack> kirchhoff = zero_tensor(),
                            mean_part = zero_tensor();  // integrals of P F' and of d theta/dF F'
    // Integral of J of the pack.
    Pack now = 0.0;
    elastic.visit(points, [&](const PointState& point) {
        const material::Matrix3<Pack> F_transposed = point.F.transpose();
        // Kirchhoff stress is P F'; its integral over the rest volume is that of the Cauchy stress over the present
        // one.
        kirchhoff += product(elastic.stress_at(point), F_transposed) * point.weight;
        if (elastic.mean()) mean_part += product(point.law.volume.gradient, F_transposed) * point.weight;
        // J from the first column of F and its cofactors.
        const material::Matrix3<Pack>& F = point.F;
        const material::Matrix3<Pack> C = material::cofactor(F);
        now += point.weight * (F(0, 0) * C(0, 0) + F(1, 0) * C(1, 0) + F(2, 0) * C(2, 0));
        for (int lane = 0; lane < cells.lanes_used(pack); ++lane)
            result[static_cast<std::size_t>(pack * pack_width + lane)]
                .stretch += static_cast<double>(point.weight[static_cast<std::size_t>(lane)]) *
                            largest_stretch(material::lane_of(F, lane));
    });
    // The mean pressure acts on all points of a cell, so it is known only after the loop.
    if (elastic.mean()) kirchhoff += mean_part * elastic.bulk_of_mean().first;
    for (int lane = 0; lane < cells.lanes_used(pack); ++lane) {
        const auto l = static_cast<std::size_t>(lane);
        CellIntegrals& cell = result[static_cast<std::size_t>(pack * pack_width + lane)];
        cell.kirchhoff = material::lane_of(kirchhoff, lane);
        cell.volume = now[l];
        cell.rest_volume = cells.geometry(pack).volume[l];
    }
}

/// Adds the fibre part of P F' [J] in each cell: d psi/ds s' with s = F m.
void add_fibres(const Model& model, const Eigen::MatrixXi& cells, const Matrix3Xd& x,
                const std::vector<double>& activation, std::vector<CellIntegrals>& result) {
    for (std::size_t g = 0; g < model.fibres->size(); ++g) {
        const fibre::FibreGroup& group = (*model.fibres)[g];
        for (const fibre::FibrePoint& point : group.points) {
            Eigen::Vector3d s = Eigen::Vector3d::Zero();
            for (Eigen::Index a = 0; a < point.shape.size(); ++a) s += point.shape(a) * x.col(cells(a, point.cell));
            result[static_cast<std::size_t>(point.cell)]
                .kirchhoff += point.volume * fibre::fibre_response(s, activation[g], group.stiffness_Pa).gradient *
                              s.transpose();
        }
    }
}

}  // namespace

CellMeans cell_means(const Model& model, const Matrix3Xd& x, const std::vector<double>& activation) {
    assert(x.cols() == model.body->node_count() && activation.size() == model.fibres->size());
    const int count = model.body->cell_count();
    std::vector<CellIntegrals> integrals(static_cast<std::size_t>(count));
    std::visit(
        [&](const auto& cells) {
            parallel_ranges(cells.pack_count(), 32, [&](int first, int end) {
                for (int pack = first; pack < end; ++pack) add_integrals(cells, pack, model, x, integrals);
            });
        },
        model.body->cells);
    add_fibres(model, model.body->mesh.cells, x, activation, integrals);
    CellMeans means{VectorXd(count), VectorXd(count), VectorXd(count)};
    for (int cell = 0; cell < count; ++cell) {
        const CellIntegrals& each = integrals[static_cast<std::size_t>(cell)];
        // Cauchy stress of the deformed cell: integral of P F' over integral of J.
        const Matrix3d cauchy = each.volume > 0.0 ? Matrix3d(each.kirchhoff / each.volume)
                                                  : Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
        means.stretch(cell) = each.stretch / each.rest_volume;
        means.pressure_Pa(cell) = -cauchy.trace() / 3.0;
        // Norm of the deviator times sqrt(3/2).
        means.von_mises_Pa(cell) = std::sqrt(1.5) * (cauchy + means.pressure_Pa(cell) * Matrix3d::Identity()).norm();
    }
    return means;
}

VectorXd at_nodes(const mesh::VolumeMesh& mesh, const VectorXd& cell_values, const VectorXd& volumes_m3) {
    VectorXd sum = VectorXd::Zero(mesh.node_count()), weight = VectorXd::Zero(mesh.node_count());
    for (Eigen::Index cell = 0; cell < mesh.cell_count(); ++cell)
        for (const int node : mesh.cells.col(cell)) {
            sum(node) += volumes_m3(cell) * cell_values(cell);
            weight(node) += volumes_m3(cell);
        }
    return (weight.array() > 0.0).select(sum.array() / weight.array(), 0.0);
}

}  // namespace myo::model
