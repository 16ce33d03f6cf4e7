#include <algorithm>
#include <cassert>

#include "chart/chart.hpp"

namespace myo::chart {
namespace {

struct BarPolicy {
    // Share of a category that bars take; the rest separates categories.
    double share = 0.72;
    // Few bars do not become wider than this [px].
    double widest_px = 56.0;
};
constexpr BarPolicy bar_policy;

}  // namespace

Chart chart_of(const BarChart& bars) {
    Panel panel{.y = bars.y, .height_px = bars.height_px};
    // Bars encode values by length: the axis must contain zero.
    panel.y.include_zero = !panel.y.logarithmic;
    const double categories = std::max<double>(1.0, static_cast<double>(bars.categories.size()));
    const auto groups = static_cast<double>(bars.groups.size());
    // In categories: groups share the width of a category, and few bars keep their widest width in pixels.
    const double width = std::min(bar_policy.share / std::max(1.0, groups),
                                  bar_policy.widest_px * categories / bars.width_px);
    for (std::size_t g = 0; g < bars.groups.size(); ++g) {
        assert(bars.groups[g].values.size() == bars.categories.size());
        Series series{.name = bars.groups[g].name,
                      .y = bars.groups[g].values,
                      .style = SeriesStyle::bars,
                      .colour = static_cast<int>(g)};
        for (std::size_t i = 0; i < series.y.size(); ++i) {
            // Groups are centred on their category.
            const double left = static_cast<double>(i) + (static_cast<double>(g) - 0.5 * groups) * width;
            series.x.push_back(left + 0.5 * width);
            series.ends.push_back({left, left + width});
        }
        panel.series.push_back(std::move(series));
    }
    return {.title = bars.title,
            .x = {.categories = bars.categories},
            .panels = {std::move(panel)},
            .width_px = bars.width_px};
}

Chart chart_of(const Histogram& histogram) {
    assert(histogram.edges.empty() ? histogram.counts.empty() : histogram.edges.size() == histogram.counts.size() + 1);
    Series bars{.y = histogram.counts, .style = SeriesStyle::bars, .colour = 0};
    for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
        bars.x.push_back(0.5 * (histogram.edges[i] + histogram.edges[i + 1]));
        bars.ends.push_back({histogram.edges[i], histogram.edges[i + 1]});
    }
    return {.title = histogram.title,
            .x = histogram.x,
            .panels = {{.y = {.label = histogram.count_label, .include_zero = true},
                        .series = {std::move(bars)},
                        .height_px = histogram.height_px,
                        .vertical = histogram.vertical}},
            .width_px = histogram.width_px};
}

}  // namespace myo::chart
