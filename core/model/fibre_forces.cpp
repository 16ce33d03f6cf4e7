#include "model/fibre_forces.hpp"

#include "model/positive_part.hpp"

namespace myo {
namespace {

using Eigen::Matrix3Xd;

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

}  // namespace

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
