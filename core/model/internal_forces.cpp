#include "model/internal_forces.hpp"

#include <Eigen/Eigenvalues>

#include <cassert>

#include "model/cell_kernel.hpp"

namespace myo {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

template <int N>
Eigen::Matrix<double, 3, N> cell_columns(const Eigen::MatrixXi& cells, int cell, const Matrix3Xd& x) {
    Eigen::Matrix<double, 3, N> columns;
    for (int a = 0; a < N; ++a) columns.col(a) = x.col(cells(a, cell));
    return columns;
}

/// Of any size at run time: this path is rare, and fixed sizes would cost minutes of compilation.
void project_positive(Eigen::Ref<Eigen::MatrixXd> K) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(K);
    if (eigen.eigenvalues()(0) >= 0.0) return;
    K = eigen.eigenvectors() * eigen.eigenvalues().cwiseMax(0.0).asDiagonal() * eigen.eigenvectors().transpose();
}

CellInput cell_input(const Model& model, const InternalInput& input, int cell, int strains_per_cell) {
    const auto c = static_cast<std::size_t>(cell);
    CellInput in;
    in.material = model.material.get();
    if (!input.stiffness->elastic.empty()) in.elastic = &input.stiffness->elastic[c];
    if (!input.stiffness->viscous.empty() && input.rate.history != nullptr) {
        in.viscous = &input.stiffness->viscous[c];
        in.rate_factor = input.rate.factor;
        in.rate_history = input.rate.history->data() + cell * strains_per_cell;
    }
    if (input.pressure) in.pressure = input.pressure->data() + cell * model.body->volume_points_per_cell;
    return in;
}

template <bool WithHessian, int N, int Q>
void add_cells(const ElementBlock<N, Q>& block, const Model& model, const Matrix3Xd& x, const InternalInput& input, bool positive,
               InternalEnergy& out) {
    CellOutput<N> cell;
    for (int c = 0; c < block.cell_count(); ++c) {
        const CellInput in = cell_input(model, input, c, block.strains_per_cell());
        evaluate_cell<WithHessian>(block, c, cell_columns<N>(block.cells, c, x), in, cell);
        out.energy += cell.energy;
        for (int a = 0; a < N; ++a) out.gradient.col(block.cells(a, c)) += cell.gradient.col(a);
        if constexpr (WithHessian) {
            if (positive && cell.hessian.allFinite()) project_positive(cell.hessian);
            for (int b = 0; b < N; ++b)
                for (int a = 0; a < N; ++a)
                    model.body->pattern.add(out.hessian, block.cells, c, a, b, cell.hessian.template block<3, 3>(3 * a, 3 * b));
        }
    }
}

/// Visits every fibre point with its stretch vector s = F m.
template <class Visit>
void for_each_fibre_point(const Model& model, const Matrix3Xd& x, const Visit& visit) {
    const Eigen::MatrixXi& cells = model.body->mesh.cells;
    for (std::size_t g = 0; g < model.fibres->size(); ++g)
        for (const FibrePoint& point : (*model.fibres)[g].points) {
            Eigen::Vector3d s = Eigen::Vector3d::Zero();
            for (int a = 0; a < point.shape.size(); ++a) s += point.shape(a) * x.col(cells(a, point.cell));
            visit(g, point, s);
        }
}

void add_fibres(const Model& model, const Matrix3Xd& x, const std::vector<double>& activation, HessianKind kind, InternalEnergy& out) {
    const Eigen::MatrixXi& cells = model.body->mesh.cells;
    for_each_fibre_point(model, x, [&](std::size_t g, const FibrePoint& point, const Eigen::Vector3d& s) {
        FibreResponse response = fibre_response(s, activation[g], (*model.fibres)[g].stiffness_Pa);
        out.energy += point.volume * response.energy;
        const auto nodes = static_cast<int>(point.shape.size());
        for (int a = 0; a < nodes; ++a) out.gradient.col(cells(a, point.cell)) += point.volume * point.shape(a) * response.gradient;
        if (kind == HessianKind::none) return;
        if (kind == HessianKind::positive) project_positive(response.hessian);
        for (int b = 0; b < nodes; ++b)
            for (int a = 0; a < nodes; ++a)
                model.body->pattern.add(out.hessian, cells, point.cell, a, b,
                                        Eigen::Matrix3d(point.volume * point.shape(a) * point.shape(b) * response.hessian));
    });
}

/// theta of each volume point and its derivative along dx (zero when dx is null).
template <int N, int Q>
void volume_points(const ElementBlock<N, Q>& block, const Material& material, const Matrix3Xd& x, const Matrix3Xd* dx,
                   VectorXd& theta, VectorXd& d_theta) {
    const int per_cell = block.mean_volume ? 1 : Q;
    theta.setZero(block.cell_count() * per_cell);
    d_theta.setZero(theta.size());
    for (int c = 0; c < block.cell_count(); ++c) {
        const auto& geometry = block.geometry[static_cast<std::size_t>(c)];
        const auto xe = cell_columns<N>(block.cells, c, x);
        Eigen::Matrix<double, 3, N> de = Eigen::Matrix<double, 3, N>::Zero();
        if (dx) de = cell_columns<N>(block.cells, c, *dx);
        for (int q = 0; q < Q; ++q) {
            const auto& G = geometry.gradient[static_cast<std::size_t>(q)];
            const TensorFunction measure = material.volume_measure(xe * G, false);
            const double share = block.mean_volume ? geometry.weight[static_cast<std::size_t>(q)] / geometry.volume : 1.0;
            const int point = c * per_cell + (block.mean_volume ? 0 : q);
            theta(point) += share * measure.value;
            d_theta(point) += share * measure.gradient.cwiseProduct(de * G).sum();
        }
    }
}

