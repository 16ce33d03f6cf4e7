#include "calibration/declared_gradients.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/parallel.hpp"
#include "prediction/parameter_tangent.hpp"
#include "sensitivity/tangent_run.hpp"

namespace myo::calibration {
namespace {

using prediction::ModelParameter;
using Kind = ModelParameter::Kind;

struct DeclaredGradientsPolicy {
    double part_of_scale = 1e-2;  // step of the differences over the scale of the number
    /// Differences amplify the noise of the solver by the inverse of their relative step.
    double tolerance = 1e-10;
};
constexpr DeclaredGradientsPolicy declared_gradients_policy;

/// Modulus and damping of every part, declared as unknown or not, and all numbers of the effects.
std::vector<ModelParameter> checked_numbers(const setup::Setup& setup, const prediction::ParameterValues& values) {
    // free_parameters() lists declared unknowns only, so all values of parts are declared as such in a copy.
    setup::Setup open = setup;
    for (experiment::PartDeclaration& part : open.experiment.parts) {
        part.calibrate = {"youngs_modulus", "damping"};
        part.youngs_modulus_tolerance = std::max(part.youngs_modulus_tolerance, 0.3);
    }
    std::vector<ModelParameter> numbers = prediction::free_parameters(open);
    std::erase_if(numbers,
                  [](const ModelParameter& p) { return p.kind != Kind::part_modulus && p.kind != Kind::part_damping; });
    for (std::size_t e = 0; e < values.effects.size(); ++e)
        for (ModelParameter& number : prediction::effect_parameters(setup, values.effects[e], e))
            numbers.push_back(std::move(number));
    return numbers;
}

/// Simulates the checked run with these values.
sensitivity::SensitiveTrace simulate(const CheckedRun& run, const prediction::ParameterValues& values,
                                     const std::vector<sensitivity::ModelTangent>& tangents, const Progress& progress) {
    effect::Affected affected = prediction::affected_trial(run.setup, run.trial, values);
    affected.options.end_s = run.end_s;
    affected.options.initial.velocities = run.initial_velocities;
    affected.options.solver.tolerance = declared_gradients_policy.tolerance;
    affected.options.solver.tangent_tolerance = declared_gradients_policy.tolerance;
    return sensitivity::simulate_with_tangents(affected.model, affected.options, tangents, run.target.markers.nodes,
                                               progress.with_sink({}));
}

/// Sum of the products of finite entries with their shares.
double product(const std::vector<Eigen::Matrix3Xd>& shares, const std::vector<Eigen::Matrix3Xd>& a,
               const std::vector<Eigen::Matrix3Xd>& b) {
    double sum = 0.0;
    for (std::size_t m = 0; m < a.size(); ++m)
        for (Eigen::Index k = 0; k < a[m].size(); ++k)
            if (std::isfinite(a[m](k))) sum += shares[m](k) * a[m](k) * b[m](k);
    return sum;
}

/// Numbers with their tangents and the step of their differences.
struct Checked {
    std::vector<ModelParameter> numbers;
    std::vector<sensitivity::ModelTangent> tangents;
    std::vector<double> steps;
};

/// Numbers that can be checked; `left_out` receives the others with the reason.
Checked numbers_with_tangents(const CheckedRun& run, std::vector<std::string>& left_out) {
    Checked checked;
    for (ModelParameter& number : checked_numbers(run.setup, run.values)) {
        const std::string& name = number.parameter.name;
        if (!prediction::moves_the_body(run.setup, run.trial, run.values, number)) {
            left_out.push_back(name + " (does not move the body of this trial)");
            continue;
        }
        const double value = prediction::value_of(number, run.values);
        // The five-point formula reaches two steps to each side and must stay within the bounds: 2 x 0.4 of the room.
        const double room = std::min(value - number.parameter.lower, number.parameter.upper - value);
        const double step = std::min(
            prediction::difference_step(number, value, declared_gradients_policy.part_of_scale), 0.4 * room);
        if (!(step > 0.0)) {
            left_out.push_back(name + " (stands at a bound)");
            continue;
        }
        std::optional<sensitivity::ModelTangent> tangent = prediction::parameter_tangent(run.setup, run.trial,
                                                                                         run.values, number);
        if (!tangent) {
            left_out.push_back(name + " (fits take its derivative from differences of runs)");
            continue;
        }
        checked.tangents.push_back(std::move(*tangent));
        checked.steps.push_back(step);
        checked.numbers.push_back(std::move(number));
    }
    return checked;
}

}  // namespace

DeclaredGradients declared_gradients(const CheckedRun& run, int threads, const Progress& progress) {
    DeclaredGradients result;
    // One run with all tangents against four runs per number without any.
    const Checked checked = numbers_with_tangents(run, result.left_out);
    if (checked.numbers.empty()) return result;
    const std::vector<Eigen::Matrix3Xd> shares = inverse::shares_of_coordinates(run.target);
    const sensitivity::SensitiveTrace exact = simulate(run, run.values, checked.tangents, progress);
    result.status = exact.trace.status;
    result.message = exact.trace.message;
    if (!exact.trace.complete()) return result;
    const inverse::SensitiveResiduals seen = inverse::target_residuals(run.target, exact);

    // Central differences of fourth order: shifts and weights of the five-point formula.
    constexpr double shifts[] = {-2.0, -1.0, 1.0, 2.0}, weights[] = {1.0 / 12.0, -2.0 / 3.0, 2.0 / 3.0, -1.0 / 12.0};
    std::vector<double> losses(4 * checked.numbers.size());
    std::vector<std::string> messages(losses.size());
    parallel_tasks(static_cast<int>(losses.size()), threads, [&](int task) {
        const auto i = static_cast<std::size_t>(task);
        const ModelParameter& number = checked.numbers[i / 4];
        prediction::ParameterValues values = run.values;
        prediction::set_value(number, prediction::value_of(number, values) + shifts[i % 4] * checked.steps[i / 4],
                              values);
        const sensitivity::SensitiveTrace there = simulate(run, values, {}, progress);
        messages[i] = there.trace.message;
        losses[i] = std::numeric_limits<double>::quiet_NaN();
        if (!there.trace.complete()) return;
        const std::vector<Eigen::Matrix3Xd> residuals = inverse::target_residuals(run.target, there).residuals_m;
        losses[i] = product(shares, residuals, residuals);
    });
    for (std::size_t p = 0; p < checked.numbers.size(); ++p) {
        const std::string& name = checked.numbers[p].parameter.name;
        sensitivity::GradientCheckRow row{name, 2.0 * product(shares, seen.residuals_m, seen.tangents[p])};
        for (std::size_t k = 0; k < 4; ++k) {
            row.difference += weights[k] * losses[4 * p + k] / checked.steps[p];
            if (std::isfinite(losses[4 * p + k])) continue;
            result.status = progress.cancelled() ? dynamics::RunStatus::cancelled : dynamics::RunStatus::failed;
            result.message = name + ": " + messages[4 * p + k];
            return result;
        }
        // The loss at any of the points serves as the scale of its rounding.
        sensitivity::compare(row, checked.steps[p], losses[4 * p], declared_gradients_policy.tolerance);
        result.rows.push_back(std::move(row));
    }
    return result;
}

}  // namespace myo::calibration
