#include "model/anchorage.hpp"

#include <vector>

#include "mesh/volume_mesh.hpp"

namespace myo {
namespace {

using Eigen::Matrix3d;
using Eigen::Matrix3Xd;
using Eigen::VectorXd;

struct HeldNode {
    int node = 0;
    int cell = 0;        // one that has it
    int cell_node = 0;   // its number there
    double volume = 0.0;
};

class Anchorage : public ForceElement {
public:
    Anchorage(std::shared_ptr<const std::vector<HeldNode>> nodes, double stiffness) : nodes_(std::move(nodes)), stiffness_(stiffness) {}

    void add(const Body& body, const ForceState& at, HessianKind kind, InternalEnergy& out) const override {
        const int per_cell = static_cast<int>(body.mesh.cells.rows());
        for (const HeldNode& held : *nodes_) {
            const Eigen::Vector3d u = at.x.col(held.node) - body.mesh.nodes.col(held.node);
            const double k = stiffness_ * held.volume;
            out.energy += 0.5 * k * u.squaredNorm();
            out.gradient.col(held.node) += k * u;
            if (kind != HessianKind::none && body.pattern.stores(per_cell, held.cell, held.cell_node, held.cell_node))
                body.pattern.add(out.hessian, body.mesh.cells, held.cell, held.cell_node, held.cell_node, Matrix3d(k * Matrix3d::Identity()));
        }
    }

    std::vector<ForceParameter> parameters() const override { return {{"stiffness_Pa_per_m2", stiffness_, stiffness_}}; }
    ForceElementPointer changed(const VectorXd& values) const override { return std::make_shared<Anchorage>(nodes_, values(0)); }
    void add_tangent(const Body& body, const ForceState& at, const VectorXd& change, Matrix3Xd& gradient) const override {
        for (const HeldNode& held : *nodes_) gradient.col(held.node) += change(0) * held.volume * (at.x.col(held.node) - body.mesh.nodes.col(held.node));
    }

private:
    std::shared_ptr<const std::vector<HeldNode>> nodes_;
    double stiffness_;
};

}  // namespace

ForceElementPointer anchorage(const Body& body, const VectorXd& fraction, double stiffness_Pa_per_m2) {
    const VectorXd volumes = cell_volumes(body.mesh);
    const Eigen::Index per_cell = body.mesh.cells.rows();
    std::vector<HeldNode> of_node(static_cast<std::size_t>(body.node_count()));
    for (Eigen::Index c = 0; c < body.mesh.cells.cols(); ++c)
        for (Eigen::Index a = 0; a < per_cell; ++a) {
            const int node = body.mesh.cells(a, c);
            HeldNode& held = of_node[static_cast<std::size_t>(node)];
            held = {node, static_cast<int>(c), static_cast<int>(a), held.volume + fraction(c) * volumes(c) / static_cast<double>(per_cell)};
        }
    auto nodes = std::make_shared<std::vector<HeldNode>>();
    for (const HeldNode& held : of_node)
        if (held.volume > 0.0) nodes->push_back(held);
    return std::make_shared<Anchorage>(nodes, stiffness_Pa_per_m2);
}

}  // namespace myo
