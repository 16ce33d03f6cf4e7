#include <algorithm>
#include <cmath>

#include "chart/chart.hpp"

namespace myo::chart {
namespace {

struct RowPolicy {
    // Height of a row [px].
    double height_px = 30.0;
};
constexpr RowPolicy row_policy;

/// Why the estimate of a row is not seen; empty if it is.
std::string remark_of(const Axis& axis, double value) {
    if (!std::isfinite(value) || (axis.logarithmic && value <= 0.0)) return "no value";
    const bool below = axis.lowest && value < *axis.lowest, above = axis.highest && value > *axis.highest;
    return below || above ? "outside the axis" : "";
}

}  // namespace

Chart chart_of(const ErrorBarChart& chart) {
    const std::size_t count = chart.rows.size();
    Series estimates{.style = SeriesStyle::dots, .colour = 0}, references{.style = SeriesStyle::diamonds, .colour = 1};
    Panel panel{.height_px = row_policy.height_px * static_cast<double>(std::max<std::size_t>(1, count)),
                .vertical = chart.vertical};
    // Values of y grow upwards: the first row is the highest.
    for (std::size_t i = 0; i < count; ++i) {
        const ErrorBarRow& row = chart.rows[i];
        const auto y = static_cast<double>(count - 1 - i);
        // Categories count from the lowest row.
        panel.y.categories.insert(panel.y.categories.begin(), row.name);
        estimates.x.push_back(row.value);
        estimates.y.push_back(y);
        estimates.ends.push_back({row.lowest, row.highest});
        if (row.reference) references.x.push_back(*row.reference), references.y.push_back(y);
        if (std::string remark = remark_of(chart.x, row.value); !remark.empty())
            panel.notes.push_back({y, std::move(remark)});
    }
    // Without references there is nothing to distinguish the estimates from, hence no legend.
    if (!chart.reference_name.empty() && !references.x.empty())
        estimates.name = "estimate", references.name = chart.reference_name;
    panel.series = {std::move(estimates), std::move(references)};
    return {.title = chart.title, .x = chart.x, .panels = {std::move(panel)}, .width_px = chart.width_px};
}

}  // namespace myo::chart
