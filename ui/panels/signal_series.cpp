#include "panels/signal_series.hpp"

#include "plot/plot.hpp"

namespace myo::ui::panels {

chart::Series signal_series(const std::string& name, const fibre::Signal& signal, const chart::Range& span,
                            const ImVec4& color, double per_unit) {
    std::vector<double> x = signal.times_s, y = signal.values;
    if (span.lowest < x.front()) x.insert(x.begin(), span.lowest), y.insert(y.begin(), y.front());
    if (span.highest > x.back()) x.push_back(span.highest), y.push_back(y.back());
    const auto count = static_cast<Eigen::Index>(x.size());
    return plot::plot_series(name, Eigen::Map<const Eigen::VectorXd>(x.data(), count),
                             Eigen::Map<const Eigen::VectorXd>(y.data(), count) / per_unit, color);
}

}  // namespace myo::ui::panels
