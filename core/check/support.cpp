#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

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
};
constexpr SupportPolicy support_policy;

}  // namespace

std::vector<Finding> check_support(const CheckedJob& job) {
    const model::Body& body = *job.setup.body;
    // Nodes of the clamp as the model has it, not the declared box.
    const std::vector<int> held = model::held_nodes(body);
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
