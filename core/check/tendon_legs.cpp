#include <algorithm>
#include <cmath>
#include <vector>

#include "base/text.hpp"
#include "check/checks.hpp"
#include "fem/material_point.hpp"
#include "mesh/volume_mesh.hpp"
#include "model/tendon.hpp"
#include "prediction/prediction.hpp"

namespace myo::check {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

struct TendonLegsPolicy {
    /// Change of the lever arm of a leg at its middle, over the arm. The mean over a leg in an arc is two thirds of
    /// that, and with it the change of the bending moment: 10 %.
    double max_changed = 0.15;
    /// Number of states that are looked at in a trial.
    std::size_t max_states = 100;
    /// Half thickness of the slice of the body around the middle of a leg, whose centroid the lever arm is measured
    /// from, over the length of the leg.
    double slice = 0.5;
};
constexpr TendonLegsPolicy tendon_legs_policy;

/// Two neighbouring guides that move with the body, and the material between them.
struct Leg {
    std::size_t first_guide = 0;
    const fem::MaterialPoint* ends[2] = {nullptr, nullptr};
    fem::MaterialPoint middle;  // of the straight leg at rest
    double length_m = 0.0;      // at rest
    double lever_m = 0.0;       // from the middle of the leg to the middle of the body, across the leg
};

/// Place of a material point at node positions x [m].
Vector3d position(const fem::MaterialPoint& point, const Matrix3Xd& x) {
    return x(Eigen::all, point.nodes) * point.weights;
}

/// Centres and volumes of the cells at rest.
struct Cells {
    Matrix3Xd centres_m;  // 3 x cells
    Eigen::VectorXd volumes_m3;
};

Cells cells_at_rest(const mesh::VolumeMesh& mesh) {
    Cells cells{Matrix3Xd(3, mesh.cell_count()), mesh::cell_volumes(mesh)};
    for (Eigen::Index c = 0; c < mesh.cell_count(); ++c)
        cells.centres_m.col(c) = mesh.nodes(Eigen::all, mesh.cells.col(c)).rowwise().mean();
    return cells;
}

/// Centroid of the cells around the middle of a leg, within `half_m` along it; the middle itself if there are none.
Vector3d centroid_of_slice(const Cells& cells, const Vector3d& middle, const Vector3d& along, double half_m) {
    Vector3d sum = Vector3d::Zero();
    double volume = 0.0;
    for (Eigen::Index c = 0; c < cells.centres_m.cols(); ++c) {
        if (std::abs((cells.centres_m.col(c) - middle).dot(along)) > half_m) continue;
        sum += cells.volumes_m3(c) * cells.centres_m.col(c);
        volume += cells.volumes_m3(c);
    }
    return volume > 0.0 ? Vector3d(sum / volume) : middle;
}

/// Legs of a tendon with both guides on the body and a lever arm: those outside run in space, without material to
/// leave.
std::vector<Leg> legs_on_body(const std::vector<model::TendonGuide>& guides, const mesh::VolumeMesh& mesh,
                              const mesh::BoundaryLocator& boundary, const Cells& cells) {
    std::vector<Leg> legs;
    for (std::size_t g = 0; g + 1 < guides.size(); ++g) {
        // Between the body and a fixed guide the thread runs free, as it is simulated.
        if (!guides[g].on_body || !guides[g + 1].on_body) continue;
        Leg leg;
        leg.first_guide = g;
        leg.ends[0] = &*guides[g].on_body;
        leg.ends[1] = &*guides[g + 1].on_body;
        const Vector3d middle = 0.5 * (guides[g].rest_m + guides[g + 1].rest_m);
        leg.middle = fem::material_point(mesh, boundary, middle);
        leg.length_m = (guides[g + 1].rest_m - guides[g].rest_m).norm();
        if (!(leg.length_m > 0.0)) continue;
        const Vector3d along = (guides[g + 1].rest_m - guides[g].rest_m) / leg.length_m;
        const Vector3d arm = middle - centroid_of_slice(cells, middle, along, tendon_legs_policy.slice * leg.length_m);
        // Only the part across the leg is a lever arm.
        leg.lever_m = (arm - arm.dot(along) * along).norm();
        // A leg through the middle of the body bends nothing.
        if (leg.lever_m > 0.0) legs.push_back(std::move(leg));
    }
    return legs;
}

/// How far the straight leg runs from the material that lay at its middle [m].
double sag(const Leg& leg, const Matrix3Xd& x) {
    return (position(leg.middle, x) - 0.5 * (position(*leg.ends[0], x) + position(*leg.ends[1], x))).norm();
}

/// The leg whose lever arm changes most in a run.
struct Worst {
    double changed = 0.0, sag_m = 0.0;
    const Leg* leg = nullptr;
    std::size_t trial = 0;
};

Worst worst_leg(const CheckedJob& job, const std::vector<Leg>& legs) {
    Worst worst;
    for (std::size_t t = 0; t < job.setup.trials.size(); ++t) {
        const std::vector<Matrix3Xd>& states = job.run->predictions[t].trace.positions;
        // A bend lasts longer than a hundredth of a run.
        const std::size_t stride = states.size() / tendon_legs_policy.max_states + 1;
        for (std::size_t i = 0; i < states.size(); i += stride)
            for (const Leg& leg : legs) {
                const double sag_m = sag(leg, states[i]);
                // Relative to the lever arm at rest, since the bending moment is tension times arm.
                if (sag_m > worst.changed * leg.lever_m) worst = {sag_m / leg.lever_m, sag_m, &leg, t};
            }
    }
    return worst;
}

/// Finding for one tendon from its leg that changes most.
///
/// @param in_channel  its points between the guides are those of a channel
Finding finding_of(const CheckedJob& job, const experiment::TendonDeclaration& tendon, bool in_channel,
                   const Worst& worst) {
    Finding finding = passed_finding(tendon.name,
                                     "tendon " + tendon.name + ": straight between its guides, it keeps its lever arm");
    finding.figure = worst.changed;
    finding.threshold = tendon_legs_policy.max_changed;
    if (!(worst.changed > tendon_legs_policy.max_changed)) return finding;
    finding.level = CheckLevel::doubtful;
    const std::size_t guide = worst.leg->first_guide + 1;
    const std::string straight = format_number(1e3 * worst.leg->length_m, 3) + " mm, it runs straight, up to " +
                                 format_number(1e3 * worst.sag_m, 2) +
                                 " mm off the material of the bent body in trial " +
                                 job.setup.trials[worst.trial].name + ", which changes its lever arm by " +
                                 format_number(100.0 * worst.changed, 2) + " %";
    if (in_channel) {
        finding.sentence = "tendon " + tendon.name + ": between two points that hold it in its channel, " + straight;
        finding.way_out = "these points follow the cells: a finer mesh holds it more closely";
        return finding;
    }
    finding.sentence = "tendon " + tendon.name + ": from guide " + std::to_string(guide) + " to " +
                       std::to_string(guide + 1) + ", " + straight +
                       ": on the inner side of a bend it grows, the body bends more, and may buckle between guides";
    finding.way_out =
        "if the thread runs in a channel of the body, say channel = true in its table, or, for a wide or soft channel, "
        "declare the effect of channels; if it runs free, nothing is wrong";
    return finding;
}

}  // namespace

std::vector<Finding> check_tendon_legs(const CheckedJob& job) {
    std::vector<Finding> findings;
    if (job.setup.tendons.empty() || job.setup.trials.empty()) return findings;
    const mesh::VolumeMesh& mesh = job.setup.mesh.mesh;
    const mesh::BoundaryLocator boundary(mesh);
    const Cells cells = cells_at_rest(mesh);
    // A declared effect may lead the threads elsewhere.
    const model::Model model = prediction::affected_trial(job.setup, 0, job.run->values).model;
    for (std::size_t i = 0; i < job.setup.tendons.size(); ++i) {
        const experiment::TendonDeclaration& tendon = job.setup.experiment.tendons[i];
        const model::TendonRoute& route = *model::tendon_route(*model.force_elements[job.setup.chambers.size() + i]);
        const std::vector<Leg> legs = legs_on_body(route.guides, mesh, boundary, cells);
        if (legs.empty()) continue;
        const bool in_channel = tendon.channel || route.guides.size() > job.setup.tendons[i].route.guides.size();
        findings.push_back(finding_of(job, tendon, in_channel, worst_leg(job, legs)));
    }
    return findings;
}

}  // namespace myo::check
