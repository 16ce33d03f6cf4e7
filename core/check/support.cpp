#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/text.hpp"
#include "check/checks.hpp"
#include "model/held_nodes.hpp"
#include "report/length.hpp"

namespace myo::check {
namespace {

struct SupportPolicy {
    /// Width of the clamped part over the size of the body, below which it is a line or a point; allows for rounding in
    /// mesh files.
    double min_width = 1e-5;
    /// Share of turns in a free motion, above which it is called a turn.
    double min_turn = 0.1;
};
constexpr SupportPolicy support_policy;

/// Sum of c c' over the held axes, with c the row by which a rigid motion (translation, turn) moves a node along one.
/// Turns are about the middle of the body, in units of its size.
Eigen::Matrix<double, 6, 6> held_motions(const model::Body& body, double size, int& count) {
    const Eigen::Matrix3Xd& X = body.mesh.nodes;
    const Eigen::Vector3d middle = X.rowwise().mean();
    Eigen::Matrix<double, 6, 6> sum = Eigen::Matrix<double, 6, 6>::Zero();
    // A rigid motion (u, w) moves a node by u + w x r; along an axis e that is e . u + (r x e) . w.
    const auto add = [&](int node, Eigen::Index axis) {
        Eigen::Matrix<double, 6, 1> row;
        row << Eigen::Vector3d::Unit(axis), ((X.col(node) - middle) / size).cross(Eigen::Vector3d::Unit(axis));
        sum += row * row.transpose();
        ++count;
    };
    for (const int node : model::held_nodes(body))
        for (Eigen::Index axis = 0; axis < 3; ++axis) add(node, axis);
    for (const model::GuidedNode& node : body.guided)
        for (Eigen::Index axis = 0; axis < 3; ++axis)
            if (node.held[static_cast<std::size_t>(axis)]) add(node.node, axis);
    return sum;
}

/// Finding for a body with rollers: a rigid motion that no support hinders.
Finding guided_finding(const model::Body& body) {
    const double size = mesh::bounding_box(body.mesh.nodes).size().maxCoeff();
    int count = 0;
    // The eigenvector of the least eigenvalue is the rigid motion that the held axes hinder least.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 6, 6>> motions(held_motions(body, size, count));
    const std::size_t clamped = model::held_nodes(body).size();
    Finding finding = passed_finding("", std::to_string(clamped) + " of " + std::to_string(body.node_count()) +
                                             " nodes are held, " + std::to_string(body.guided.size()) +
                                             " along some axes");
    // Root mean square motion of the held nodes along their held axes in the rigid motion that these hinder least.
    finding.figure = std::sqrt(std::max(0.0, motions.eigenvalues()(0)) / count);
    finding.threshold = support_policy.min_width;
    if (finding.figure > support_policy.min_width) return finding;
    const Eigen::Matrix<double, 6, 1> free = motions.eigenvectors().col(0);
    // A free turn moves the middle as well unless its axis passes through it, so any noticeable turn is named as one.
    const bool turns = free.tail<3>().norm() > support_policy.min_turn;
    Eigen::Index axis = 0;
    (turns ? free.tail<3>() : free.head<3>()).cwiseAbs().maxCoeff(&axis);
    finding.level = CheckLevel::wrong;
    finding.sentence = std::string("support: the body is free to ") + (turns ? "turn about " : "move along ") +
                       "xyz"[axis] + ", or nearly so: no support holds it there";
    finding.way_out = "hold a further axis at one of the supports, or add a support";
    return finding;
}

}  // namespace

std::vector<Finding> check_support(const CheckedJob& job) {
    const model::Body& body = *job.setup.body;
    if (!body.guided.empty()) return {guided_finding(body)};
    // Nodes of the clamp as the model has it, not the declared box.
    const std::vector<int> held = model::held_nodes(body);
    // Obstacles hold no node, so that there is no width to judge.
    if (held.empty()) return {passed_finding("", "no node is held: obstacles bear the body")};
    const Eigen::Matrix3Xd points = body.mesh.nodes(Eigen::all, held);
    const Eigen::Matrix3Xd apart = points.colwise() - points.rowwise().mean();
    // Principal axes of the clamped nodes. The eigenvalues ascend, so extents(1) is the second largest extent: it
    // vanishes for a line and for a point.
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(apart * apart.transpose());
    const Eigen::Vector3d extents = (axes.eigenvectors().transpose() * apart).cwiseAbs().rowwise().maxCoeff();
    const double size = mesh::bounding_box(body.mesh.nodes).size().maxCoeff();
    Finding finding = passed_finding("", std::to_string(held.size()) + " of " + std::to_string(body.node_count()) +
                                             " nodes are held, across " + report::length_words(2.0 * extents(1)));
    finding.figure = extents(1) / size;
    finding.threshold = support_policy.min_width;
    if (finding.figure > support_policy.min_width) return {finding};
    const bool point = extents(2) <= support_policy.min_width * size;
    finding.level = CheckLevel::wrong;
    finding.sentence = "clamp.box_m: what it holds is a " + std::string(point ? "point" : "line") +
                       ", so that the body turns freely about it";
    finding.way_out = "hold a face or a part of the body: make the box deeper or wider";
    return {finding};
}

}  // namespace myo::check
