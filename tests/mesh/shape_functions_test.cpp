#include <gtest/gtest.h>

#include "mesh/cells.hpp"
#include "support/differences.hpp"
#include "support/hex20.hpp"

namespace myo::mesh {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

template <class Shape>
struct Nodes;
template <>
struct Nodes<Hex8> {
    static Vector3d at(int a) { return Hex8::corners().row(a); }
};
template <>
struct Nodes<Tet4> {
    static Vector3d at(int a) { return a == 0 ? Vector3d::Zero() : Vector3d(Vector3d::Unit(a - 1)); }
};
template <>
struct Nodes<Tet10> {
    static Vector3d at(int a) {
        if (a < 4) return Nodes<Tet4>::at(a);
        const auto& edge = mesh::tetrahedron_edges[static_cast<std::size_t>(
            a - 4)];  // the mesh's numbering, not the element's own
        return 0.5 * (Nodes<Tet4>::at(edge[0]) + Nodes<Tet4>::at(edge[1]));
    }
};

template <>
struct Nodes<test::Hex20> {
    static Vector3d at(int a) { return test::Hex20::places().row(a); }
};

template <class Shape>
class ShapeFunctions : public testing::Test {};
using Shapes = testing::Types<Hex8, Tet4, Tet10, test::Hex20>;
TYPED_TEST_SUITE(ShapeFunctions, Shapes);

TYPED_TEST(ShapeFunctions, AreOneAtTheirNodeAndZeroAtTheOthers) {
    for (int b = 0; b < TypeParam::nodes; ++b) {
        const VectorXd N = TypeParam::values(Nodes<TypeParam>::at(b));
        EXPECT_LT((N - VectorXd::Unit(TypeParam::nodes, b)).norm(), 1e-15) << b;
    }
}

TYPED_TEST(ShapeFunctions, SumToOneAndReproduceLinearFields) {
    for (const Vector3d& xi : {Vector3d(0.1, 0.2, 0.3), Vector3d(0.4, 0.05, 0.15), Vector3d(0.25, 0.25, 0.25)}) {
        const VectorXd N = TypeParam::values(xi);
        const Eigen::MatrixXd D = TypeParam::derivatives(xi);
        EXPECT_NEAR(N.sum(), 1.0, 1e-15);
        EXPECT_LT(D.colwise().sum().norm(), 1e-14);
        Vector3d x = Vector3d::Zero();
        Eigen::Matrix3d J = Eigen::Matrix3d::Zero();
        for (int a = 0; a < TypeParam::nodes; ++a) {
            x += N(a) * Nodes<TypeParam>::at(a);
            J += Nodes<TypeParam>::at(a) * D.row(a);
        }
        EXPECT_LT((x - xi).norm(), 1e-15);
        EXPECT_LT((J - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    }
}

TYPED_TEST(ShapeFunctions, DerivativesAgreeWithDifferences) {
    const VectorXd xi = Vector3d(0.13, 0.22, 0.31);
    const auto values = [](const VectorXd& x) { return VectorXd(TypeParam::values(Vector3d(x))); };
    // Quadratic along each axis at most: the differences are exact but for rounding.
    test::expect_equal_to_differences(TypeParam::derivatives(Vector3d(xi)), test::central_differences(values, xi, 1e-3),
                                      1e-12, "dN/dxi");
}

}  // namespace
}  // namespace myo::mesh
