#include "chart/scale.hpp"

#include <algorithm>
#include <cmath>

namespace myo::chart {
namespace {

struct AxisPolicy {
    // Ticks on an axis: two give a scale, more than ten crowd it.
    int fewest = 2, most = 10;
    // Space before the first and after the last category, in categories.
    double category_margin = 0.5;
};
constexpr AxisPolicy axis_policy;

/// Range of a logarithmic axis; padding is a factor.
Range logarithmic_range(const Axis& axis, Range range, double padding) {
    if (range.lowest > 0.0 && range.lowest < range.highest) {
        // A fraction of the decades on each side.
        const double rim = std::pow(range.highest / range.lowest, padding);
        range = {range.lowest / rim, range.highest * rim};
    }
    return {axis.lowest.value_or(range.lowest), axis.highest.value_or(range.highest)};
}

/// Range of a linear axis; padding is a fraction of the range.
Range linear_range(const Axis& axis, Range range, double padding) {
    if (axis.include_zero && range.lowest <= range.highest)
        range = {std::min(range.lowest, 0.0), std::max(range.highest, 0.0)};
    // Before padding: a constant curve gets a range around its value.
    make_drawable(range.lowest, range.highest);
    const double rim = padding * range.span();
    // Axes that start at zero keep zero as their end, without padding.
    if (!(axis.include_zero && range.lowest == 0.0)) range.lowest -= rim;
    if (!(axis.include_zero && range.highest == 0.0)) range.highest += rim;
    return {axis.lowest.value_or(range.lowest), axis.highest.value_or(range.highest)};
}

/// One tick per category at 0, 1, 2, ...
Ticks category_ticks(const std::vector<std::string>& names) {
    const auto count = static_cast<double>(names.size());
    Ticks ticks{-axis_policy.category_margin, count - 1.0 + axis_policy.category_margin, {}, names, {}};
    for (double k = 0.0; k < count; k += 1.0) ticks.values.push_back(k);
    return ticks;
}

}  // namespace

double Scale::operator()(double value) const {
    // Fraction of the range, 0 at `lowest` and 1 at `highest`; linear in the logarithm for a logarithmic axis.
    const double s = logarithmic ? std::log(value / lowest) / std::log(highest / lowest)
                                 : (value - lowest) / (highest - lowest);
    return from_px + s * (to_px - from_px);
}

double Scale::value(double pixel) const {
    const double s = (pixel - from_px) / (to_px - from_px);
    return logarithmic ? lowest * std::pow(highest / lowest, s) : lowest + s * (highest - lowest);
}

Range Scale::range(double from, double to) const {
    const double a = value(from), b = value(to);
    return {std::min(a, b), std::max(a, b)};
}

void DataRange::add(double value) {
    // Values that cannot be drawn must not determine the range.
    if (!std::isfinite(value) || (logarithmic && value <= 0.0)) return;
    lowest = std::min(lowest, value);
    highest = std::max(highest, value);
}

PlannedAxis plan_axis(const Axis& axis, const DataRange& data, double padding, double from_px, double to_px,
                      double tick_px) {
    const int wanted = std::clamp(static_cast<int>(std::abs(to_px - from_px) / tick_px), axis_policy.fewest,
                                  axis_policy.most);
    DataRange all = data;
    for (const double value : axis.include) all.add(value);
    PlannedAxis plan;
    const bool logarithmic = axis.logarithmic && axis.categories.empty();
    if (!axis.categories.empty()) {
        plan.ticks = category_ticks(axis.categories);
    } else if (logarithmic) {
        const Range range = logarithmic_range(axis, {all.lowest, all.highest}, padding);
        plan.ticks = logarithmic_ticks(range.lowest, range.highest, wanted);
    } else {
        const Range range = linear_range(axis, {all.lowest, all.highest}, padding);
        plan.ticks = linear_ticks(range.lowest, range.highest, wanted);
    }
    plan.scale = {plan.ticks.lowest, plan.ticks.highest, from_px, to_px, logarithmic};
    return plan;
}

void thin_labels(PlannedAxis& axis, double needed_px) {
    Ticks& ticks = axis.ticks;
    if (ticks.values.size() < 2) return;
    const std::size_t last = ticks.values.size() - 1;
    if (axis.scale.logarithmic) {
        // From the lowest on, those that have room after the label before.
        double free_from = -std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i <= last; ++i) {
            const double at = std::abs(axis.scale(ticks.values[i]) - axis.scale.from_px);
            if (at < free_from)
                ticks.labels[i].clear();
            else
                free_from = at + needed_px;
        }
        return;
    }
    const double step = ticks.values[1] - ticks.values[0];
    const double step_px = std::abs(axis.scale(ticks.values[1]) - axis.scale(ticks.values[0]));
    if (!(step_px > 0.0)) return;
    int every = 1;
    for (const int next : {2, 5, 10})
        if (every * step_px < needed_px) every = next;
    // Multiples are counted from zero, so that zero keeps its label.
    const auto regular = [&](double v) { return std::fmod(std::round(v / step), every) == 0.0; };
    // A single number gives no scale: the outermost ticks keep their labels instead.
    const bool enough = std::count_if(ticks.values.begin(), ticks.values.end(), regular) > 1;
    for (std::size_t i = 0; i <= last; ++i)
        if (enough ? !regular(ticks.values[i]) : i != 0 && i != last) ticks.labels[i].clear();
}

std::string axis_title(const Axis& axis, const Ticks& ticks) {
    std::string unit = ticks.factor;
    // The power of ten that the labels were divided by belongs to the unit.
    if (!axis.unit.empty()) unit += (unit.empty() ? "" : " ") + axis.unit;
    if (unit.empty()) return axis.label;
    return axis.label + (axis.label.empty() ? "[" : " [") + unit + "]";
}

}  // namespace myo::chart