VectorXd bulk_pressures(const Model& model, const Matrix3Xd& x, const Matrix3Xd* dx) {
    VectorXd theta, d_theta;
    double point_bulk_over_mu = 0.0;
    std::visit(
        [&](const auto& block) {
            volume_points(block, *model.material, x, dx, theta, d_theta);
            if (block.mean_volume) point_bulk_over_mu = block.point_bulk_over_mu;
        },
        model.body->elements);
    VectorXd p(theta.size());
    for (int i = 0; i < p.size(); ++i) {
        const auto cell = static_cast<std::size_t>(i / model.body->volume_points_per_cell);
        const Moduli& m = model.moduli[cell];
        const ScalarFunction U = model.material->bulk(theta(i), m.kappa - point_bulk_over_mu * m.mu);
        p(i) = U.first + U.second * d_theta(i);
    }
    return p;
}

/// Strains of every cell at x, or their derivative along dx when dx is given.
template <int N, int Q>
void collect_strains(const ElementBlock<N, Q>& block, const Matrix3Xd& x, const Matrix3Xd* dx, VectorXd& result) {
    const int per_cell = block.strains_per_cell();
    result.resize(block.cell_count() * per_cell);
    for (int c = 0; c < block.cell_count(); ++c) {
        const auto& geometry = block.geometry[static_cast<std::size_t>(c)];
        const auto xe = cell_columns<N>(block.cells, c, x);
        Eigen::Matrix<double, 3, N> de = Eigen::Matrix<double, 3, N>::Zero();
        if (dx) de = cell_columns<N>(block.cells, c, *dx);
        for (int q = 0; q < Q; ++q) {
            const auto& G = geometry.gradient[static_cast<std::size_t>(q)];
            const Eigen::Matrix3d F = xe * G;
            Eigen::Matrix<double, 6, 1> e = green_strain(F);
            if (dx) {
                const Eigen::Matrix3d H = F.transpose() * (de * G);
                const Eigen::Matrix3d S = 0.5 * (H + H.transpose());
                e << S(0, 0), S(1, 1), S(2, 2), S(0, 1), S(1, 2), S(2, 0);
            }
            result.segment<6>(c * per_cell + 6 * q) = e;
        }
        if constexpr (N == 8 && Q == 1)
            if (!block.hourglass.empty()) {
                const HourglassStrain h = hourglass_strain(xe, geometry.gradient[0], block.hourglass[static_cast<std::size_t>(c)]);
                const Matrix34d value = dx ? Matrix34d(h.F_inverse * de * h.Gamma) : h.strain;
                result.segment<12>(c * per_cell + 6) = Eigen::Map<const Eigen::Matrix<double, 12, 1>>(value.data());
            }
    }
}

}  // namespace

Stiffness stiffness(const Model& model) {
    Stiffness s;
    s.elastic = model.moduli;
    if (model.damping_s > 0.0) {
        s.viscous = model.moduli;
        for (Moduli& m : s.viscous) m = {m.mu * model.damping_s, m.kappa * model.damping_s};
    }
    return s;
}

InternalEnergy internal_energy(const Model& model, const Matrix3Xd& x, const InternalInput& input, HessianKind kind) {
    assert(x.cols() == model.body->node_count() && input.stiffness != nullptr);
    InternalEnergy out;
    out.gradient = Matrix3Xd::Zero(3, x.cols());
    if (kind != HessianKind::none) out.hessian = model.body->pattern.zero;
    const bool positive = kind == HessianKind::positive;
    std::visit(
        [&](const auto& block) {
            if (kind == HessianKind::none) add_cells<false>(block, model, x, input, positive, out);
            else add_cells<true>(block, model, x, input, positive, out);
        },
        model.body->elements);
    if (input.stiffness->fibres && !model.fibres->empty()) {
        assert(input.activation != nullptr && input.activation->size() == model.fibres->size());
        add_fibres(model, x, *input.activation, kind, out);
    }
    return out;
}

VectorXd pressures(const Model& model, const Matrix3Xd& x) { return bulk_pressures(model, x, nullptr); }

VectorXd predicted_pressures(const Model& model, const Matrix3Xd& x, const Matrix3Xd& dx) { return bulk_pressures(model, x, &dx); }

VectorXd strains(const Body& body, const Matrix3Xd& x) {
    VectorXd result;
    std::visit([&](const auto& block) { collect_strains(block, x, nullptr, result); }, body.elements);
    return result;
}

VectorXd strain_tangent(const Body& body, const Matrix3Xd& x, const Matrix3Xd& dx) {
    VectorXd result;
    std::visit([&](const auto& block) { collect_strains(block, x, &dx, result); }, body.elements);
    return result;
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

Matrix3Xd activation_gradient(const Model& model, const Matrix3Xd& x, const std::vector<double>& activation,
                              const std::vector<double>& d_activation) {
    Matrix3Xd gradient = Matrix3Xd::Zero(3, x.cols());
    const Eigen::MatrixXi& cells = model.body->mesh.cells;
    for_each_fibre_point(model, x, [&](std::size_t g, const FibrePoint& point, const Eigen::Vector3d& s) {
        const FibreResponse response = fibre_response(s, activation[g], (*model.fibres)[g].stiffness_Pa);
        for (int a = 0; a < point.shape.size(); ++a)
            gradient.col(cells(a, point.cell)) += d_activation[g] * point.volume * point.shape(a) * response.gradient_activation;
    });
    return gradient;
}

}  // namespace myo
