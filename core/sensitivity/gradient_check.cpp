#include "sensitivity/gradient_check.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"

namespace myo::sensitivity {
namespace {

/// Loss of one run; NaN if the run failed, with the reason in `message`.
double loss_of_run(const model::Model& model, const dynamics::SimulationOptions& options, const LossOfMotion& loss,
                   const Progress& progress, std::string& message) {
    NodeMotion motion;
    dynamics::RunObserver observer;
    observer.reached = [&](const dynamics::RunPoint& point) {
        motion.times_s.push_back(point.time_s);
        motion.positions.emplace_back(point.state.x(Eigen::all, loss.nodes));
        motion.velocities.emplace_back(point.state.v(Eigen::all, loss.nodes));
    };
    dynamics::StageSolver solver(model, options.solver);
    dynamics::RunPart whole;
    whole.keep_motion = false;
    const dynamics::Trace trace = dynamics::simulate_part(solver, options, whole, progress.with_sink({}), observer);
    if (trace.complete()) return loss.evaluate(motion).value;
    message = trace.message;
    return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

double relative_difference(double a, double b) {
    if (!std::isfinite(a) || !std::isfinite(b)) return std::numeric_limits<double>::infinity();
    const double size = std::max(std::abs(a), std::abs(b));
    return size > 0.0 ? std::abs(a - b) / size : 0.0;
}

void compare(GradientCheckRow& row, double step, double loss, double tolerance) {
    const double larger = std::max(std::abs(row.adjoint), std::abs(row.difference));
    row.has_influence = !(larger * step <= tolerance * std::abs(loss));  // NaN counts
    row.relative_error = row.has_influence ? relative_difference(row.adjoint, row.difference) : 0.0;
}

double GradientCheck::median_error() const {
    if (rows.empty()) return 0.0;
    std::vector<double> errors;
    for (const GradientCheckRow& row : rows) errors.push_back(row.relative_error);
    const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
    std::nth_element(errors.begin(), middle, errors.end());
    return *middle;
}

double GradientCheck::worst_error() const {
    double worst = 0.0;
    for (const GradientCheckRow& row : rows) worst = std::max(worst, row.relative_error);
    return worst;
}

GradientCheck check_gradient(const model::Model& model, dynamics::SimulationOptions options, const LossOfMotion& loss,
                             const std::vector<CheckedParameter>& parameters, AdjointOptions adjoint, int threads,
                             const Progress& progress) {
    // The noise of a difference quotient is the solver tolerance over the relative step.
    options.solver.tolerance = 1e-10;
    adjoint.tolerance = 1e-10;
    adjoint.fibre_points = !model.fibres->empty();
    GradientCheck check;
    const GradientRun run = simulate_with_gradient(model, options, loss, adjoint, progress);
    check.status = run.status;
    check.message = run.message;
    if (!run.complete()) return check;

    // Central differences of fourth order: shifts and weights of the five-point formula.
    constexpr double shifts[] = {-2.0, -1.0, 1.0, 2.0}, weights[] = {1.0 / 12.0, -2.0 / 3.0, 2.0 / 3.0, -1.0 / 12.0};
    std::vector<double> losses(4 * parameters.size());
    std::vector<std::string> messages(losses.size());
    parallel_tasks(static_cast<int>(losses.size()), threads, [&](int task) {
        const auto i = static_cast<std::size_t>(task);
        const CheckedParameter& parameter = parameters[i / 4];
        model::Model changed = model;
        if (changed.poissons_ratio.empty())
            changed.poissons_ratio = model::poissons_ratios(
                model.moduli);  // derivatives hold it, so the differences must, too
        dynamics::SimulationOptions changed_options = options;
        parameter.change(changed, changed_options, shifts[i % 4] * parameter.step);
        losses[i] = loss_of_run(changed, changed_options, loss, progress, messages[i]);
    });
    for (std::size_t p = 0; p < parameters.size(); ++p) {
        GradientCheckRow row{parameters[p].name, parameters[p].derivative(run.gradient)};
        for (std::size_t k = 0; k < 4; ++k) {
            // A failed run gives NaN; the message names the parameter.
            row.difference += weights[k] * losses[4 * p + k] / parameters[p].step;
            if (std::isfinite(losses[4 * p + k])) continue;
            check.status = progress.cancelled() ? dynamics::RunStatus::cancelled : dynamics::RunStatus::failed;
            check.message = parameters[p].name + ": " + messages[4 * p + k];
            return check;
        }
        compare(row, parameters[p].step, losses[4 * p], options.solver.tolerance);
        check.rows.push_back(std::move(row));
    }
    return check;
}

}  // namespace myo::sensitivity
