#include "model/point_pull.hpp"

#include <algorithm>
#include <utility>

#include "model/loaded_face.hpp"

namespace myo::model {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using Eigen::VectorXd;

/// See point_pull().
class PointPull : public ForceElement {
public:
    PointPull(std::vector<LoadedFace> nodes, VectorXd shares, Matrix3Xd places, double stiffness)
        : nodes_(std::move(nodes)), shares_(std::move(shares)), places_(std::move(places)), stiffness_(stiffness) {}

    void add(const Body& body, const ForceState& at, HessianKind kind, InternalEnergy& out) const override {
        for (std::size_t i = 0; i < nodes_.size(); ++i) {
            const Vector3d arm = arm_of(i, at);
            const double k = stiffness_ * shares_(static_cast<Eigen::Index>(i));
            out.energy += 0.5 * k * arm.squaredNorm();
            out.gradient.col(nodes_[i].nodes[0]) += k * arm;
            if (kind != HessianKind::none)
                add_face_hessian(body, nodes_[i], out.hessian,
                                 [&](std::size_t, std::size_t) { return Matrix3d(k * Matrix3d::Identity()); });
        }
    }

    std::vector<ForceParameter> parameters() const override {
        // A spring that starts at 0 still needs a scale for its changes.
        return {{"stiffness_N_m", stiffness_, std::max(stiffness_, 1.0)}};
    }
    ForceElementPointer changed(const VectorXd& values) const override {
        return std::make_shared<PointPull>(nodes_, shares_, places_, values(0));
    }
    void add_tangent(const Body&, const ForceState& at, const VectorXd& change, Matrix3Xd& gradient) const override {
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            gradient.col(nodes_[i].nodes[0]) += change(0) * shares_(static_cast<Eigen::Index>(i)) * arm_of(i, at);
    }

private:
    /// From the place to the node.
    Vector3d arm_of(std::size_t i, const ForceState& at) const {
        return at.x.col(nodes_[i].nodes[0]) - places_.col(static_cast<Eigen::Index>(i));
    }

    std::vector<LoadedFace> nodes_;  // one node each, with a cell that has it
    VectorXd shares_;
    Matrix3Xd places_;
    double stiffness_;
};

/// A cell of each node.
std::vector<LoadedFace> single_nodes(const Body& body, const std::vector<int>& nodes) {
    std::vector<int> cell_of(static_cast<std::size_t>(body.node_count()), 0);
    for (int c = 0; c < body.cell_count(); ++c)
        for (const int node : body.mesh.cells.col(c)) cell_of[static_cast<std::size_t>(node)] = c;
    std::vector<LoadedFace> result;
    for (const int node : nodes) result.push_back(loaded_nodes(body, cell_of[static_cast<std::size_t>(node)], {node}));
    return result;
}

}  // namespace

ForceElementPointer point_pull(const Body& body, const std::vector<int>& nodes, const VectorXd& shares,
                               const Matrix3Xd& places_m, double stiffness_N_m) {
    return std::make_shared<PointPull>(single_nodes(body, nodes), shares, places_m, stiffness_N_m);
}

}  // namespace myo::model
