#include <algorithm>
#include <cmath>

#include <Eigen/LU>

#include "base/text.hpp"
#include "check/checks.hpp"
#include "mesh/cells.hpp"

namespace myo::check {
namespace {

using Eigen::Matrix3Xd;

struct InsideOutPolicy {
    /// Number of states that are checked: an inverted cell remains inverted for more than a hundredth of a run.
    std::size_t max_states = 100;
};
constexpr InsideOutPolicy inside_out_policy;

/// Whether det(dx/dxi) <= 0 at one of the given reference points of a cell.
template <class Shape>
bool turned(const mesh::VolumeMesh& mesh, Eigen::Index cell, const Matrix3Xd& x, const Matrix3Xd& corners) {
    Eigen::Matrix<double, 3, Shape::nodes> X;
    for (int a = 0; a < Shape::nodes; ++a) X.col(a) = x.col(mesh.cells(a, cell));
    for (const Eigen::Vector3d xi : corners.colwise())
        if ((X * Shape::derivatives(xi)).determinant() <= 0.0) return true;
    return false;
}

/// Number of cells with a non-positive Jacobian determinant at a corner.
int turned_cells(const mesh::VolumeMesh& mesh, const Matrix3Xd& x) {
    return mesh::with_cell(mesh.type, [&]<class Shape>(Shape) {
        const Matrix3Xd corners = Shape::reference_corners();
        int count = 0;
        for (Eigen::Index c = 0; c < mesh.cell_count(); ++c) count += turned<Shape>(mesh, c, x, corners);
        return count;
    });
}

}  // namespace

std::vector<Finding> check_inside_out(const CheckedJob& job) {
    const mesh::VolumeMesh& mesh = job.setup.mesh.mesh;
    std::vector<Finding> findings;
    for (std::size_t t = 0; t < job.setup.trials.size(); ++t) {
        const dynamics::Trace& trace = job.run->predictions[t].trace;
        // Trials that were not run.
        if (trace.positions.empty()) continue;
        // Every stride-th state, about max_states of them.
        const std::size_t last = trace.positions.size() - 1, stride = last / inside_out_policy.max_states + 1;
        int most = 0;
        double since_s = 0.0;
        for (std::size_t i = 0; i <= last; i += stride) {
            const int count = turned_cells(mesh, trace.positions[i]);
            // The first inverted state, whether or not more cells follow.
            if (count > 0 && most == 0) since_s = trace.times_s[i];
            most = std::max(most, count);
        }
        const std::string& name = job.setup.trials[t].name;
        Finding finding = passed_finding(name, "trial " + name + ": no cell is inside out");
        finding.figure = most;
        finding.threshold = 0.0;
        if (most > 0) {
            finding.level = CheckLevel::wrong;
            finding.sentence = "trial " + name + ": up to " + std::to_string(most) + " of " +
                               std::to_string(mesh.cell_count()) + " cells are inside out, the first at " +
                               format_number(since_s, 3) + " s, so that the motion from then on means nothing";
            finding.way_out = "are loads, signals and the modulus in SI units? a finer mesh or smaller loads may help";
        }
        findings.push_back(std::move(finding));
    }
    return findings;
}

}  // namespace myo::check
