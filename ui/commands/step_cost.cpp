#include "commands/step_cost.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace myo::ui::commands {
namespace {

/// Exponent measured by `myoloop bench scaling` for 4 to 66 thousand degrees of freedom. It lies between that of
/// assembly (1) and of factorisation (2).
constexpr double benchmark_exponent = 1.5;
/// Exponent for smaller bodies, where assembly dominates: 1.6 ms at 1,080 degrees of freedom, 6.8 ms at 4,608.
constexpr double small_exponent = 1.0;
/// The default model in the README's table of times, on the machine named there.
constexpr StepCost benchmark_cost{mesh::CellType::hex8, 4608.0, 6.8e-3};
constexpr double min_size_ratio = 1.5;  // smaller ratios would turn noise into an exponent

/// Slope of log(seconds) over log(DOF) by least squares. Requires at least two different sizes.
double slope(const std::vector<StepCost>& costs) {
    // Normal equations of a line through the points (log DOF, log seconds).
    double n = 0.0, sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
    for (const StepCost& cost : costs) {
        const double x = std::log(cost.dofs), y = std::log(cost.seconds);
        n += 1.0, sx += x, sy += y, sxx += x * x, sxy += x * y;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

}  // namespace

void remember(std::vector<StepCost>& costs, const StepCost& cost) {
    if (!(cost.dofs > 0.0 && cost.seconds > 0.0)) return;
    std::erase_if(costs,
                  [&](const StepCost& known) { return known.element == cost.element && known.dofs == cost.dofs; });
    costs.push_back(cost);
    if (costs.size() > max_step_costs) costs.erase(costs.begin());
}

StepPrediction predict_step(const std::vector<StepCost>& costs, mesh::CellType element, double dofs) {
    std::vector<StepCost> same;
    std::copy_if(costs.begin(), costs.end(), std::back_inserter(same),
                 [&](const StepCost& cost) { return cost.element == element; });
    // Same elements first: the cost per degree of freedom differs between element types.
    const StepCost from = !same.empty() ? same.back() : !costs.empty() ? costs.back() : benchmark_cost;
    const double exponent = std::max(from.dofs, dofs) <= benchmark_cost.dofs ? small_exponent : benchmark_exponent;
    StepPrediction prediction{0.0, from, exponent, false, !costs.empty()};
    const auto by_size = [](const StepCost& a, const StepCost& b) { return a.dofs < b.dofs; };
    if (!same.empty()) {
        const auto [least, most] = std::minmax_element(same.begin(), same.end(), by_size);
        if (most->dofs >= min_size_ratio * least->dofs) {
            // Timing noise on a busy machine must not make small bodies look expensive.
            prediction.exponent = std::clamp(slope(same), 0.5, 2.5);
            prediction.fitted = true;
        }
    }
    // t ~ DOF^p, scaled from the measurement.
    prediction.seconds = prediction.from.seconds * std::pow(dofs / prediction.from.dofs, prediction.exponent);
    return prediction;
}

}  // namespace myo::ui::commands
