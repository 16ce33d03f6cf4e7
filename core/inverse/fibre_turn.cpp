#include "inverse/fibre_turn.hpp"

#include <array>
#include <cassert>
#include <cmath>
#include <utility>

#include "measurement/rigid_motion.hpp"
#include "mesh/cell_traits.hpp"

namespace myo::inverse {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// Legendre polynomials of degree 0 ... degree at x, and their derivatives.
struct Legendre {
    std::vector<double> value, slope;
};
Legendre legendre(int degree, double x) {
    Legendre p{{1.0}, {0.0}};
    for (int n = 1; n <= degree; ++n) {
        const auto k = static_cast<std::size_t>(n);
        const double before = n > 1 ? p.value[k - 2] : 0.0, slope_before = n > 1 ? p.slope[k - 2] : 0.0;
        p.value.push_back(((2 * n - 1) * x * p.value[k - 1] - (n - 1) * before) / n);
        p.slope.push_back(slope_before + (2 * n - 1) * p.value[k - 1]);
    }
    return p;
}

/// Degrees in x, y, z of the products of total degree up to `degree`.
std::vector<std::array<int, 3>> product_degrees(int degree) {
    std::vector<std::array<int, 3>> products;
    for (int i = 0; i <= degree; ++i)
        for (int j = 0; i + j <= degree; ++j)
            for (int k = 0; i + j + k <= degree; ++k) products.push_back({i, j, k});
    return products;
}

Vector3d corner_mean(const mesh::VolumeMesh& mesh, int cell) {
    const int corners = mesh::cell_traits(mesh.type).corners;
    Vector3d sum = Vector3d::Zero();
    for (int a = 0; a < corners; ++a) sum += mesh.nodes.col(mesh.cells(a, cell));
    return sum / corners;
}

/// Polynomials at the centres of cells, constant within each cell as painted directions are.
struct Basis {
    MatrixXd values;     // polynomials x points
    MatrixXd roughness;  // polynomials x polynomials: mean of the products of their gradients, times the diagonal^2
};
Basis basis_of(const mesh::VolumeMesh& mesh, const fibre::FibreGroup& fibres, TurnField field) {
    const auto count = static_cast<Index>(fibres.points.size());
    Matrix3Xd places(3, count);
    for (Index k = 0; k < count; ++k)
        places.col(k) = corner_mean(mesh, fibres.points[static_cast<std::size_t>(k)].cell);
    const Vector3d low = places.rowwise().minCoeff(), size = places.rowwise().maxCoeff() - low;
    const double diagonal = size.norm();
    const std::vector<std::array<int, 3>> products = product_degrees(
        field == TurnField::smooth ? fibre_turn_policy.degree : 0);
    const auto terms = static_cast<Index>(products.size());
    Basis basis{MatrixXd(terms, count), MatrixXd::Zero(terms, terms)};
    MatrixXd slopes(terms, 3);
    for (Index k = 0; k < count; ++k) {
        std::array<Legendre, 3> axes;
        Vector3d per_metre = Vector3d::Zero();  // of the local coordinate, -1 ... 1; 0 across a single layer of cells
        for (int axis = 0; axis < 3; ++axis) {
            if (size(axis) > 0.0) per_metre(axis) = 2.0 / size(axis);
            const double x = (places(axis, k) - low(axis)) * per_metre(axis) - (size(axis) > 0.0 ? 1.0 : 0.0);
            axes[static_cast<std::size_t>(axis)] = legendre(fibre_turn_policy.degree, x);
        }
        for (Index t = 0; t < terms; ++t) {
            const std::array<int, 3>& degrees = products[static_cast<std::size_t>(t)];
            const auto factor = [&](std::size_t axis, bool slope) {
                const auto degree = static_cast<std::size_t>(degrees[axis]);
                return slope ? axes[axis].slope[degree] : axes[axis].value[degree];
            };
            basis.values(t, k) = factor(0, false) * factor(1, false) * factor(2, false);
            for (std::size_t axis = 0; axis < 3; ++axis)
                slopes(t, static_cast<Index>(axis)) = diagonal * per_metre(static_cast<Index>(axis)) *
                                                      factor(0, axis == 0) * factor(1, axis == 1) *
                                                      factor(2, axis == 2);
        }
        basis.roughness += slopes * slopes.transpose() / static_cast<double>(count);
    }
    return basis;
}

class FibreTurn : public DesignVariable {
public:
    FibreTurn(const mesh::VolumeMesh& mesh, std::size_t group, const fibre::FibreGroup& fibres, TurnField field)
        : name_(fibres.name), group_(group), basis_(basis_of(mesh, fibres, field)) {
        assert(fibres.gradients.size() == fibres.points.size());
    }

    std::string name() const override { return "fibre direction of " + name_; }
    VectorXd declared() const override { return VectorXd::Zero(3 * basis_.values.rows()); }
    DesignRange range() const override {
        const VectorXd most = VectorXd::Constant(declared().size(), fibre_turn_policy.most_rad);
        return {-most, most, 1.0};
    }
    void apply(const VectorXd& values, model::Model& model) const override {
        auto fibres = std::make_shared<std::vector<fibre::FibreGroup>>(*model.fibres);
        fibre::FibreGroup& group = (*fibres)[group_];
        assert(static_cast<Index>(group.points.size()) == basis_.values.cols());
        for (std::size_t k = 0; k < group.points.size(); ++k)
            group.points[k].shape = group.gradients[k] *
                                    (measurement::small_rotation(theta(values, k)) * fibre::direction_of(group, k));
        model.fibres = std::move(fibres);
    }
    VectorXd gradient(const VectorXd& values, const model::Model& model,
                      const sensitivity::ModelGradient& gradient) const override {
        const fibre::FibreGroup& group = (*model.fibres)[group_];
        Matrix3Xd by_term = Matrix3Xd::Zero(3, basis_.values.rows());
        for (std::size_t k = 0; k < group.points.size(); ++k) {
            const Vector3d by_direction = group.gradients[k].transpose() * gradient.fibre_shape[group_][k],
                           turn = theta(values, k),
                           declared = measurement::small_rotation(-turn) * fibre::direction_of(group, k),
                           by_theta = measurement::d_rotated_d_omega(turn, declared).transpose() * by_direction;
            by_term += by_theta * basis_.values.col(static_cast<Index>(k)).transpose();
        }
        return by_term.reshaped();
    }
    bool changes_fibres() const override { return true; }
    double roughness(const VectorXd& values, double weight, VectorXd& gradient) const override {
        const Eigen::Map<const Matrix3Xd> terms(values.data(), 3, basis_.values.rows());
        const Matrix3Xd product = terms * basis_.roughness;
        gradient += 2.0 * weight * product.reshaped();
        return product.cwiseProduct(terms).sum();
    }

private:
    Vector3d theta(const VectorXd& values, std::size_t point) const {
        const Eigen::Map<const Matrix3Xd> terms(values.data(), 3, basis_.values.rows());
        return terms * basis_.values.col(static_cast<Index>(point));
    }

    std::string name_;
    std::size_t group_;
    Basis basis_;
};

}  // namespace

DesignVariablePointer fibre_turn(const mesh::VolumeMesh& mesh, std::size_t group, const fibre::FibreGroup& fibres,
                                 TurnField field) {
    return std::make_shared<FibreTurn>(mesh, group, fibres, field);
}

}  // namespace myo::inverse
