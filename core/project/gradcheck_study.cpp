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
    LossOfMotion loss = mean_square_of(target);
    std::atomic<bool> first = true;
    loss.evaluate = [&, evaluate = loss.evaluate](const NodeMotion& motion) {
        MotionLoss value = evaluate(motion);
        if (first.exchange(false)) result.loss_m2 = value.value;
        return value;
    };
    result.check = check_gradient(model, options, loss, checked_parameters(model, options), {}, study.settings.threads, progress);
    result.seconds = watch.seconds();
    return result;
}

}  // namespace myo
