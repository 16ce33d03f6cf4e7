#include "diagnosis/missing_force/peak_energy.hpp"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace myo::diagnosis {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;

/// Per cell, nodes x 3: least-squares map from its node positions x (3 x nodes) to its mean deformation gradient.
std::vector<Eigen::MatrixX3d> mean_gradients(const mesh::VolumeMesh& mesh) {
    std::vector<Eigen::MatrixX3d> gradients;
    for (const auto& cell : mesh.cells.colwise()) {
        Matrix3Xd X = mesh.nodes(Eigen::all, cell);
        // The columns of the map then sum to zero, so that node positions need not be centred.
        X.colwise() -= Eigen::Vector3d(X.rowwise().mean());
        gradients.push_back(X.transpose() * (X * X.transpose()).inverse());
    }
    return gradients;
}

}  // namespace

double peak_isochoric_energy(const std::vector<model::Model>& models,
                             const std::vector<prediction::TrialPrediction>& predictions) {
    double peak = 0.0;
    if (models.empty()) return peak;
    const mesh::VolumeMesh& mesh = models.front().body->mesh;
    const std::vector<Eigen::MatrixX3d> gradients = mean_gradients(mesh);
    for (std::size_t i = 0; i < models.size(); ++i)
        for (std::size_t k = 0; k < predictions[i].trace.positions.size(); k += 10)
            for (Index c = 0; c < mesh.cells.cols(); ++c) {
                const Matrix3Xd x = predictions[i].trace.positions[k](Eigen::all, mesh.cells.col(c));
                const Matrix3d F = x * gradients[static_cast<std::size_t>(c)];
                const double J = F.determinant();
                // I1 of the isochoric part, J^(-2/3) tr(F'F); inverted cells have none.
                if (J > 0.0)
                    peak = std::max(peak, 0.5 * models[i].moduli[static_cast<std::size_t>(c)].mu *
                                              (F.squaredNorm() / std::cbrt(J * J) - 3.0));
            }
    return peak;
}

}  // namespace myo::diagnosis
