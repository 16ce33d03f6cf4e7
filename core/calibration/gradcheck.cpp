#include "calibration/gradcheck.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/stopwatch.hpp"
#include "calibration/declared_gradients.hpp"
#include "experiment/actuators.hpp"
#include "model/force_element.hpp"
#include "prediction/trial_target.hpp"
#include "setup/actuator_signals.hpp"
#include "setup/trial_effects.hpp"

namespace myo::calibration {
namespace {

using Eigen::Matrix3Xd;

/// Smooth initial velocity field with components in all directions, so that every parameter influences the loss.
Matrix3Xd kick(const mesh::VolumeMesh& mesh) {
    const Eigen::Vector3d low = mesh.nodes.rowwise().minCoeff();
    const double size = (mesh.nodes.rowwise().maxCoeff() - low).norm();
    Matrix3Xd velocities(3, mesh.nodes.cols());
    for (Eigen::Index i = 0; i < velocities.cols(); ++i) {
        const Eigen::Vector3d s = (mesh.nodes.col(i) - low) / size;
        velocities.col(i) = 0.5 * size *
                            Eigen::Vector3d(std::sin(3.0 * s.x() + s.y()), std::cos(2.0 * s.y() - s.z()),
                                            std::sin(2.0 * s.z() + 2.0 * s.x() + 0.5));
    }
    return velocities;
}

/// Rest positions at the ends of the steps as target, if the trace has no sample that early.
inverse::MarkerTarget rest_target(const setup::Setup& setup, int steps, double h_s) {
    inverse::MarkerTarget target;
    target.markers = setup.markers;
    target.times_s = Eigen::VectorXd::LinSpaced(steps + 1, 0.0, steps * h_s);
    for (const experiment::MarkerDeclaration& marker : setup.experiment.markers.on_body)
        target.positions_m.emplace_back(marker.rest_m.replicate(1, steps + 1));
    return target;
}

/// Registration and start time against central differences of fourth order. The motion does not depend on them, so it
/// is simulated once.
std::vector<sensitivity::GradientCheckRow> placement_rows(const inverse::MarkerTarget& target,
                                                          const sensitivity::NodeMotion& motion, double h_s) {
    const inverse::MarkerPlacement gradient = inverse::mean_square_by_placement(target, motion);
    std::vector<sensitivity::GradientCheckRow> rows;
    const auto add = [&](const std::string& name, double adjoint, double step, const auto& change) {
        const auto loss = [&](double by) {
            inverse::MarkerTarget changed = target;
            change(changed.placement, by);
            return inverse::mean_square(changed, motion).value;
        };
        rows.push_back({name, adjoint,
                        (8.0 * (loss(step) - loss(-step)) - (loss(2.0 * step) - loss(-2.0 * step))) / (12.0 * step)});
        rows.back().relative_error = sensitivity::relative_difference(rows.back().adjoint, rows.back().difference);
    };
    const char* const axes[] = {"x", "y", "z"};
    for (Eigen::Index k = 0; k < 3; ++k) {
        if (!target.from_start)
            add(std::string("registration, translation ") + axes[k], gradient.translation_m(k), 1e-4,
                [k](inverse::MarkerPlacement& p, double by) { p.translation_m(k) += by; });
        add(std::string("registration, rotation ") + axes[k], gradient.rotation_rad(k), 1e-3,
            [k](inverse::MarkerPlacement& p, double by) { p.rotation_rad(k) += by; });
    }
    add("start time", gradient.start_shift_s, 0.02 * h_s,
        [](inverse::MarkerPlacement& p, double by) { p.start_shift_s += by; });
    return rows;
}

/// By how much pull_taut() raises tensions [N].
struct GradcheckPolicy {
    double least_tension_N = 0.05;     // raised tension
    double of_largest_tension = 0.01;  // the same over the largest tension of a signal, whose steps are 0.2 % of it
};
constexpr GradcheckPolicy gradcheck_policy;

/// Raises the tensions of tendons that are at 0 at some time: a tendon never pushes, so that no difference exists
/// there.
void pull_taut(const setup::Setup& setup, model::Model& model) {
    const std::vector<experiment::Actuator> actuators = experiment::actuators(setup.experiment);
    for (std::size_t i = 0; i < actuators.size(); ++i) {
        if (actuators[i].kind != experiment::ActuatorKind::tendon_tension) continue;
        fibre::Signal tension = setup::actuator_signal(setup.experiment, model, i);
        // Relative to the largest tension, as differences are.
        const auto [least, largest] = std::minmax_element(tension.values.begin(), tension.values.end());
        const double by = std::max(gradcheck_policy.least_tension_N, gradcheck_policy.of_largest_tension * *largest);
        // Differences change a tension by at most 0.2 % of its largest value, so such a tension stays positive.
        if (*least >= by) continue;
        for (double& value : tension.values) value += by;
        model::ForceElementPointer& element = model.force_elements[*setup::actuator_element(setup.experiment, i)];
        element = element->with_command(tension);
    }
}

/// Adds the rows of the declared effects and parts.
void add_declared(DeclaredGradients declared, TrialGradientCheck& result) {
    for (sensitivity::GradientCheckRow& row : declared.rows) result.check.rows.push_back(std::move(row));
    result.left_out = std::move(declared.left_out);
    if (declared.status == dynamics::RunStatus::complete) return;
    result.check.status = declared.status;
    result.check.message = declared.message;
}

}  // namespace

TrialGradientCheck gradcheck(const setup::Setup& setup, std::size_t index, int steps, const Progress& progress) {
    const Stopwatch watch;
    const setup::PreparedTrial& trial = setup.trials[index];
    model::Model model = trial.model;
    // Free levels are not passive here, so that their actuators act: half a scale, which is 1.05 of a muscle.
    prediction::ParameterValues values = prediction::declared_values(setup);
    for (const std::size_t actuator : trial.free_levels) {
        values.levels[index][actuator] = setup::passive_level(setup.experiment, actuator) +
                                         0.5 * setup::level_bounds(setup.experiment, actuator).scale;
        setup::set_level(setup.experiment, actuator, values.levels[index][actuator], model);
    }
    pull_taut(setup, model);
    effect::Affected affected = setup::with_effects(setup, index, std::move(model), setup.experiment.effects);
    model = std::move(affected.model);
    dynamics::SimulationOptions options = affected.options;
    options.end_s = steps * options.h_s;
    options.initial.velocities = kick(setup.mesh.mesh);

    TrialGradientCheck result;
    result.steps = steps;
    result.end_s = options.end_s;
    inverse::MarkerTarget target = prediction::trial_target(setup, index, options.end_s);
    // A single sample at t = 0, before anything moves, does not constrain the motion.
    result.against_trace = target.coordinates() > 0 && target.times_s.tail(1)(0) > 0.0;
    if (!result.against_trace) target = rest_target(setup, steps, options.h_s);
    // Registration off zero, so that its gradient does not vanish; sample times between steps, where the motion is
    // smooth.
    target.placement = {{1e-4, -2e-4, 1.5e-4}, {0.01, 0.02, -0.015}, -0.23 * options.h_s};
    sensitivity::LossOfMotion loss = inverse::mean_square_of(target);
    // The first evaluation is the unperturbed run; its motion is kept for placement_rows().
    std::atomic<bool> first = true;
    sensitivity::NodeMotion checked;
    loss.evaluate = [&, evaluate = loss.evaluate](const sensitivity::NodeMotion& motion) {
        sensitivity::MotionLoss value = evaluate(motion);
        if (first.exchange(false)) {
            result.loss_m2 = value.value;
            checked = motion;
        }
        return value;
    };
    result.check = sensitivity::check_gradient(model, options, loss, sensitivity::checked_parameters(model, options),
                                               {}, setup.settings.threads, progress);
    if (result.check.complete())
        for (sensitivity::GradientCheckRow& row : placement_rows(target, checked, options.h_s))
            result.check.rows.push_back(std::move(row));
    if (result.check.complete())
        add_declared(declared_gradients({setup, index, values, result.end_s, options.initial.velocities, target},
                                        setup.settings.threads, progress),
                     result);
    result.seconds = watch.seconds();
    return result;
}

}  // namespace myo::calibration
