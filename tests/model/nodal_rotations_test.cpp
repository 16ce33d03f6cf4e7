#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "model/nodal_rotations.hpp"
#include "support/beam.hpp"

namespace myo::model {
namespace {

using Eigen::Map;
using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

TEST(NodalRotations, OfATurnedAndStretchedBodyAreTheTurn) {
    const Matrix3d Q = Eigen::AngleAxisd(2.1, Vector3d(1.0, -2.0, 0.5).normalized()).toRotationMatrix();
    const Matrix3d stretch = Vector3d(1.3, 0.8, 0.95).asDiagonal();
    for (const std::string& id : fem::element_ids()) {
        test::BeamSpec spec;
        ASSERT_TRUE(fem::parse_element(id, spec.kind));
        const Model model = test::make_beam(spec);
        const Matrix3Xd x = (Q * stretch * model.body->mesh.nodes).colwise() + Vector3d(3.0, -1.0, 7.0);
        const auto rotations = nodal_rotations(*model.body, x);
        ASSERT_EQ(rotations.cols(), model.body->node_count());
        for (Eigen::Index i = 0; i < rotations.cols(); ++i)
            EXPECT_LT((Map<const Matrix3d>(rotations.col(i).data()) - Q).norm(), 1e-12) << id << " node " << i;
    }
}

/// Flattened or mirrored bodies have no nearest rotation worth the name; what comes out is one all the same.
TEST(NodalRotations, OfDegenerateBodiesAreRotations) {
    const Model model = test::make_beam({});
    for (const Vector3d& scale : {Vector3d(1.0, 1.0, -1.0), Vector3d(1.0, 0.0, 1.0), Vector3d(0.0, 0.0, 0.0)}) {
        const auto rotations = nodal_rotations(*model.body, scale.asDiagonal() * model.body->mesh.nodes);
        for (Eigen::Index i = 0; i < rotations.cols(); ++i) {
            const Matrix3d R = Map<const Matrix3d>(rotations.col(i).data());
            EXPECT_LT((R.transpose() * R - Matrix3d::Identity()).norm(), 1e-12);
            EXPECT_NEAR(R.determinant(), 1.0, 1e-12);
        }
    }
}

}  // namespace
}  // namespace myo::model
