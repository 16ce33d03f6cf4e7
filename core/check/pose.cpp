#include <algorithm>
#include <cmath>
#include <optional>

#include "base/text.hpp"
#include "check/checks.hpp"
#include "dynamics/natural_modes.hpp"
#include "dynamics/statics.hpp"
#include "model/held_nodes.hpp"

namespace myo::check {
namespace {

/// Numbers of the linear buckling check, see check_pose().
struct PosePolicy {
    /// Share of the loads at which the change of frequency is measured: far from the critical load the squared
    /// frequency decreases linearly, and 1e-7 is the accuracy of frequencies.
    double load_share = 0.02;
    double doubtful_share = 1.2;  // critical load over load: a margin of a fifth
    int modes = 2;                // a square column has two equal modes
};
constexpr PosePolicy pose_policy;

/// The model with gravity and dead forces scaled by `share`.
model::Model under_part_of_loads(model::Model model, double share) {
    model.gravity_m_s2 *= share;
    for (model::DeadForce& force : model.forces) force.force_N *= share;
    return model;
}

/// Squared angular frequency of the slowest mode in equilibrium under a share of the loads; empty without equilibrium.
std::optional<double> slowest(const model::Model& model, double share, double time_s) {
    const model::Model loaded = under_part_of_loads(model, share);
    // Statics: the stiffness at the equilibrium, with the loads of t = 0.
    dynamics::StageSolver solver(loaded);
    Eigen::Matrix3Xd x = loaded.body->mesh.nodes;
    // Without loads and with passive actuators the rest shape is the equilibrium.
    if (share > 0.0 && dynamics::solve_equilibrium(solver, time_s, x).status != dynamics::SolveStatus::converged)
        return std::nullopt;
    const dynamics::NaturalModes modes = dynamics::natural_modes(solver, x, pose_policy.modes, time_s);
    if (!modes.ok()) return std::nullopt;
    return modes.modes.front().omega_rad_s * modes.modes.front().omega_rad_s;
}

}  // namespace

/// A standing column loses stiffness in proportion to its load and buckles when none is left; a lying beam does not.
/// The critical load factor follows from a linear extrapolation of omega^2 to zero. Actuators are passive here.
std::vector<Finding> check_pose(const CheckedJob& job) {
    // Without its weight a body that only obstacles bear is free: its least frequency is rounding of 0.
    if (model::support_nodes(*job.setup.body).empty()) return {};
    const setup::PreparedTrial& trial = job.setup.trials.front();
    model::Model model = prediction::trial_model(job.setup, 0, prediction::declared_values(job.setup));
    // What actuators do to the stiffness is no property of the pose.
    model.activation.assign(model.activation.size(), fibre::Signal::constant(1.0));
    model = model::with_constant_commands(model, 0.0, 0.0);
    const std::optional<double> free = slowest(model, 0.0, 0.0), loaded = slowest(model, pose_policy.load_share, 0.0);
    // Without modes or equilibrium the check does not apply; the support check reports a free body.
    if (!free || !loaded || !(*free > 0.0)) return {};
    // Loss of stiffness under the full load, relative.
    const double lost = (1.0 - *loaded / *free) / pose_policy.load_share;
    Finding finding = passed_finding(trial.name, "the pose at rest is stable under its loads");
    finding.figure = lost;
    finding.threshold = 1.0 / pose_policy.doubtful_share;
    if (lost <= finding.threshold) return {finding};
    // All stiffness is lost before the full load.
    const bool buckled = lost > 1.0;
    finding.level = buckled ? CheckLevel::wrong : CheckLevel::doubtful;
    finding.sentence = buckled ? "the undeformed pose is unstable: it buckles at " + format_number(1.0 / lost, 2) +
                                     " of its loads, to a side that a model without flaws chooses by rounding"
                               : "the pose is near buckling: its loads take " + format_number(100.0 * lost, 2) +
                                     " % of the stiffness of the undeformed body";
    finding.way_out =
        "a modulus, density or gravity of another size may be meant; else declare what decides the side "
        "(a small force, an initial bend)";
    return {finding};
}

}  // namespace myo::check
