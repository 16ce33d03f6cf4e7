#include "model/cell_means.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"

namespace myo {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::VectorXd;

namespace {

/// Integrals over the rest cell.
struct CellIntegrals {
    Matrix3d kirchhoff = Matrix3d::Zero();   // of P F' [J]
    double volume = 0.0;                     // of J [m3]
    double stretch = 0.0;                    // of the largest stretch [m3]
};

double largest_stretch(const Matrix3d& F) {
    const Eigen::SelfAdjointEigenSolver<Matrix3d> C(F.transpose() * F, Eigen::EigenvaluesOnly);
    return std::sqrt(std::max(0.0, C.eigenvalues()(2)));
}

template <int N, int Q>
CellIntegrals integrals_of(const ElementBlock<N, Q>& block, int cell, const Model& model, const Matrix3Xd& x) {
    const Material& law = *model.material;
    const Moduli& moduli = model.moduli[static_cast<std::size_t>(cell)];
    const CellGeometry<N, Q>& geometry = block.geometry[static_cast<std::size_t>(cell)];
    Eigen::Matrix<double, 3, N> nodes;
    for (int a = 0; a < N; ++a) nodes.col(a) = x.col(block.cells(a, cell));
    const bool mean = block.mean_volume && law.has_split();
    // As the forces share it out: see ElementBlock::most_point_bulk_over_mu.
    const double point_kappa = mean ? std::min(moduli.kappa, block.most_point_bulk_over_mu * moduli.mu) : moduli.kappa;
    CellIntegrals result;
    Matrix3d mean_part = Matrix3d::Zero();   // of d theta/dF F'
    double mean_theta = 0.0;
    LawResponse<double> response;
    for (std::size_t q = 0; q < Q; ++q) {
        const double weight = geometry.weight[q];
        const Matrix3d F = nodes * geometry.gradient[q];
        law.respond(F, moduli.mu, moduli.kappa, false, response);
        Matrix3d P = response.distortion.gradient;
        if (law.has_split() && (!mean || point_kappa > 0.0)) P += law.bulk(response.volume.value, point_kappa).first * response.volume.gradient;
        if (mean) {
            mean_theta += weight / geometry.volume * response.volume.value;
            mean_part += weight * response.volume.gradient * F.transpose();
        }
        result.kirchhoff += weight * P * F.transpose();
        result.volume += weight * F.determinant();
        result.stretch += weight * largest_stretch(F);
    }
    if (mean) result.kirchhoff += law.bulk(mean_theta, moduli.kappa - point_kappa).first * mean_part;
    return result;
}

/// Of the fibres, P F' = d psi/ds s' with s = F m, in every cell [J].
void add_fibres(const Model& model, const Eigen::MatrixXi& cells, const Matrix3Xd& x, const std::vector<double>& activation, std::vector<CellIntegrals>& result) {
    for (std::size_t g = 0; g < model.fibres->size(); ++g) {
        const FibreGroup& group = (*model.fibres)[g];
        for (const FibrePoint& point : group.points) {
            Eigen::Vector3d s = Eigen::Vector3d::Zero();
            for (Eigen::Index a = 0; a < point.shape.size(); ++a) s += point.shape(a) * x.col(cells(a, point.cell));
            result[static_cast<std::size_t>(point.cell)].kirchhoff += point.volume * fibre_response(s, activation[g], group.stiffness_Pa).gradient * s.transpose();
        }
    }
}

}  // namespace

CellMeans cell_means(const Model& model, const Elements& elements, const Matrix3Xd& x, const std::vector<double>& activation) {
    assert(x.cols() == model.body->node_count() && activation.size() == model.fibres->size());
    const int count = model.body->cell_count();
    std::vector<CellIntegrals> integrals(static_cast<std::size_t>(count));
    VectorXd rest_volume(count);
    std::visit([&](const auto& block) {
        assert(block.cell_count() == count);
        parallel_ranges(count, 256, [&](int first, int end) {
            for (int cell = first; cell < end; ++cell) {
                integrals[static_cast<std::size_t>(cell)] = integrals_of(block, cell, model, x);
                rest_volume(cell) = block.geometry[static_cast<std::size_t>(cell)].volume;
            }
        });
    }, elements);
    add_fibres(model, model.body->mesh.cells, x, activation, integrals);
    CellMeans means{VectorXd(count), VectorXd(count), VectorXd(count)};
    for (int cell = 0; cell < count; ++cell) {
        const CellIntegrals& each = integrals[static_cast<std::size_t>(cell)];
        const Matrix3d cauchy = each.volume > 0.0 ? Matrix3d(each.kirchhoff / each.volume) : Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
        means.stretch(cell) = each.stretch / rest_volume(cell);
        means.pressure_Pa(cell) = -cauchy.trace() / 3.0;
        means.von_mises_Pa(cell) = std::sqrt(1.5) * (cauchy + means.pressure_Pa(cell) * Matrix3d::Identity()).norm();
    }
    return means;
}

VectorXd at_nodes(const VolumeMesh& mesh, const VectorXd& cell_values, const VectorXd& volumes_m3) {
    VectorXd sum = VectorXd::Zero(mesh.node_count()), weight = VectorXd::Zero(mesh.node_count());
    for (Eigen::Index cell = 0; cell < mesh.cell_count(); ++cell)
        for (const int node : mesh.cells.col(cell)) {
            sum(node) += volumes_m3(cell) * cell_values(cell);
            weight(node) += volumes_m3(cell);
        }
    return (weight.array() > 0.0).select(sum.array() / weight.array(), 0.0);
}

}  // namespace myo
