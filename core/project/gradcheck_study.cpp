#include "project/gradcheck_study.hpp"

#include <atomic>
#include <cmath>

#include "base/stopwatch.hpp"
#include "project/study_target.hpp"

namespace myo {
namespace {

using Eigen::Matrix3Xd;

/// A smooth field of velocities, in every direction.
Matrix3Xd kick(const VolumeMesh& mesh) {
    const Eigen::Vector3d low = mesh.nodes.rowwise().minCoeff();
    const double size = (mesh.nodes.rowwise().maxCoeff() - low).norm();
    Matrix3Xd velocities(3, mesh.nodes.cols());
    for (Eigen::Index i = 0; i < velocities.cols(); ++i) {
        const Eigen::Vector3d s = (mesh.nodes.col(i) - low) / size;
        velocities.col(i) = 0.5 * size * Eigen::Vector3d(std::sin(3.0 * s.x() + s.y()), std::cos(2.0 * s.y() - s.z()), std::sin(2.0 * s.z() + 2.0 * s.x() + 0.5));
    }
    return velocities;
}

/// The positions at rest at the ends of the steps, where the trace has nothing to say so early.
MarkerTarget rest_target(const Study& study, int steps, double h_s) {
    MarkerTarget target;
    target.markers = study.markers;
    target.times_s = Eigen::VectorXd::LinSpaced(steps + 1, 0.0, steps * h_s);
    for (const MarkerDeclaration& marker : study.experiment.markers.on_body) target.positions_m.emplace_back(marker.rest_m.replicate(1, steps + 1));
    return target;
}

/// The placement against central differences of fourth order, as the run is checked; it does not depend on it.
std::vector<GradientCheckRow> placement_rows(const MarkerTarget& target, const NodeMotion& motion, double h_s) {
    const MarkerPlacement gradient = mean_square_by_placement(target, motion);
    std::vector<GradientCheckRow> rows;
    const auto add = [&](const std::string& name, double adjoint, double step, const auto& change) {
        const auto loss = [&](double by) {
            MarkerTarget changed = target;
            change(changed.placement, by);
            return mean_square(changed, motion).value;
        };
        rows.push_back({name, adjoint, (8.0 * (loss(step) - loss(-step)) - (loss(2.0 * step) - loss(-2.0 * step))) / (12.0 * step)});
        rows.back().relative_error = relative_difference(rows.back().adjoint, rows.back().difference);
    };
    const char* const axes[] = {"x", "y", "z"};
    for (Eigen::Index k = 0; k < 3; ++k) {
        if (!target.from_start)
            add(std::string("registration, translation ") + axes[k], gradient.translation_m(k), 1e-4, [k](MarkerPlacement& p, double by) { p.translation_m(k) += by; });
        add(std::string("registration, rotation ") + axes[k], gradient.rotation_rad(k), 1e-3, [k](MarkerPlacement& p, double by) { p.rotation_rad(k) += by; });
    }
    add("start time", gradient.start_shift_s, 0.02 * h_s, [](MarkerPlacement& p, double by) { p.start_shift_s += by; });
    return rows;
}

}  // namespace

StudyGradientCheck gradcheck_study(const Study& study, std::size_t index, int steps, const Progress& progress) {
    const Stopwatch watch;
    const StudyTrial& trial = study.trials[index];
    Model model = trial.model;
    for (const std::size_t muscle : trial.free_levels) model.activation = with_level(study.experiment, model.activation, muscle, 1.05);
    SimulationOptions options = trial.options;
    options.end_s = steps * options.h_s;
    options.initial.velocities = kick(study.mesh.mesh);

    StudyGradientCheck result;
    result.steps = steps;
    result.end_s = options.end_s;
    MarkerTarget target = trial_target(study, index, options.end_s);
    // One sample at the start, before anything moves, tells nothing of the motion.
    result.against_trace = target.coordinates() > 0 && target.times_s.tail(1)(0) > 0.0;
    if (!result.against_trace) target = rest_target(study, steps, options.h_s);
    // Off the marks, so that the placement matters; samples off the steps, between which the motion is smooth in time.
    target.placement = {{1e-4, -2e-4, 1.5e-4}, {0.01, 0.02, -0.015}, -0.23 * options.h_s};
    LossOfMotion loss = mean_square_of(target);
    std::atomic<bool> first = true;
    NodeMotion checked;
    loss.evaluate = [&, evaluate = loss.evaluate](const NodeMotion& motion) {
        MotionLoss value = evaluate(motion);
        if (first.exchange(false)) {
            result.loss_m2 = value.value;
            checked = motion;
        }
        return value;
    };
    result.check = check_gradient(model, options, loss, checked_parameters(model, options), {}, study.settings.threads, progress);
    if (result.check.complete())
        for (GradientCheckRow& row : placement_rows(target, checked, options.h_s)) result.check.rows.push_back(std::move(row));
    result.seconds = watch.seconds();
    return result;
}

}  // namespace myo
